//! The states over one segment, and sums of signals: what costs most, in vectors.

use super::super::legendre::TERMS;
use super::lanes::Lanes;
use super::signals::Signals;
use super::tables::INVERSE;
use super::together::{Motion, Together, Weights};

/// The weighted sum.
#[inline(always)]
pub(super) fn combine<V: Lanes>(
    sum: &mut Signals<V>,
    row: &Weights<V>,
    states: &[Signals<V>],
    delayed: &[Signals<V>],
    terms: usize,
) {
    let known = row.delayed.iter().filter(|(c, _)| *c < delayed.len());
    let states = row.states.iter().map(|(i, weight)| (weight, &states[*i]));
    let mut parts = states.chain(known.map(|(c, weight)| (weight, &delayed[*c])));
    let Some((weight, first)) = parts.next() else { return sum.clear(terms) };
    sum.assign(*weight, first, terms);
    for (weight, part) in parts {
        sum.add(*weight, part, terms);
    }
}

/// All states over the segment of this length in which `delayed` comes out. `drive` is storage.
#[inline(always)]
pub(super) fn solve<V: Lanes>(
    plan: &Together<V>,
    (length, delayed): (V, &[Signals<V>]),
    terms: usize,
    start: &[V],
    signals: &mut [Signals<V>],
    drive: &mut Signals<V>,
) {
    let half = length * 0.5;
    let (zero, one) = (half.like(0.0), half.like(1.0));
    let step = one / plan.rate;
    for (i, state) in plan.states.iter().enumerate() {
        combine(drive, &state.drive, signals, delayed, terms);
        let x = &mut signals[i];
        let order = drive.order;
        match state.motion {
            Motion::Integral => {
                x.order = (order + 1).min(TERMS);
                for j in 0..x.order - 1 {
                    x.smooth[j + 1] = half * INVERSE[j + 1] * drive.smooth[j];
                }
                x.smooth[0] = zero;
                if terms > 0 {
                    sum_backwards(x, drive, step, one, terms);
                }
                x.smooth[0] = start[i] - first(x, terms) - x.smooth_ends().0;
            }
            Motion::Slow(own) => {
                x.order = TERMS;
                drive.smooth[order..].fill(zero);
                let (mut particular, mut homogeneous) = (zero, one);
                let mut all = Signals::zero(half.token());
                all.order = TERMS;
                x.smooth[0] = zero;
                all.smooth[0] = one;
                for j in 0..TERMS - 1 {
                    particular = half * INVERSE[j + 1] * (own * particular + drive.smooth[j]);
                    homogeneous = homogeneous * (half * own * INVERSE[j + 1]);
                    x.smooth[j + 1] = particular;
                    all.smooth[j + 1] = homogeneous;
                }
                if terms > 0 {
                    let damping = one / (one + own * step);
                    sum_backwards(x, drive, step, damping, terms);
                }
                let missing = start[i] - first(x, terms) - x.smooth_ends().0;
                let reach = missing / all.smooth_ends().0;
                x.add(reach, &all, 0);
            }
            Motion::Fast => {
                x.order = order;
                let inverse_half = step / half;
                let mut above = zero;
                #[expect(clippy::cast_precision_loss, reason = "at most 24")]
                let mut index = order as f64;
                for j in (0..order).rev() {
                    above = (inverse_half * -index).times_plus(above, drive.smooth[j] * step);
                    index -= 1.0;
                    x.smooth[j] = above;
                }
                for j in 1..terms {
                    x.layer[j] = drive.layer[j - 1] * step;
                }
                x.layer[0] = start[i] - x.smooth_ends().0;
            }
        }
    }
}

/// The first coefficient of the layer, if there is one.
#[inline(always)]
fn first<V: Lanes>(x: &Signals<V>, terms: usize) -> V {
    if terms > 0 { x.layer[0] } else { x.smooth[0].like(0.0) }
}

/// The layer of an integrator or a slow lag: `q_j = damping·(q_(j+1) − step·drive_j)`.
#[inline(always)]
fn sum_backwards<V: Lanes>(x: &mut Signals<V>, drive: &Signals<V>, step: V, damping: V, terms: usize) {
    let mut above = step.like(0.0);
    let damped = -damping * step;
    for j in (0..terms).rev() {
        above = damping.times_plus(above, damped * drive.layer[j]);
        x.layer[j] = above;
    }
}
