//! Extrema of a signal with a layer, all of them, without cutting it into polynomials.
//!
//! In the layer the derivative is `e^(−θ)·R(θ) + S(θ)`. Times e^θ it is a power series with the coefficients
//! `t_j = r_j + Σ C(j, i)·S_i` of θ^j/j!, and by Descartes' rule it has at most as many positive roots as the t_j have sign
//! changes, and as many up to an even number. So few evaluations prove the extrema complete; where they do not, the answer
//! is `None`. Coefficients far beyond the end of the layer are nothing within it, so the count stops there.

use super::super::legendre::{Poly, TERMS, derivative, from_powers, significant};
use super::super::roots::sign_changes;
use super::segment::Segment;
use super::signal::{LAYER_TERMS, Signal};
use super::tables::INVERSE;
use crate::analysis::widest;

/// A layer that is less than this part of the variation so far does not count: 50 segments of it are below 1e-12.
const NOTHING: f64 = 2e-15;
/// Most extrema of a segment that are found here.
const MOST: usize = 8;

/// Values at the extrema of one segment, in order of time.
pub(super) struct Extrema {
    list: [f64; MOST],
    count: usize,
}

impl Extrema {
    pub(super) const NONE: Self = Self { list: [0.0; MOST], count: 0 };

    pub(super) fn values(&self) -> &[f64] {
        &self.list[..self.count]
    }

    fn push(&mut self, value: f64) -> Option<()> {
        *self.list.get_mut(self.count)? = value;
        self.count += 1;
        Some(())
    }
}

/// The extrema of a signal inside a segment; `None` where they are not proven complete. `variation` is the sum to which
/// their differences are added.
pub(super) fn extrema(segment: &Segment<'_>, x: &Signal, variation: f64) -> Option<Extrema> {
    let mut extrema = Extrema::NONE;
    let over = if segment.terms == 0 { 0.0 } else { segment.layer_below(x, NOTHING * variation) };
    let mut s = -1.0;
    if over > 0.0 {
        if over > 0.9 * segment.theta() {
            return None;
        }
        in_layer(segment, x, over, &mut extrema)?;
        s = 2.0 * over / segment.theta() - 1.0;
    }
    in_smooth(&x.smooth, s, NOTHING * variation, &mut extrema)?;
    Some(extrema)
}

/// Extrema of a polynomial from `from` to 1; changes by `floor` are noise.
fn in_smooth(c: &Poly, from: f64, floor: f64, extrema: &mut Extrema) -> Option<()> {
    let (mut others, mut bends) = (0.0, 0.0);
    let mut index = 2.0;
    for c in &c[2..] {
        others += index * c.abs();
        bends += index * (index - 1.0) * c.abs();
        index += 1.0;
    }
    if c[1].abs() > others * (1.0 + 1e-14) {
        return Some(());
    }
    // The derivative is monotone: at most one root.
    if 4.0 * c[2].abs() <= bends * (1.0 + 1e-14) {
        let mut series = from_powers(c);
        let needed = significant(&series, floor);
        series[needed..].fill(0.0);
        let roots = sign_changes(&derivative(&series), 0.0);
        for &s in roots.as_slice().iter().filter(|s| **s > from) {
            extrema.push(c.iter().rev().fold(0.0, |sum, c| sum * s + c))?;
        }
        return Some(());
    }
    let at = |s: f64| {
        let (mut value, mut slope, mut bend) = (0.0, 0.0, 0.0);
        for c in c.iter().rev() {
            bend = bend * s + slope;
            slope = slope * s + value;
            value = value * s + c;
        }
        (value, slope, 2.0 * bend)
    };
    let ((_, first, _), (_, last, _)) = (at(from), at(1.0));
    if (first < 0.0) == (last < 0.0) {
        return Some(());
    }
    let start = from - first * ((1.0 - from) / (last - first));
    extrema.push(polished(at, start, (from, 1.0), first < 0.0))
}

/// The value at the extremum between these points; `at` gives value, slope and second derivative.
fn polished(at: impl Fn(f64) -> (f64, f64, f64), start: f64, (low, high): (f64, f64), rising: bool) -> f64 {
    let (mut low, mut high, mut s) = (low, high, start);
    let mut best = 0.0;
    for _ in 0..60 {
        if !(s > low && s < high) {
            s = 0.5 * (low + high);
        }
        let (value, slope, bend) = at(s);
        if (slope < 0.0) == rising {
            low = s;
        } else {
            high = s;
        }
        let step = -slope / bend;
        // From here to the extremum to second order: what is left is of third order in the step, 1e-14.
        best = value + 0.5 * slope * step;
        // A short step out of the bracket leads to another zero of the derivative, not to the one that is inside.
        if step.abs() < 2e-5 && (low..=high).contains(&(s + step)) {
            return best;
        }
        s += step;
    }
    best
}

/// The layer about its start: derivative and value as functions of θ.
struct Start {
    /// Coefficients of θ^j (without the factorials) of the layer and of its derivative.
    layer: [f64; LAYER_TERMS],
    slope: [f64; LAYER_TERMS],
    terms: usize,
    /// The same of the smooth part.
    smooth: [f64; TERMS],
    smooth_terms: usize,
}

impl Start {
    /// First derivatives by θ at several points.
    fn slopes(&self, points: &[f64; 8]) -> [f64; 8] {
        slopes(&self.slope[..self.terms], &self.smooth[..self.smooth_terms], points)
    }

    /// The value at the extremum between two points at which the derivative is known.
    ///
    /// Where the derivative of the layer itself changes sign, Newton's method; where it dies away against a derivative of the
    /// smooth part, Newton's method on the logarithm of their ratio, which is almost a straight line.
    fn extremum(&self, ((mut low, first), (mut high, last)): ((f64, f64), (f64, f64))) -> f64 {
        let mut theta = low - first * ((high - low) / (last - first));
        let mut best = 0.0;
        for _ in 0..60 {
            if !(theta > low && theta < high) {
                theta = 0.5 * (low + high);
            }
            let ((value, slope, bend), (p, p1, p2)) = self.at(theta);
            let (sum, sum_bend) = (slope + p1, bend + p2);
            if (sum < 0.0) == (first < 0.0) {
                low = theta;
            } else {
                high = theta;
            }
            let newton = -sum / sum_bend;
            // From here to the extremum to second order: what is left is of third order in the step, 1e-14.
            best = value + p + 0.5 * sum * newton;
            // As in `polished`: not to another zero out of the bracket.
            if newton.abs() < 2e-5 && (low..=high).contains(&(theta + newton)) {
                return best;
            }
            let dying = slope * p1 < 0.0 && slope * bend < 0.0;
            theta += if dying { -(-slope / p1).ln() / (bend / slope - p2 / p1) } else { newton };
        }
        best
    }

    /// Value, first and second derivative by θ of the layer and of the smooth part.
    fn at(&self, theta: f64) -> ((f64, f64, f64), (f64, f64, f64)) {
        let (mut value, mut slope, mut bend) = (0.0, 0.0, 0.0);
        for j in (0..self.terms).rev() {
            bend = bend * theta + slope;
            slope = slope * theta + self.slope[j];
            value = value * theta + self.layer[j];
        }
        let decayed = (-theta).exp();
        let (mut p, mut p1, mut p2) = (0.0, 0.0, 0.0);
        for c in self.smooth[..self.smooth_terms].iter().rev() {
            p2 = p2 * theta + p1;
            p1 = p1 * theta + p;
            p = p * theta + c;
        }
        ((value * decayed, slope * decayed, (bend - slope) * decayed), (p, p1, 2.0 * p2))
    }
}

fn slopes(layer: &[f64], smooth: &[f64], points: &[f64; 8]) -> [f64; 8] {
    widest(
        #[inline(always)]
        || {
            let (mut sums, mut values, mut slopes) = ([0.0; 8], [0.0; 8], [0.0; 8]);
            for c in layer.iter().rev() {
                for k in 0..8 {
                    sums[k] = sums[k] * points[k] + c;
                }
            }
            for c in smooth.iter().rev() {
                for k in 0..8 {
                    slopes[k] = slopes[k] * points[k] + values[k];
                    values[k] = values[k] * points[k] + c;
                }
            }
            for k in 0..8 {
                slopes[k] += sums[k] * (-points[k]).exp();
            }
            slopes
        },
    )
}

/// Extrema between the start and `over`.
fn in_layer(segment: &Segment<'_>, x: &Signal, over: f64, extrema: &mut Extrema) -> Option<()> {
    let derivatives = segment.expansion(x, over);
    let used = derivatives.iter().rposition(|d| *d != 0.0).map_or(0, |last| last + 1).max(2);
    let terms = segment.terms;
    let q = &x.layer[..terms];
    let mut start = Start {
        layer: [0.0; LAYER_TERMS],
        slope: [0.0; LAYER_TERMS],
        terms,
        smooth: derivatives,
        smooth_terms: 0,
    };
    let mut coefficients = [0.0; LAYER_TERMS];
    let mut factor = 1.0;
    for j in 0..terms {
        let next = if j + 1 < terms { q[j + 1] } else { 0.0 };
        coefficients[j] = next - q[j];
        start.layer[j] = factor * q[j];
        start.slope[j] = factor * coefficients[j];
        factor *= INVERSE[j + 1];
    }
    start.smooth_terms = used;
    let mut factor = 1.0;
    for (i, c) in start.smooth[..used].iter_mut().enumerate() {
        *c *= factor;
        factor *= INVERSE[i + 1];
    }
    let most = variations(&coefficients[..terms], &derivatives[1..used], over);
    if most == 0 {
        return Some(());
    }
    // The last coefficient dominates: a bump with its top near θ = n − 1, steepest one width on either side.
    let top = number(terms - 1);
    let width = top.sqrt();
    let mut points = [0.0, top - width, top, top + width, top + 2.0 * width + 2.0, 0.0, 0.0, 0.0];
    points[5] = 0.5 * (points[4] + over);
    points[6] = over;
    for i in 1..6 {
        points[i] = points[i].clamp(0.0, over);
    }
    points[7] = over;
    let slopes = start.slopes(&points);
    let mut found = 0;
    for i in 1..7 {
        if (slopes[i - 1] < 0.0) != (slopes[i] < 0.0) {
            found += 1;
        }
    }
    // The ends fix how many there are up to an even number: with at most one missing, none is.
    if found + 1 < most {
        return None;
    }
    for i in 1..7 {
        if (slopes[i - 1] < 0.0) != (slopes[i] < 0.0) {
            let bracket = ((points[i - 1], slopes[i - 1]), (points[i], slopes[i]));
            extrema.push(start.extremum(bracket))?;
        }
    }
    Some(())
}

/// Coefficients after which it is asked again whether there can be another change of sign.
const BLOCK: usize = 16;

/// Sign changes of `t_j = r_j + Σ C(j, i)·S_i`, as far as these matter before `over`; one more where rounding may hide one.
fn variations(r: &[f64], slope: &[f64], over: f64) -> usize {
    widest(
        #[inline(always)]
        || {
            // Values of the polynomial Σ C(j, i)·S_i at j = 0, 1, …, from its differences, which are the S_i.
            let mut differences = [0.0; TERMS];
            differences[..slope.len()].copy_from_slice(slope);
            let (mut before, mut count) = (0.0f64, 0);
            let mut next = |own: f64, differences: &mut [f64]| {
                let t = own + differences[0];
                count += usize::from(t.abs() <= 1e-13 * (own.abs() + slope[0].abs()));
                count += usize::from(before != 0.0 && (before < 0.0) != (t < 0.0));
                before = t;
                for i in 1..differences.len() {
                    differences[i - 1] += differences[i];
                }
            };
            let differences = &mut differences[..slope.len()];
            for &own in r {
                next(own, differences);
            }
            // Beyond the layer's terms there is the polynomial alone. Coefficients are means of what is near θ = j: ten widths past
            // the end of the layer they are nothing within it.
            let mut beyond = over + 10.0 * over.sqrt() + 10.0 - number(r.len());
            while beyond > 0.0 {
                let (mut others, mut power, mut order) = (0.0, 1.0, 0.0);
                for difference in &differences[1..] {
                    order += 1.0;
                    power *= beyond / order;
                    others += difference.abs() * power;
                }
                let steady = differences[0].abs() > others;
                for _ in 0..if steady { 1 } else { BLOCK } {
                    next(0.0, differences);
                }
                beyond = if steady { 0.0 } else { beyond - number(BLOCK) };
            }
            count
        },
    )
}

#[expect(clippy::cast_precision_loss, reason = "at most 64")]
fn number(count: usize) -> f64 {
    count as f64
}

const _: () = assert!(TERMS > 4, "a bend needs three coefficients");
