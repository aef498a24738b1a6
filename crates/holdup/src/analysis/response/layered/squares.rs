//! `∫e²` and `∫u²` of several loops over a stretch, in closed form.

use super::super::legendre::{Poly, TERMS};
use super::integrals::{PerLoop, ROUNDING};
use super::lanes::{Lanes, lane_by_lane};
use super::propagate::Stretch;
use super::signal::{LAYER_TERMS, decay};
use super::signals::{Signals, shift};
use super::tables::{INVERSE, TABLES};

/// `∫e²` and `∫u²`; `so_far` are the sums they are added to.
#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
pub(super) fn squares<const L: usize>(
    stretch: &Stretch<'_, L>,
    so_far: (Lanes<L>, Lanes<L>),
) -> (PerLoop<f64, L>, PerLoop<f64, L>) {
    (square(stretch, stretch.error, so_far.0), square(stretch, stretch.manipulated, so_far.1))
}

/// `∫x²`; `None` where the smooth part, expanded about an end, does not converge over the layer.
///
/// What a layer that lasts longer than the stretch adds beyond it is taken away again.
#[inline(always)]
fn square<const L: usize>(stretch: &Stretch<'_, L>, x: &Signals<L>, so_far: Lanes<L>) -> PerLoop<f64, L> {
    let smooth = smooth_square(&x.smooth[..x.order]) * stretch.length;
    let layer = &x.layer[..stretch.terms];
    let (smooth_size, size) = x.sizes(stretch.terms);
    if size.largest() <= 0.0 {
        return smooth.0.map(Some);
    }
    let floor = (smooth + so_far) * stretch.rate * ROUNDING;
    let inverse = Lanes::all(1.0) / stretch.rate;
    let mut sum = smooth;
    let mut decided = [true; L];
    let ended = (beyond(stretch, x) * (smooth_size + size) * 2.0).every(floor, |left, floor| left <= floor);
    let mut later = [Lanes::ZERO; LAYER_TERMS];
    if !ended {
        later[..layer.len()].copy_from_slice(layer);
        shift(&mut later[..layer.len()], stretch.rate * stretch.length);
    }
    let later = &later[..layer.len()];
    if !(size * smooth_size).every(floor, |product, floor| 2.0 * product <= floor) {
        let p = &x.smooth[..x.order];
        let per_theta = inverse * 2.0 / stretch.length;
        let (mut product, mut converged) = product_sum(p, &TABLES.at_start, layer, per_theta, floor);
        if !ended {
            let (beyond, too) = product_sum(p, &TABLES.at_end, later, per_theta, floor);
            product = product - beyond;
            for l in 0..L {
                converged[l] &= too[l];
            }
        }
        sum += product * inverse * 2.0;
        decided = converged;
    }
    if !(size * size).every(floor, |square, floor| square <= floor) {
        let mut square = square_sum(layer, size, floor);
        if !ended {
            square = square - square_sum(later, size, floor);
        }
        sum += square * inverse;
    }
    let mut squares = [None; L];
    for l in 0..L {
        squares[l] = decided[l].then_some(sum.0[l]);
    }
    squares
}

/// A bound on the integral over θ of what is left of a layer, its sign left out, at the end of the stretch.
#[inline(always)]
pub(super) fn beyond<const L: usize>(stretch: &Stretch<'_, L>, x: &Signals<L>) -> Lanes<L> {
    let theta = stretch.rate * stretch.length;
    if theta.smallest() > decay(stretch.terms) {
        return Lanes::ZERO;
    }
    // From θ to infinity `e^(−θ)·θ^j/j!` has the area `e^(−θ)·Σ θ^i/i!`, i = 0 … j.
    let mut weight = theta.map(|theta| (-theta).exp());
    let (mut area, mut bound) = (Lanes::ZERO, Lanes::ZERO);
    for (j, q) in x.layer[..stretch.terms].iter().enumerate() {
        lane_by_lane::<L>();
        area += weight;
        bound += q.abs() * area;
        weight = weight * theta * INVERSE[j + 1];
    }
    bound
}

/// Half of `∫p²` over s.
#[inline(always)]
fn smooth_square<const L: usize>(p: &[Lanes<L>]) -> Lanes<L> {
    // Coefficient k of p², for even k, is a sum over pairs of coefficients whose numbers add up to k.
    let mut sum = Lanes::ZERO;
    for half in 0..p.len() {
        lane_by_lane::<L>();
        let mut pairs = p[half] * p[half] * 0.5;
        for apart in 1..=half.min(p.len() - 1 - half) {
            lane_by_lane::<L>();
            pairs += p[half - apart] * p[half + apart];
        }
        sum += pairs * (2.0 * INVERSE[2 * half + 1]);
    }
    sum
}

/// `∫ smooth·layer dθ` from an end on, where the smooth part has these derivatives, and for which loops that sum has
/// converged.
#[inline(always)]
fn product_sum<const L: usize>(
    smooth: &[Lanes<L>],
    derivatives: &[Poly; TERMS],
    layer: &[Lanes<L>],
    per_theta: Lanes<L>,
    floor: Lanes<L>,
) -> (Lanes<L>, [bool; L]) {
    let mut scale = Lanes::all(1.0);
    let (mut sum, mut before, mut size) = (Lanes::ZERO, Lanes::all(f64::INFINITY), Lanes::all(f64::INFINITY));
    let mut converged = [false; L];
    for (i, (row, moments)) in derivatives.iter().zip(&TABLES.moments).enumerate().take(smooth.len()) {
        let derivative = dot(&smooth[i..], &row[i..]);
        let moment = dot(layer, moments);
        let term = scale * derivative * moment;
        sum += term;
        (before, size) = (size, term.abs());
        let mut all = true;
        for l in 0..L {
            let enough = (1e-15 * sum.0[l].abs()).max(floor.0[l]);
            converged[l] = size.0[l] <= enough && before.0[l] <= enough;
            all &= converged[l];
        }
        if all {
            break;
        }
        scale = scale * per_theta;
    }
    // The series of a short polynomial ends by itself; what was cut off it is less than its last term where terms fall.
    if smooth.len() < TERMS - 1 {
        for l in 0..L {
            converged[l] |= size.0[l] <= before.0[l];
        }
    }
    (sum, converged)
}

/// `∫ layer² dθ`.
#[inline(always)]
fn square_sum<const L: usize>(layer: &[Lanes<L>], size: Lanes<L>, floor: Lanes<L>) -> Lanes<L> {
    let mut sum = Lanes::ZERO;
    for (j, q) in layer.iter().enumerate() {
        // Coefficients of the product are at most 1/2.
        if (*q * size).every(floor, |part, floor| part.abs() <= floor) {
            continue;
        }
        let row = &TABLES.squares[j];
        let others = dot(&layer[..j], &row[..j]);
        sum += *q * (others * 2.0 + *q * row[j]);
    }
    sum
}

/// Sum of products with numbers, in four chains.
#[inline(always)]
pub(super) fn dot<const L: usize>(list: &[Lanes<L>], weights: &[f64]) -> Lanes<L> {
    let mut sums = [Lanes::ZERO; 4];
    let (fours, rest) = list.as_chunks::<4>();
    let (four_weights, _) = weights.as_chunks::<4>();
    for (four, weights) in fours.iter().zip(four_weights) {
        lane_by_lane::<L>();
        for k in 0..4 {
            sums[k] += four[k] * weights[k];
        }
    }
    for (k, c) in rest.iter().enumerate() {
        lane_by_lane::<L>();
        sums[k] += *c * weights[4 * fours.len() + k];
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}

const _: () =
    assert!(LAYER_TERMS + 1 == INVERSE.len() && 2 * TERMS <= INVERSE.len(), "INVERSE reaches far enough");
