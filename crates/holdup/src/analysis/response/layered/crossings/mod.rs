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
use in_layer::roots_in_layer;
use parts::{PARTS, Parts, begin, bounds_in_layer};

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
    let e = stretch.deviation;
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
    let over = begin(from) * theta.largest();
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

/// The root of these loops that is in the bracket.
#[inline(always)]
pub(super) fn root<V: Lanes>(stretch: &Stretch<'_, V>, terms: usize, of: Set, bracket: &Bracket<V>) -> V {
    let e = stretch.deviation;
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
