//! The states over one segment, and sums of signals: what costs most, in vectors.

use super::super::legendre::TERMS;
use super::lanes::{Lanes, lane_by_lane};
use super::signal::decay;
use super::signals::Signals;
use super::tables::INVERSE;
use super::together::{Motion, Together, Weights};

/// A bound on the magnitude of a signal, and the magnitude of the last two smooth coefficients that there can be.
#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
pub(super) fn size_and_tail<const L: usize>(signal: &Signals<L>, terms: usize) -> (Lanes<L>, Lanes<L>) {
    let (smooth, layer) = signal.sizes(terms);
    let mut tail = Lanes::ZERO;
    for c in signal.smooth[..signal.order].iter().skip(TERMS - 2) {
        tail += c.abs();
    }
    (smooth + layer, tail)
}

/// The states at the end of the segment.
#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
pub(super) fn arrive<const L: usize>(
    signals: &[Signals<L>],
    terms: usize,
    theta: Lanes<L>,
    states: &mut [Lanes<L>],
) {
    for (state, signal) in states.iter_mut().zip(signals) {
        *state = signal.smooth_ends().1 + layer_at(&signal.layer[..terms], theta);
    }
}

/// Value of a layer at `theta`.
#[inline(always)]
fn layer_at<const L: usize>(layer: &[Lanes<L>], theta: Lanes<L>) -> Lanes<L> {
    let over = decay(layer.len());
    if theta.smallest() > over {
        return Lanes::ZERO;
    }
    let mut sum = Lanes::ZERO;
    for (j, q) in layer.iter().enumerate().rev() {
        lane_by_lane::<L>();
        sum = sum * theta * INVERSE[j + 1] + *q;
    }
    sum.with(theta, |sum, theta| if theta > over { 0.0 } else { sum * (-theta).exp() })
}

/// The weighted sum, in vectors.
#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
pub(super) fn weighted<const L: usize>(
    sum: &mut Signals<L>,
    row: &Weights<L>,
    states: &[Signals<L>],
    delayed: &[Signals<L>],
    terms: usize,
) {
    combine(sum, row, states, delayed, terms);
}

#[inline(always)]
fn combine<const L: usize>(
    sum: &mut Signals<L>,
    row: &Weights<L>,
    states: &[Signals<L>],
    delayed: &[Signals<L>],
    terms: usize,
) {
    sum.clear(terms);
    for &(i, weight) in &row.states {
        sum.add(weight, &states[i], terms);
    }
    for &(c, weight) in row.delayed.iter().filter(|(c, _)| *c < delayed.len()) {
        sum.add(weight, &delayed[c], terms);
    }
}

/// All states over the segment of this length in which `delayed` comes out, and what goes in.
#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
pub(super) fn solve<const L: usize>(
    plan: &Together<L>,
    (length, delayed): (Lanes<L>, &[Signals<L>]),
    terms: usize,
    start: &[Lanes<L>],
    signals: &mut [Signals<L>],
    inputs: &mut [Signals<L>],
) {
    let half = length * 0.5;
    let step = Lanes::all(1.0) / plan.rate;
    let mut drive = Signals::ZERO;
    for (i, state) in plan.states.iter().enumerate() {
        combine(&mut drive, &state.drive, signals, delayed, terms);
        let x = &mut signals[i];
        let order = drive.order;
        match state.motion {
            Motion::Integral => {
                x.order = (order + 1).min(TERMS);
                for j in 0..x.order - 1 {
                    lane_by_lane::<L>();
                    x.smooth[j + 1] = half * INVERSE[j + 1] * drive.smooth[j];
                }
                x.smooth[0] = Lanes::ZERO;
                if terms > 0 {
                    sum_backwards(x, &drive, step, Lanes::all(1.0), terms);
                }
                x.smooth[0] = start[i] - first(x, terms) - x.smooth_ends().0;
            }
            Motion::Slow(own) => {
                x.order = TERMS;
                drive.smooth[order..].fill(Lanes::ZERO);
                let (mut particular, mut homogeneous) = (Lanes::ZERO, Lanes::all(1.0));
                let mut all = Signals::ZERO;
                all.order = TERMS;
                x.smooth[0] = Lanes::ZERO;
                all.smooth[0] = Lanes::all(1.0);
                for j in 0..TERMS - 1 {
                    lane_by_lane::<L>();
                    particular = half * INVERSE[j + 1] * (own * particular + drive.smooth[j]);
                    homogeneous = homogeneous * (half * own * INVERSE[j + 1]);
                    x.smooth[j + 1] = particular;
                    all.smooth[j + 1] = homogeneous;
                }
                if terms > 0 {
                    let damping = Lanes::all(1.0) / (Lanes::all(1.0) + own * step);
                    sum_backwards(x, &drive, step, damping, terms);
                }
                let missing = start[i] - first(x, terms) - x.smooth_ends().0;
                let reach = missing / all.smooth_ends().0;
                x.add(reach, &all, 0);
            }
            Motion::Fast => {
                x.order = order;
                let inverse_half = step / half;
                let mut above = Lanes::ZERO;
                #[expect(clippy::cast_precision_loss, reason = "at most 24")]
                let mut index = order as f64;
                for j in (0..order).rev() {
                    lane_by_lane::<L>();
                    above = drive.smooth[j] * step - inverse_half * index * above;
                    index -= 1.0;
                    x.smooth[j] = above;
                }
                for j in 1..terms {
                    lane_by_lane::<L>();
                    x.layer[j] = drive.layer[j - 1] * step;
                }
                x.layer[0] = start[i] - x.smooth_ends().0;
            }
        }
    }
    for (input, row) in inputs.iter_mut().zip(&plan.inputs) {
        combine(input, row, signals, delayed, terms);
    }
}

/// The first coefficient of the layer, if there is one.
#[inline(always)]
fn first<const L: usize>(x: &Signals<L>, terms: usize) -> Lanes<L> {
    if terms > 0 { x.layer[0] } else { Lanes::ZERO }
}

/// The layer of an integrator or a slow lag: `q_j = damping·(q_(j+1) − step·drive_j)`.
#[inline(always)]
fn sum_backwards<const L: usize>(
    x: &mut Signals<L>,
    drive: &Signals<L>,
    step: Lanes<L>,
    damping: Lanes<L>,
    terms: usize,
) {
    let mut above = Lanes::ZERO;
    for j in (0..terms).rev() {
        lane_by_lane::<L>();
        above = damping * (above - step * drive.layer[j]);
        x.layer[j] = above;
    }
}
