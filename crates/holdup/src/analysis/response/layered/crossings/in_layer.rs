//! How often the error crosses zero while its layer is strong.

use super::super::super::legendre::TERMS;
use super::super::lanes::{Lanes, Set};
use super::super::propagate::Stretch;
use super::super::signals::BLOCK;
use super::super::squares::dot;
use super::super::tables::{INVERSE, TABLES};
use super::MOST_ROOTS;

/// Coefficients after which it is asked again whether there can be another change of sign.
const RUN: usize = 16;
const RUN_LENGTH: f64 = 16.0;

/// Loops with at most 0, 1, … roots up to `over`: as many as the t_j change their sign, as far as these matter before `over`,
/// where no rounding may hide a change.
#[inline(always)]
pub(super) fn changes_in_layer<V: Lanes>(stretch: &Stretch<'_, V>, over: f64) -> [Set; MOST_ROOTS + 1] {
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
    let mut at_most = [certain; MOST_ROOTS + 1];
    for k in 0..=MOST_ROOTS {
        at_most[k] = certain & !signs.more_than[k];
    }
    at_most
}

/// Counts sign changes.
struct Changes<V> {
    /// Size below which, times 1e-13, a number may have either sign.
    size: V,
    negative: Option<Set>,
    /// Loops with more than 0, 1, … changes.
    more_than: [Set; MOST_ROOTS + 1],
    /// Not positive once a sign was not certain.
    least: V,
}

impl<V: Lanes> Changes<V> {
    #[inline(always)]
    fn new(first: V) -> Self {
        let least = first.like(f64::INFINITY);
        Self { size: first.abs(), negative: None, more_than: [Set::NONE; MOST_ROOTS + 1], least }
    }

    /// The next number is `own` plus the value of the polynomial with these differences, which moves on.
    #[inline(always)]
    fn next(&mut self, own: V, differences: &mut [V]) {
        let t = own + differences[0];
        self.least = self.least.min((own.abs() + self.size).scaled_plus(-1e-13, t.abs()));
        let negative = t.below(t.like(0.0));
        let before = self.negative.unwrap_or(negative);
        let changed = negative & !before | before & !negative;
        if changed != Set::NONE {
            for k in (1..=MOST_ROOTS).rev() {
                self.more_than[k] = self.more_than[k] | self.more_than[k - 1] & changed;
            }
            self.more_than[0] = self.more_than[0] | changed;
        }
        self.negative = Some(negative);
        for i in 1..differences.len() {
            let next = differences[i];
            differences[i - 1] += next;
        }
    }
}
