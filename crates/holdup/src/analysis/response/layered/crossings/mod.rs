//! How often the errors of several loops cross zero on a stretch, proven, and where.
//!
//! The stretch is cut into parts. The smooth part of the error with two derivatives at their ends, a bound on the fourth one and
//! bounds on the layer from each part on decide most of them. Where the layer is strong, the error times e^θ is a power series whose
//! coefficients of θ^j/j! are `t_j = q_j + Σ C(j, i)·S_i`, with the derivatives S_i of the smooth part by θ at the start. By
//! Descartes' rule it has at most as many positive roots as the t_j have sign changes.

mod in_layer;
mod parts;

use super::lanes::{Lanes, Set};
use super::propagate::Stretch;
use super::signal::LAYER_TERMS;
use super::signals::Signals;
use super::tables::INVERSE;
use in_layer::changes_in_layer;
use parts::{PARTS, Parts, begin, bounds_in_layer};

/// A root: it is between these points, where the error has values of these signs.
#[derive(Clone, Copy)]
struct Bracket<V> {
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

/// Most roots of one error on one stretch.
pub(super) const MOST_ROOTS: usize = 3;

/// Roots in their order, each with the loops that have it.
#[derive(Clone, Copy)]
pub(super) struct Roots<V> {
    /// Loops with at least 1, 2, … of them, and at last those with too many.
    at_least: [Set; MOST_ROOTS + 1],
    brackets: [Bracket<V>; MOST_ROOTS],
}

impl<V: Lanes> Roots<V> {
    #[inline(always)]
    fn new(whole: Bracket<V>) -> Self {
        Self { at_least: [Set::NONE; MOST_ROOTS + 1], brackets: [whole; MOST_ROOTS] }
    }

    /// Adds the next root of these loops.
    #[inline(always)]
    fn push(&mut self, of: Set, bracket: Bracket<V>) {
        let mut of = of;
        for k in 0..=MOST_ROOTS {
            let here = of & !self.at_least[k];
            if k < MOST_ROOTS && here != Set::NONE {
                self.brackets[k] = bracket.only_in(here, self.brackets[k]);
            }
            self.at_least[k] = self.at_least[k] | here;
            of = of & !here;
        }
    }

    /// Adds the roots that others have for these loops.
    #[inline(always)]
    fn extend(&mut self, of: Set, others: &Self) {
        for k in 0..MOST_ROOTS {
            self.push(of & others.at_least[k], others.brackets[k]);
        }
    }

    /// Loops with the root of this number.
    #[inline(always)]
    pub(super) fn with(&self, number: usize) -> Set {
        self.at_least[number]
    }

    /// The root of this number of the loops that have it.
    #[inline(always)]
    pub(super) fn root(&self, stretch: &Stretch<'_, V>, terms: usize, number: usize) -> V {
        root(stretch, terms, self.at_least[number], &self.brackets[number])
    }
}

/// What is known of the roots of the errors.
pub(super) struct Crossings<V> {
    /// Loops all of whose roots are found.
    pub(super) known: Set,
    pub(super) roots: Roots<V>,
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
    let e = stretch.deviation;
    let theta = stretch.rate * stretch.length;
    let slopes = Slopes::new(e, stretch.terms);
    let (start, end) = e.smooth_ends();
    let end = end + layer_end;
    let first = if stretch.terms > 0 { start + e.layer[0] } else { start };
    let whole = Bracket { ends: (theta.like(-1.0), theta.like(1.0)), values: (first, end) };
    let monotone = open & (theta * slopes.layer * 0.5).below(slopes.smooth);
    let undecided = open & !monotone;
    let mut found = Crossings { known: monotone, roots: Roots::new(whole) };
    found.roots.push(monotone & apart(first, end), whole);
    if undecided == Set::NONE {
        return found;
    }
    let parts = Parts::new(stretch, slopes.fourth, (undecided, floor));
    // The first part from which on everything is decided, for each loop; what is before it goes to Descartes.
    let open = (0..PARTS).fold(Set::NONE, |open, k| open | parts.open[k]) & undecided;
    found.add_parts(&parts, 0, undecided & !open);
    if open == Set::NONE || stretch.terms == 0 {
        return found;
    }
    let from = (0..PARTS).rposition(|k| parts.open[k] & open != Set::NONE).map_or(0, |last| last + 1);
    let over = begin(from) * theta.largest();
    let until = if from < PARTS { (parts.at(from), parts.values[from]) } else { (whole.ends.1, end) };
    let (early, decided) =
        early(stretch, over, open, Bracket { ends: (whole.ends.0, until.0), values: (first, until.1) });
    found.roots.extend(decided, &early);
    found.add_parts(&parts, from, decided);
    found
}

/// The roots of these loops before the end of the bracket, where their layers are strong, and the loops for which these are all.
#[inline(always)]
fn early<V: Lanes>(stretch: &Stretch<'_, V>, over: f64, open: Set, bracket: Bracket<V>) -> (Roots<V>, Set) {
    let at_most = changes_in_layer(stretch, over);
    let mut roots = Roots::new(bracket);
    // With at most one root it is there exactly when the sign has changed.
    let crossed = apart(bracket.values.0, bracket.values.1);
    let decided = open & at_most[1] & !(at_most[0] & crossed);
    roots.push(decided & crossed, bracket);
    let several = open & at_most[MOST_ROOTS] & !at_most[1];
    if several == Set::NONE {
        return (roots, decided);
    }
    // As many roots as there can be, each between two points.
    let reach = bracket.ends.1 - bracket.ends.0;
    let mut before = (bracket.ends.0, bracket.values.0);
    for part in POINTS {
        let at = reach.scaled_plus(part, bracket.ends.0);
        let here = if part < 1.0 { (at, values(stretch, at)) } else { (bracket.ends.1, bracket.values.1) };
        let between = Bracket { ends: (before.0, here.0), values: (before.1, here.1) };
        roots.push(several & apart(before.1, here.1), between);
        before = here;
    }
    let all = (1..MOST_ROOTS).fold(Set::NONE, |all, k| all | roots.at_least[k] & at_most[k + 1]);
    (roots, decided | several & all & !roots.at_least[MOST_ROOTS])
}

/// Where several early roots are looked for, as parts of the stretch of time that they are in: densest where layers begin.
const POINTS: [f64; 12] = [0.02, 0.04, 0.08, 0.13, 0.19, 0.26, 0.34, 0.43, 0.53, 0.65, 0.8, 1.0];

impl<V: Lanes> Crossings<V> {
    /// Adds loops whose roots are decided: those in the parts from number `from` on.
    #[inline(always)]
    fn add_parts(&mut self, parts: &Parts<V>, from: usize, of: Set) {
        for k in from..PARTS {
            let changed = of & parts.changed[k];
            if changed == Set::NONE {
                continue;
            }
            let ends = (parts.at(k), parts.at(k + 1));
            self.roots.push(changed, Bracket { ends, values: (parts.values[k], parts.values[k + 1]) });
        }
        self.known = self.known | of & !self.roots.at_least[MOST_ROOTS];
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

/// The values of the errors at these points.
#[inline(always)]
fn values<V: Lanes>(stretch: &Stretch<'_, V>, s: V) -> V {
    let half_theta = stretch.rate * stretch.length * 0.5;
    value_and_slope(stretch.deviation, stretch.terms, half_theta, s).0
}

/// Value and derivative by s.
#[inline(always)]
fn value_and_slope<V: Lanes>(e: &Signals<V>, terms: usize, half_theta: V, s: V) -> (V, V) {
    let zero = s.like(0.0);
    let (mut value, mut slope) = (zero, zero);
    for c in e.smooth[..e.order].iter().rev() {
        slope = slope.times_plus(s, value);
        value = value.times_plus(s, *c);
    }
    if terms > 0 {
        let theta = (half_theta * (s + zero.like(1.0))).max(zero).min(zero.like(700.0));
        let (mut sum, mut rise, mut next) = (zero, zero, zero);
        for (j, q) in e.layer[..terms].iter().enumerate().rev() {
            sum = (sum * theta).scaled_plus(INVERSE[j + 1], *q);
            rise = (rise * theta).scaled_plus(INVERSE[j + 1], next - *q);
            next = *q;
        }
        let decayed = theta.decayed();
        value = sum.times_plus(decayed, value);
        slope += half_theta * rise * decayed;
    }
    (value, slope)
}

/// The root of these loops that is in the bracket.
#[inline(always)]
fn root<V: Lanes>(stretch: &Stretch<'_, V>, terms: usize, of: Set, bracket: &Bracket<V>) -> V {
    let e = stretch.deviation;
    let zero = stretch.length.like(0.0);
    let half_theta = stretch.rate * stretch.length * 0.5;
    let (mut low, mut high) = bracket.ends;
    let (start, end) = bracket.values;
    let mut s = (low - start * (high - low) / (end - start)).only_in(of, zero);
    let mut left = of;
    for _ in 0..100 {
        let inside = low.below(s) & s.below(high);
        s = ((low + high) * 0.5).only_in(left & !inside, s);
        let (value, slope) = value_and_slope(e, terms, half_theta, s);
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
