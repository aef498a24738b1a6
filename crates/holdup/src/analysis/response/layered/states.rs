//! The states over one segment, and sums of signals: what costs most, in vectors.

use super::super::legendre::TERMS;
use super::lanes::Lanes;
use super::plan::{Motion, Plan, Weights};
use super::signals::Signals;
use super::tables::INVERSE;

/// The weighted sum.
#[inline(always)]
pub(super) fn combine<V: Lanes>(
    sum: &mut Signals<V>,
    row: &Weights<V>,
    states: &[Signals<V>],
    delayed: &[Signals<V>],
    terms: usize,
) {
    let mut parts = parts(row, states, delayed);
    let Some((weight, first)) = parts.next() else { return sum.clear(terms) };
    sum.assign(weight, first, terms);
    for (weight, part) in parts {
        sum.add(weight, part, terms);
    }
}

/// What the sum is made of.
#[inline(always)]
fn parts<'s, V: Lanes>(
    row: &'s Weights<V>,
    states: &'s [Signals<V>],
    delayed: &'s [Signals<V>],
) -> impl Iterator<Item = (V, &'s Signals<V>)> {
    let known = row.delayed.iter().filter(|(c, _)| *c < delayed.len());
    let states = row.states.iter().map(|(i, weight)| (*weight, &states[*i]));
    states.chain(known.map(|(c, weight)| (*weight, &delayed[*c])))
}

/// The sum as one signal and its weight: that of its only part, or `sum`, where it is put.
#[inline(always)]
fn combined<'s, V: Lanes>(
    sum: &'s mut Signals<V>,
    row: &'s Weights<V>,
    states: &'s [Signals<V>],
    delayed: &'s [Signals<V>],
    terms: usize,
) -> (V, &'s Signals<V>) {
    let mut parts = parts(row, states, delayed);
    if let (Some(only), None) = (parts.next(), parts.next()) {
        return only;
    }
    combine(sum, row, states, delayed, terms);
    (sum.smooth[0].like(1.0), sum)
}

/// All states over the segment of this length in which `delayed` comes out. `values` are those at the start, and become those of
/// the smooth parts at the end. `drive` is storage.
#[inline(always)]
pub(super) fn solve<V: Lanes>(
    plan: &Plan<V>,
    (length, delayed): (V, &[Signals<V>]),
    terms: usize,
    values: &mut [V],
    signals: &mut [Signals<V>],
    drive: &mut Signals<V>,
) {
    let half = length * 0.5;
    let (zero, one) = (half.like(0.0), half.like(1.0));
    let step = one / plan.rate;
    for (i, state) in plan.states.iter().enumerate() {
        let (before, rest) = signals.split_at_mut(i);
        let Some(x) = rest.first_mut() else { return };
        let (weight, drive) = combined(drive, &state.drive, before, delayed, terms);
        let order = drive.order;
        match state.motion {
            Motion::Integral => {
                x.order = (order + 1).min(TERMS);
                let rate = half * weight;
                for j in 0..x.order - 1 {
                    x.smooth[j + 1] = rate * INVERSE[j + 1] * drive.smooth[j];
                }
                x.smooth[0] = zero;
                if terms > 0 {
                    sum_backwards(x, drive, step * weight, one, terms);
                }
                let (begin, end) = x.smooth_ends();
                x.smooth[0] = values[i] - first(x, terms) - begin;
                values[i] = end + x.smooth[0];
            }
            Motion::Slow(own) => {
                x.order = TERMS;
                let (mut particular, mut homogeneous) = (zero, one);
                let mut all = Signals::zero(half.token());
                all.order = TERMS;
                x.smooth[0] = zero;
                all.smooth[0] = one;
                for j in 0..TERMS - 1 {
                    let driven = if j < order { weight * drive.smooth[j] } else { zero };
                    particular = half * INVERSE[j + 1] * (own * particular + driven);
                    homogeneous = homogeneous * (half * own * INVERSE[j + 1]);
                    x.smooth[j + 1] = particular;
                    all.smooth[j + 1] = homogeneous;
                }
                if terms > 0 {
                    let damping = one / (one + own * step);
                    sum_backwards(x, drive, step * weight, damping, terms);
                }
                let missing = values[i] - first(x, terms) - x.smooth_ends().0;
                let reach = missing / all.smooth_ends().0;
                x.add(reach, &all, 0);
                values[i] = x.smooth_ends().1;
            }
            Motion::Fast => {
                x.order = order;
                let (inverse_half, gain) = (step / half, step * weight);
                let mut above = zero;
                #[expect(clippy::cast_precision_loss, reason = "at most 24")]
                let mut index = order as f64;
                for j in (0..order).rev() {
                    above = (inverse_half * -index).times_plus(above, drive.smooth[j] * gain);
                    index -= 1.0;
                    x.smooth[j] = above;
                }
                for j in 1..terms {
                    x.layer[j] = drive.layer[j - 1] * gain;
                }
                let (begin, end) = x.smooth_ends();
                x.layer[0] = values[i] - begin;
                values[i] = end;
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
