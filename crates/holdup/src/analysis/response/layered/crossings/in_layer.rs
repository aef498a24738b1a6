//! How often the error crosses zero while its layer is strong.

use super::super::super::legendre::TERMS;
use super::super::lanes::{Lanes, Set};
use super::super::propagate::Stretch;
use super::super::signals::BLOCK;
use super::super::squares::dot;
use super::super::tables::{INVERSE, TABLES};

/// Coefficients after which it is asked again whether there can be another change of sign.
const RUN: usize = 16;
const RUN_LENGTH: f64 = 16.0;

/// Loops with at most one root up to `over`, and with none: as many as the t_j change their sign, as far as these matter
/// before `over`, where no rounding may hide a change.
#[inline(always)]
pub(super) fn roots_in_layer<V: Lanes>(stretch: &Stretch<'_, V>, over: f64) -> (Set, Set) {
    let e = stretch.deviation;
    let zero = stretch.length.like(0.0);
    let per_theta = zero.like(2.0) / (stretch.rate * stretch.length);
    let mut differences = [zero; TERMS];
    let mut scale = zero.like(1.0);
    let (mut power, mut used) = (1.0, 0);
    let mut largest = zero;
    for i in 0..e.order {
        let from = i / BLOCK * BLOCK;
        differences[i] = scale * dot(&e.smooth_blocks()[from..], &TABLES.at_start[i][from..], zero);
        used = i + 1;
        let size = differences[i].abs() * power;
        largest = largest.max(size);
        // The terms fall from here on: what is left does not count before `over`.
        if i > 2 && size.all_at_most(largest * 1e-14) {
            break;
        }
        scale = scale * per_theta;
        power *= over * INVERSE[i + 1];
    }
    let mut signs = Changes::new(differences[0]);
    let differences = &mut differences[..used];
    for q in &e.layer[..stretch.terms] {
        signs.next(*q, differences);
    }
    // Beyond the layer's terms there is the polynomial alone. Coefficients are means of what is near θ = j: ten widths past
    // the end of the layer they are nothing within it.
    #[expect(clippy::cast_precision_loss, reason = "at most 64")]
    let mut beyond = over + 10.0 * over.sqrt() + 10.0 - stretch.terms as f64;
    while beyond > 0.0 {
        let (mut others, mut power, mut order) = (zero, 1.0, 0.0);
        for difference in &differences[1..] {
            order += 1.0;
            power *= beyond / order;
            others = difference.abs().scaled_plus(power, others);
        }
        let steady = others.below(differences[0].abs()) == V::every();
        for _ in 0..if steady { 1 } else { RUN } {
            signs.next(zero, differences);
        }
        beyond = if steady { 0.0 } else { beyond - RUN_LENGTH };
    }
    let certain = zero.below(signs.least);
    (certain & !signs.twice, certain & !signs.once)
}

/// Counts sign changes up to two.
struct Changes<V> {
    /// Size below which, times 1e-13, a number may have either sign.
    size: V,
    negative: Option<Set>,
    once: Set,
    twice: Set,
    /// Not positive once a sign was not certain.
    least: V,
}

impl<V: Lanes> Changes<V> {
    #[inline(always)]
    fn new(first: V) -> Self {
        let least = first.like(f64::INFINITY);
        Self { size: first.abs(), negative: None, once: Set::NONE, twice: Set::NONE, least }
    }

    /// The next number is `own` plus the value of the polynomial with these differences, which moves on.
    #[inline(always)]
    fn next(&mut self, own: V, differences: &mut [V]) {
        let t = own + differences[0];
        self.least = self.least.min((own.abs() + self.size).scaled_plus(-1e-13, t.abs()));
        let negative = t.below(t.like(0.0));
        let before = self.negative.unwrap_or(negative);
        let changed = negative & !before | before & !negative;
        self.twice = self.twice | self.once & changed;
        self.once = self.once | changed;
        self.negative = Some(negative);
        for i in 1..differences.len() {
            let next = differences[i];
            differences[i - 1] += next;
        }
    }
}
