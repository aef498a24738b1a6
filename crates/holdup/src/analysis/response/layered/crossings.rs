//! How often the errors of several loops cross zero on a stretch, proven, and where.
//!
//! While a layer lasts, the error times e^θ is a power series whose coefficients of θ^j/j! are `t_j = q_j + Σ C(j, i)·S_i`, with
//! the derivatives S_i of the smooth part by θ at the start. By Descartes' rule it has at most as many positive roots as the
//! t_j have sign changes. What comes after the layer is a polynomial, whose values at some points and a bound on its second
//! derivative decide.

use super::super::legendre::TERMS;
use super::lanes::{Lanes, lane_by_lane};
use super::propagate::Stretch;
use super::signals::Signals;
use super::squares::dot;
use super::tables::{EDGES, INVERSE, TABLES};

/// Parts into which the polynomial is cut, and where they begin and end in units of one.
const PARTS: usize = 8;
const STEPS: [f64; PARTS + 1] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0];

/// Coefficients after which it is asked again whether there can be another change of sign.
const BLOCK: usize = 16;
const BLOCK_LENGTH: f64 = 16.0;

/// What is known of the roots of the errors.
pub(super) struct Crossings<const L: usize> {
    /// Number of roots of each loop, 0 or 1 where it is decided.
    pub(super) roots: [Option<usize>; L],
    /// Where the only root is, in s, and the values of the error there.
    pub(super) bracket: (Lanes<L>, Lanes<L>),
    pub(super) values: (Lanes<L>, Lanes<L>),
}

/// The crossings of the loops that are `open`. `layer_end` is the value of the layers at the end of the stretch, `size` that
/// of them, of which what is below `floor` does not count.
#[inline(always)]
pub(super) fn crossings<const L: usize>(
    stretch: &Stretch<'_, L>,
    open: [bool; L],
    layer_end: Lanes<L>,
    (size, floor): (Lanes<L>, Lanes<L>),
) -> Crossings<L> {
    let e = stretch.error;
    let theta = stretch.rate * stretch.length;
    let slopes = Slopes::new(e, stretch.terms);
    let (start, end) = e.smooth_ends();
    let end = end + layer_end;
    let first = if stretch.terms > 0 { start + e.layer[0] } else { start };
    let ends = (Lanes::all(-1.0), Lanes::all(1.0));
    let mut found = Crossings { roots: [None; L], bracket: ends, values: (first, end) };
    let mut undecided = open;
    let mut layered = false;
    for l in 0..L {
        let monotone = slopes.smooth.0[l] - 0.5 * theta.0[l] * slopes.layer.0[l] > 0.0;
        if undecided[l] && monotone {
            found.roots[l] = Some(usize::from((first.0[l] < 0.0) != (end.0[l] < 0.0)));
            undecided[l] = false;
        }
        layered |= undecided[l] && size.0[l] > floor.0[l];
    }
    if undecided == [false; L] {
        return found;
    }
    // From here on the layers do not count.
    let over = if layered { layers_over(stretch, undecided, floor) } else { 0.0 };
    let mut from = Lanes::all(-1.0);
    let mut before = [Some(0); L];
    if over > 0.0 {
        if over >= theta.smallest() {
            let most = roots_in_layer(stretch, theta.largest());
            for l in 0..L {
                let crossed = usize::from((first.0[l] < 0.0) != (end.0[l] < 0.0));
                // With at most one root it is there exactly when the sign has changed.
                if undecided[l] && most[l].is_some_and(|most| most <= 1 && most >= crossed) {
                    found.roots[l] = Some(crossed);
                }
            }
            return found;
        }
        from = Lanes::all(2.0 * over) / theta - Lanes::all(1.0);
        let mut close = false;
        for l in 0..L {
            let travel = slopes.smooth_size.0[l] * (from.0[l] + 1.0);
            if start.0[l].abs() <= travel + size.0[l] {
                before[l] = None;
                close |= undecided[l];
            }
        }
        if close {
            before = roots_in_layer(stretch, over);
        }
    }
    let nodes = Nodes::new(e, from, slopes.bend);
    for l in 0..L {
        if !undecided[l] {
            continue;
        }
        let middle = nodes.values[0].0[l];
        let inside = before[l].filter(|most| *most <= 1);
        let crossed = usize::from(over > 0.0 && (first.0[l] < 0.0) != (middle < 0.0));
        // With at most one root it is there exactly when the sign has changed.
        let Some(_) = inside.filter(|most| *most >= crossed) else { continue };
        match (crossed, nodes.roots(l)) {
            (0, Some((roots, part))) => {
                found.roots[l] = Some(roots);
                if roots == 1 {
                    let step = (1.0 - from.0[l]) / STEPS[PARTS];
                    found.bracket.0.0[l] = from.0[l] + step * STEPS[part];
                    found.bracket.1.0[l] = from.0[l] + step * STEPS[part + 1];
                    found.values.0.0[l] = nodes.values[part].0[l];
                    found.values.1.0[l] = nodes.values[part + 1].0[l];
                }
            }
            (1, Some((0, _))) => {
                found.roots[l] = Some(1);
                found.bracket.1.0[l] = from.0[l];
                found.values.1.0[l] = middle;
            }
            _ => {}
        }
    }
    found
}

/// Bounds on derivatives by s.
struct Slopes<const L: usize> {
    /// On that of the smooth part from below, negative where of no use, and from above.
    smooth: Lanes<L>,
    smooth_size: Lanes<L>,
    /// On that of the layer by θ from above.
    layer: Lanes<L>,
    /// On the second derivative of the smooth part from above.
    bend: Lanes<L>,
}

impl<const L: usize> Slopes<L> {
    #[inline(always)]
    fn new(e: &Signals<L>, terms: usize) -> Self {
        let (mut others, mut bend) = (Lanes::ZERO, Lanes::ZERO);
        let mut index = 2.0;
        for c in e.smooth[..e.order].iter().skip(2) {
            lane_by_lane::<L>();
            others += c.abs() * index;
            bend += c.abs() * (index * (index - 1.0));
            index += 1.0;
        }
        let first = if e.order > 1 { e.smooth[1].abs() } else { Lanes::ZERO };
        let mut layer = Lanes::ZERO;
        for (j, q) in e.layer[..terms].iter().enumerate() {
            lane_by_lane::<L>();
            let next = if j + 1 < terms { e.layer[j + 1] } else { Lanes::ZERO };
            layer += (next - *q).abs();
        }
        Self { smooth: first - others * (1.0 + 1e-14), smooth_size: first + others, layer, bend }
    }
}

/// From here on, on the layers' axis, those of the loops in question are below `floor`.
#[inline(always)]
fn layers_over<const L: usize>(stretch: &Stretch<'_, L>, of: [bool; L], floor: Lanes<L>) -> f64 {
    let layer = &stretch.error.layer[..stretch.terms];
    for (edge, bounds) in EDGES.iter().zip(&TABLES.bounds).skip(1) {
        let mut bound = Lanes::ZERO;
        for (q, weight) in layer.iter().zip(bounds) {
            lane_by_lane::<L>();
            bound += q.abs() * *weight;
        }
        if (0..L).all(|l| !of[l] || bound.0[l] <= floor.0[l]) {
            return *edge;
        }
    }
    f64::INFINITY
}

/// A bound on the number of roots up to `over`: the sign changes of the t_j, as far as these matter before `over`; `None` where
/// rounding may hide one.
#[inline(always)]
fn roots_in_layer<const L: usize>(stretch: &Stretch<'_, L>, over: f64) -> [Option<usize>; L] {
    let e = stretch.error;
    let per_theta = Lanes::all(2.0) / (stretch.rate * stretch.length);
    let mut differences = [Lanes::ZERO; TERMS];
    let mut scale = Lanes::all(1.0);
    let (mut power, mut used) = (1.0, 0);
    let mut largest = Lanes::ZERO;
    for i in 0..e.order {
        differences[i] = scale * dot(&e.smooth[i..e.order], &TABLES.at_start[i][i..]);
        used = i + 1;
        let size = differences[i].abs() * power;
        largest = largest.max(size);
        // The terms fall from here on: what is left does not count before `over`.
        if i > 2 && size.every(largest, |size, largest| size <= 1e-14 * largest) {
            break;
        }
        scale = scale * per_theta;
        power *= over * INVERSE[i + 1];
    }
    let mut signs = Changes::new(differences[0].abs());
    let differences = &mut differences[..used];
    for q in &e.layer[..stretch.terms] {
        signs.next(*q, differences);
    }
    // Beyond the layer's terms there is the polynomial alone. Coefficients are means of what is near θ = j: ten widths past
    // the end of the layer they are nothing within it.
    #[expect(clippy::cast_precision_loss, reason = "at most 64")]
    let mut beyond = over + 10.0 * over.sqrt() + 10.0 - stretch.terms as f64;
    while beyond > 0.0 {
        let (mut others, mut power, mut order) = (Lanes::ZERO, 1.0, 0.0);
        for difference in &differences[1..] {
            order += 1.0;
            power *= beyond / order;
            others += difference.abs() * power;
        }
        let steady = others.every(differences[0].abs(), |others, first| others < first);
        for _ in 0..if steady { 1 } else { BLOCK } {
            signs.next(Lanes::ZERO, differences);
        }
        beyond = if steady { 0.0 } else { beyond - BLOCK_LENGTH };
    }
    let mut most = [None; L];
    for l in 0..L {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small count")]
        let changes = signs.count.0[l] as usize;
        most[l] = (signs.least.0[l] > 0.0).then_some(changes);
    }
    most
}

/// Counts sign changes.
struct Changes<const L: usize> {
    /// Size below which, times 1e-13, a number may have either sign.
    size: Lanes<L>,
    before: Lanes<L>,
    count: Lanes<L>,
    /// Not positive once a sign was not certain.
    least: Lanes<L>,
}

impl<const L: usize> Changes<L> {
    #[inline(always)]
    fn new(size: Lanes<L>) -> Self {
        Self { size, before: Lanes::ZERO, count: Lanes::ZERO, least: Lanes::all(f64::INFINITY) }
    }

    /// The next number is `own` plus the value of the polynomial with these differences, which moves on.
    #[inline(always)]
    fn next(&mut self, own: Lanes<L>, differences: &mut [Lanes<L>]) {
        let t = own + differences[0];
        self.least = self.least.min(t.abs() - (own.abs() + self.size) * 1e-13);
        self.count += (t * self.before).map(|product| if product < 0.0 { 1.0 } else { 0.0 });
        self.before = t.map(|t| 1f64.copysign(t));
        for i in 1..differences.len() {
            lane_by_lane::<L>();
            let next = differences[i];
            differences[i - 1] += next;
        }
    }
}

/// Values of a polynomial between `from` and 1, and a bound on how far it is from the chords between them.
struct Nodes<const L: usize> {
    values: [Lanes<L>; PARTS + 1],
    slopes: [Lanes<L>; PARTS + 1],
    /// Length of a part times the bound on the second derivative.
    turn: Lanes<L>,
    /// Largest distance from a chord.
    sag: Lanes<L>,
}

impl<const L: usize> Nodes<L> {
    #[inline(always)]
    fn new(e: &Signals<L>, from: Lanes<L>, bend: Lanes<L>) -> Self {
        let step = (Lanes::all(1.0) - from) * (1.0 / STEPS[PARTS]);
        let (mut values, mut slopes) = ([Lanes::ZERO; PARTS + 1], [Lanes::ZERO; PARTS + 1]);
        for k in 0..=PARTS {
            let s = from + step * STEPS[k];
            let (mut value, mut slope) = (Lanes::ZERO, Lanes::ZERO);
            for c in e.smooth[..e.order].iter().rev() {
                lane_by_lane::<L>();
                slope = slope * s + value;
                value = value * s + *c;
            }
            (values[k], slopes[k]) = (value, slope);
        }
        Self { values, slopes, turn: step * bend, sag: step * step * bend * 0.126 }
    }

    /// The number of roots of loop `l` if it is decided and at most 1, and the part in which that one is.
    #[inline(always)]
    fn roots(&self, l: usize) -> Option<(usize, usize)> {
        let mut found = None;
        let sag = self.sag.0[l];
        for k in 0..PARTS {
            let (a, b) = (self.values[k].0[l], self.values[k + 1].0[l]);
            let steep = self.slopes[k].0[l].abs().max(self.slopes[k + 1].0[l].abs()) > self.turn.0[l];
            if (a < 0.0) == (b < 0.0) {
                if a.abs().min(b.abs()) <= sag && !steep {
                    return None;
                }
            } else if !steep || found.is_some() {
                return None;
            } else {
                found = Some(k);
            }
        }
        Some(found.map_or((0, 0), |part| (1, part)))
    }
}

/// The only root of the errors that cross zero once.
#[inline(always)]
pub(super) fn only_root<const L: usize>(
    stretch: &Stretch<'_, L>,
    terms: usize,
    found: &Crossings<L>,
) -> Lanes<L> {
    let e = stretch.error;
    let half_theta = stretch.rate * stretch.length * 0.5;
    let (mut low, mut high) = found.bracket;
    let (start, end) = found.values;
    let mut s = low - start * (high - low) / (end - start);
    let mut done = found.roots.map(|roots| roots != Some(1));
    for l in 0..L {
        if done[l] {
            s.0[l] = 0.0;
        }
    }
    let layer = &e.layer[..terms];
    for _ in 0..100 {
        for l in 0..L {
            let inside = s.0[l] > low.0[l] && s.0[l] < high.0[l];
            if !inside && !done[l] {
                s.0[l] = 0.5 * (low.0[l] + high.0[l]);
            }
        }
        let (mut value, mut slope) = (Lanes::ZERO, Lanes::ZERO);
        for c in e.smooth[..e.order].iter().rev() {
            lane_by_lane::<L>();
            slope = slope * s + value;
            value = value * s + *c;
        }
        if terms > 0 {
            let theta = (half_theta * (s + Lanes::all(1.0))).map(|theta| theta.clamp(0.0, 700.0));
            let (mut sum, mut rise, mut next) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
            for (j, q) in layer.iter().enumerate().rev() {
                lane_by_lane::<L>();
                sum = sum * theta * INVERSE[j + 1] + *q;
                rise = rise * theta * INVERSE[j + 1] + (next - *q);
                next = *q;
            }
            let decayed = theta.map(|theta| (-theta).exp());
            value += sum * decayed;
            slope += half_theta * rise * decayed;
        }
        let mut all = true;
        for l in 0..L {
            if done[l] {
                continue;
            }
            if (value.0[l] < 0.0) == (start.0[l] < 0.0) {
                low.0[l] = s.0[l];
            } else {
                high.0[l] = s.0[l];
            }
            let next = s.0[l] - value.0[l] / slope.0[l];
            // The error of an integral is of second order in that of the root, and Newton squares the latter: 1e-9
            // becomes rounding. A short step out of the bracket leads to another root, not to the one that is inside.
            let inside = next >= low.0[l] && next <= high.0[l];
            if (inside && (next - s.0[l]).abs() < 1e-9) || high.0[l] - low.0[l] < 1e-12 {
                s.0[l] = next.clamp(low.0[l], high.0[l]);
                done[l] = true;
            } else {
                s.0[l] = next;
                all = false;
            }
        }
        if all {
            break;
        }
    }
    s
}
