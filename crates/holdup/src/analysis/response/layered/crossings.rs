//! How often the errors of several loops cross zero on a stretch, proven, and where.
//!
//! The stretch is cut into parts. The smooth part of the error and its derivatives at their ends, a bound on the fourth and bounds on the
//! layer from each part on decide most of them. Where the layer is strong, the error times e^θ is a power series whose
//! coefficients of θ^j/j! are `t_j = q_j + Σ C(j, i)·S_i`, with the derivatives S_i of the smooth part by θ at the start. By
//! Descartes' rule it has at most as many positive roots as the t_j have sign changes.

use super::super::legendre::TERMS;
use super::lanes::{Lanes, Set};
use super::propagate::Stretch;
use super::signal::LAYER_TERMS;
use super::signals::Signals;
use super::squares::dot;
use super::tables::{EDGES, INVERSE, TABLES};

/// Parts into which a stretch is cut, and where they begin and end in units of one.
const PARTS: usize = 8;
const STEPS: [f64; PARTS + 1] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0];

/// Coefficients after which it is asked again whether there can be another change of sign.
const BLOCK: usize = 16;
const BLOCK_LENGTH: f64 = 16.0;

/// A root: it is between these points, where the error has values of these signs.
#[derive(Clone, Copy)]
pub(super) struct Bracket<V> {
    ends: (V, V),
    values: (V, V),
}

impl<V: Lanes> Bracket<V> {
    #[inline(always)]
    fn only_in(self, loops: Set, other: Self) -> Self {
        let pair = |a: (V, V), b: (V, V)| (a.0.only_in(loops, b.0), a.1.only_in(loops, b.1));
        Self { ends: pair(self.ends, other.ends), values: pair(self.values, other.values) }
    }
}

/// What is known of the roots of the errors.
pub(super) struct Crossings<V> {
    /// Loops with no root, with one, and with two.
    pub(super) none: Set,
    pub(super) one: Set,
    pub(super) two: Set,
    /// The first and the second root.
    pub(super) roots: [Bracket<V>; 2],
}

/// Where two numbers differ in sign.
#[inline(always)]
fn apart<V: Lanes>(a: V, b: V) -> Set {
    let zero = a.like(0.0);
    let (a, b) = (a.below(zero), b.below(zero));
    a & !b | b & !a
}

/// The crossings of the loops that are `open`. `layer_end` is the value of the layers at the end of the stretch; what is below
/// `floor` does not count.
#[inline(always)]
pub(super) fn crossings<V: Lanes>(
    stretch: &Stretch<'_, V>,
    open: Set,
    layer_end: V,
    floor: V,
) -> Crossings<V> {
    let e = stretch.error;
    let theta = stretch.rate * stretch.length;
    let slopes = Slopes::new(e, stretch.terms);
    let (start, end) = e.smooth_ends();
    let end = end + layer_end;
    let first = if stretch.terms > 0 { start + e.layer[0] } else { start };
    let whole = Bracket { ends: (theta.like(-1.0), theta.like(1.0)), values: (first, end) };
    let crossed = apart(first, end);
    let monotone = open & (theta * slopes.layer * 0.5).below(slopes.smooth);
    let undecided = open & !monotone;
    let (none, one) = (monotone & !crossed, monotone & crossed);
    let mut found = Crossings { none, one, two: Set::NONE, roots: [whole; 2] };
    if undecided == Set::NONE {
        return found;
    }
    let parts = Parts::new(stretch, slopes.fourth, (undecided, floor));
    // The first part from which on everything is decided, for each loop; what is before it goes to Descartes.
    let open = (0..PARTS).fold(Set::NONE, |open, k| open | parts.open[k]) & undecided;
    found.add(&parts, 0, undecided & !open, (Set::NONE, whole));
    if open == Set::NONE || stretch.terms == 0 {
        return found;
    }
    let from = (0..PARTS).rposition(|k| parts.open[k] & open != Set::NONE).map_or(0, |last| last + 1);
    let over = theta.largest() * STEPS[from] / STEPS[PARTS];
    let (at_most_one, none) = roots_in_layer(stretch, over);
    let (until, value) =
        if from < PARTS { (parts.at(from), parts.values[from]) } else { (whole.ends.1, end) };
    // With at most one root it is there exactly when the sign has changed.
    let crossed = apart(first, value);
    let decided = open & at_most_one & (!none | !crossed);
    let early = Bracket { ends: (whole.ends.0, until), values: (first, value) };
    found.add(&parts, from, decided, (crossed, early));
    found
}

impl<V: Lanes> Crossings<V> {
    /// Adds loops whose roots are decided: those in the parts from number `from` on, and one before them where `early`.
    #[inline(always)]
    fn add(&mut self, parts: &Parts<V>, from: usize, of: Set, (early, bracket): (Set, Bracket<V>)) {
        let (mut once, mut twice, mut more) = (of & early, Set::NONE, Set::NONE);
        self.roots[0] = bracket.only_in(once, self.roots[0]);
        for k in from..PARTS {
            let changed = of & parts.changed[k];
            if changed == Set::NONE {
                continue;
            }
            let here = Bracket {
                ends: (parts.at(k), parts.at(k + 1)),
                values: (parts.values[k], parts.values[k + 1]),
            };
            self.roots[0] = here.only_in(changed & !once, self.roots[0]);
            self.roots[1] = here.only_in(changed & once & !twice, self.roots[1]);
            more = more | changed & twice;
            twice = twice | changed & once;
            once = once | changed;
        }
        self.none = self.none | of & !once;
        self.one = self.one | once & !twice;
        self.two = self.two | twice & !more;
    }
}

/// Bounds on derivatives by s.
struct Slopes<V> {
    /// On that of the smooth part from below, negative where of no use.
    smooth: V,
    /// On that of the layer by θ from above.
    layer: V,
    /// On the fourth derivative of the smooth part from above.
    fourth: V,
}

impl<V: Lanes> Slopes<V> {
    #[inline(always)]
    fn new(e: &Signals<V>, terms: usize) -> Self {
        let zero = e.smooth[0].like(0.0);
        let (mut others, mut fourth) = (zero, zero);
        let mut index = 2.0;
        for c in e.smooth[..e.order].iter().skip(2) {
            others = c.abs().scaled_plus(index, others);
            fourth = c.abs().scaled_plus(index * (index - 1.0) * (index - 2.0) * (index - 3.0), fourth);
            index += 1.0;
        }
        let first = if e.order > 1 { e.smooth[1].abs() } else { zero };
        let layer = bounds_in_layer(&e.layer[..terms], &[1.0; LAYER_TERMS], zero).0;
        Self { smooth: first - others * (1.0 + 1e-14), layer, fourth }
    }
}

/// The error between points at equal distances.
struct Parts<V> {
    /// Values of the smooth part at these points.
    values: [V; PARTS + 1],
    /// Length of a part.
    step: V,
    /// Loops for which a part has one root, and those for which it is not decided.
    changed: [Set; PARTS],
    open: [Set; PARTS],
}

impl<V: Lanes> Parts<V> {
    /// `fourth` is a bound on the fourth derivative of the smooth part by s.
    #[inline(always)]
    fn new(stretch: &Stretch<'_, V>, fourth: V, (of, floor): (Set, V)) -> Self {
        let e = stretch.error;
        let zero = fourth.like(0.0);
        let step = zero.like(2.0 / STEPS[PARTS]);
        let mut values = [zero; PARTS + 1];
        let (mut slopes, mut bends) = (values, values);
        for k in 0..=PARTS {
            let s = step.scaled_plus(STEPS[k], zero.like(-1.0));
            let (mut value, mut slope, mut half) = (zero, zero, zero);
            for c in e.smooth[..e.order].iter().rev() {
                half = half.times_plus(s, slope);
                slope = slope.times_plus(s, value);
                value = value.times_plus(s, *c);
            }
            (values[k], slopes[k], bends[k]) = (value, slope, half.abs() * 2.0);
        }
        // How far the second derivative may be from its chord.
        let bulge = step * step * fourth * 0.126;
        let theta = stretch.rate * stretch.length;
        let (shortest, by_s) = (theta.smallest() / STEPS[PARTS], theta * 0.5);
        let mut decayed = stretch.terms == 0;
        let (mut layer, mut layer_slope) = (zero, zero);
        let mut new = Self { values, step, changed: [Set::NONE; PARTS], open: [Set::NONE; PARTS] };
        for k in 0..PARTS {
            if !decayed {
                let edge = EDGES.iter().rposition(|edge| *edge <= shortest * STEPS[k]).unwrap_or(0);
                let own = &e.layer[..stretch.terms];
                (layer_slope, layer) = bounds_in_layer(own, &TABLES.bounds[edge], zero);
                layer_slope = layer_slope * by_s;
                decayed = of & !(layer.at_most(floor) & layer_slope.at_most(floor)) == Set::NONE;
                if decayed {
                    (layer, layer_slope) = (zero, zero);
                }
            }
            // Over the part the slope changes by no more than this, and no value is farther from the chord.
            let bend = bends[k].max(bends[k + 1]) + bulge;
            let (turn, sag) = (step * bend, step * step * bend * 0.126);
            let (a, b) = (values[k], values[k + 1]);
            let (least, slope) = (a.abs().min(b.abs()), slopes[k].abs().max(slopes[k + 1].abs()));
            let sure = layer.at_most(least);
            let changed = apart(a, b);
            // The smooth part rises or falls all the way; so does the error.
            let (steep, steeper) = (turn.below(slope), (turn + layer_slope).below(slope));
            let clear = (sag + layer).below(least) | sure & steep;
            new.changed[k] = changed;
            new.open[k] = !changed & !clear | changed & !(sure & steeper);
        }
        new
    }

    /// Where part `k` begins.
    #[inline(always)]
    fn at(&self, k: usize) -> V {
        self.step.scaled_plus(STEPS[k], self.step.like(-1.0))
    }
}

/// Bounds on the derivative of a layer by θ and on the layer, where no `e^(−θ)·θ^j/j!` exceeds these bounds.
#[inline(always)]
fn bounds_in_layer<V: Lanes>(layer: &[V], bounds: &[f64], zero: V) -> (V, V) {
    let (mut slope, mut size) = (zero, zero);
    let mut before = zero;
    for (q, bound) in layer.iter().zip(bounds).rev() {
        slope = (before - *q).abs().scaled_plus(*bound, slope);
        size = q.abs().scaled_plus(*bound, size);
        before = *q;
    }
    (slope, size)
}

/// Loops with at most one root up to `over`, and with none: as many as the t_j change their sign, as far as these matter
/// before `over`, where no rounding may hide a change.
#[inline(always)]
fn roots_in_layer<V: Lanes>(stretch: &Stretch<'_, V>, over: f64) -> (Set, Set) {
    let e = stretch.error;
    let zero = stretch.length.like(0.0);
    let per_theta = zero.like(2.0) / (stretch.rate * stretch.length);
    let mut differences = [zero; TERMS];
    let mut scale = zero.like(1.0);
    let (mut power, mut used) = (1.0, 0);
    let mut largest = zero;
    for i in 0..e.order {
        differences[i] = scale * dot(&e.smooth[i..e.order], &TABLES.at_start[i][i..], zero);
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
        for _ in 0..if steady { 1 } else { BLOCK } {
            signs.next(zero, differences);
        }
        beyond = if steady { 0.0 } else { beyond - BLOCK_LENGTH };
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

/// The root of these loops that is in the bracket.
#[inline(always)]
pub(super) fn root<V: Lanes>(stretch: &Stretch<'_, V>, terms: usize, of: Set, bracket: &Bracket<V>) -> V {
    let e = stretch.error;
    let zero = stretch.length.like(0.0);
    let half_theta = stretch.rate * stretch.length * 0.5;
    let (mut low, mut high) = bracket.ends;
    let (start, end) = bracket.values;
    let mut s = (low - start * (high - low) / (end - start)).only_in(of, zero);
    let mut left = of;
    let layer = &e.layer[..terms];
    for _ in 0..100 {
        let inside = low.below(s) & s.below(high);
        s = ((low + high) * 0.5).only_in(left & !inside, s);
        let (mut value, mut slope) = (zero, zero);
        for c in e.smooth[..e.order].iter().rev() {
            slope = slope.times_plus(s, value);
            value = value.times_plus(s, *c);
        }
        if terms > 0 {
            let theta = (half_theta * (s + zero.like(1.0))).max(zero).min(zero.like(700.0));
            let (mut sum, mut rise, mut next) = (zero, zero, zero);
            for (j, q) in layer.iter().enumerate().rev() {
                sum = (sum * theta).scaled_plus(INVERSE[j + 1], *q);
                rise = (rise * theta).scaled_plus(INVERSE[j + 1], next - *q);
                next = *q;
            }
            let decayed = theta.decayed();
            value = sum.times_plus(decayed, value);
            slope += half_theta * rise * decayed;
        }
        let after = left & apart(value, start);
        high = s.only_in(after, high);
        low = s.only_in(left & !after, low);
        let next = s - value / slope;
        // The error of an integral is of second order in that of the root, and Newton squares the latter: 1e-9
        // becomes rounding. A short step out of the bracket leads to another root, not to the one that is inside.
        let inside = low.at_most(next) & next.at_most(high);
        let short = (next - s).abs().below(zero.like(1e-9));
        let done = left & (inside & short | (high - low).below(zero.like(1e-12)));
        s = next.max(low).min(high).only_in(done, next.only_in(left, s));
        left = left & !done;
        if left == Set::NONE {
            break;
        }
    }
    s
}
