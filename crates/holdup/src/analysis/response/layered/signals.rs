//! One signal of several loops on one segment each.

use super::super::legendre::TERMS;
use super::lanes::{Lanes, lane_by_lane};
use super::signal::{LAYER_TERMS, Signal, decay};
use super::tables::INVERSE;

/// What [`Signal`] is, for each of `L` loops.
#[derive(Debug, Clone)]
#[repr(align(64))]
pub(super) struct Signals<const L: usize> {
    /// Powers of s; beyond [`order`](Self::order) they mean nothing.
    pub(super) smooth: [Lanes<L>; TERMS],
    /// Coefficients of θ^j/j!; beyond the segment's terms they mean nothing.
    pub(super) layer: [Lanes<L>; LAYER_TERMS],
    /// Number of smooth coefficients, at least 1.
    pub(super) order: usize,
}

impl<const L: usize> Signals<L> {
    pub(super) const ZERO: Self =
        Self { smooth: [Lanes::ZERO; TERMS], layer: [Lanes::ZERO; LAYER_TERMS], order: 1 };

    /// Becomes zero, `terms` of the layers.
    #[inline(always)]
    pub(super) fn clear(&mut self, terms: usize) {
        self.smooth[0] = Lanes::ZERO;
        self.layer[..terms].fill(Lanes::ZERO);
        self.order = 1;
    }

    /// `self += weight·other`: of the other's layer `terms`.
    #[inline(always)]
    pub(super) fn add(&mut self, weight: Lanes<L>, other: &Self, terms: usize) {
        if other.order > self.order {
            self.smooth[self.order..other.order].fill(Lanes::ZERO);
            self.order = other.order;
        }
        for (mine, theirs) in self.smooth[..other.order].iter_mut().zip(&other.smooth) {
            lane_by_lane::<L>();
            *mine += weight * *theirs;
        }
        for (mine, theirs) in self.layer[..terms].iter_mut().zip(&other.layer) {
            lane_by_lane::<L>();
            *mine += weight * *theirs;
        }
    }

    /// Bounds on the magnitude of the smooth part and of the layer: no `e^(−θ)·θ^j/j!` exceeds 1.
    #[inline(always)]
    pub(super) fn sizes(&self, terms: usize) -> (Lanes<L>, Lanes<L>) {
        (magnitude(&self.smooth[..self.order]), magnitude(&self.layer[..terms]))
    }

    /// Values of the smooth part at both ends.
    #[inline(always)]
    pub(super) fn smooth_ends(&self) -> (Lanes<L>, Lanes<L>) {
        let (mut even, mut odd) = (Lanes::ZERO, Lanes::ZERO);
        let (pairs, rest) = self.smooth[..self.order].as_chunks::<2>();
        for [a, b] in pairs {
            lane_by_lane::<L>();
            even += *a;
            odd += *b;
        }
        for c in rest {
            even += *c;
        }
        (even - odd, even + odd)
    }

    /// The signal of one loop.
    pub(super) fn of_loop(&self, l: usize, terms: usize, signal: &mut Signal) {
        *signal = Signal::ZERO;
        for (c, lanes) in signal.smooth.iter_mut().zip(&self.smooth[..self.order]) {
            *c = lanes.0[l];
        }
        for (q, lanes) in signal.layer.iter_mut().zip(&self.layer[..terms]) {
            *q = lanes.0[l];
        }
    }

    /// The parts before and after the point `s`, each as a signal of its own; `theta` is that point on the layer's axis.
    pub(super) fn split(&self, s: Lanes<L>, theta: Lanes<L>, terms: usize) -> (Self, Self) {
        let (mut first, mut second) = (self.clone(), self.clone());
        restrict(&mut first.smooth[..self.order], Lanes::all(-1.0), s);
        restrict(&mut second.smooth[..self.order], s, Lanes::all(1.0));
        shift(&mut second.layer[..terms], theta);
        (first, second)
    }
}

/// Sum of magnitudes, in four chains.
#[inline(always)]
pub(super) fn magnitude<const L: usize>(list: &[Lanes<L>]) -> Lanes<L> {
    let mut sums = [Lanes::ZERO; 4];
    let (fours, rest) = list.as_chunks::<4>();
    for four in fours {
        lane_by_lane::<L>();
        for k in 0..4 {
            sums[k] += four[k].abs();
        }
    }
    for (sum, c) in sums.iter_mut().zip(rest) {
        *sum += c.abs();
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}

/// The polynomial on the part from `from` to `to`, in powers of that part's own s.
fn restrict<const L: usize>(p: &mut [Lanes<L>], from: Lanes<L>, to: Lanes<L>) {
    let (middle, ratio) = ((from + to) * 0.5, (to - from) * 0.5);
    for lowest in 0..p.len() {
        for j in (lowest..p.len() - 1).rev() {
            lane_by_lane::<L>();
            let next = middle * p[j + 1];
            p[j] += next;
        }
    }
    let mut power = Lanes::all(1.0);
    for c in p {
        *c = *c * power;
        power = power * ratio;
    }
}

/// Coefficients of a layer about the later point `theta`: `q_j → e^(−θ)·Σ q_(j+i)·θ^i/i!`.
#[inline(always)]
pub(super) fn shift<const L: usize>(layer: &mut [Lanes<L>], theta: Lanes<L>) {
    let over = decay(layer.len());
    let mut weight = theta.map(|theta| if theta > over { 0.0 } else { (-theta).exp() });
    let mut weights = [Lanes::ZERO; LAYER_TERMS];
    for (i, w) in weights[..layer.len()].iter_mut().enumerate() {
        *w = weight;
        weight = weight * theta * INVERSE[i + 1];
    }
    for j in 0..layer.len() {
        let mut sum = Lanes::ZERO;
        for (q, w) in layer[j..].iter().zip(&weights) {
            lane_by_lane::<L>();
            sum += *q * *w;
        }
        layer[j] = sum;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::response::layered::segment::layer_at;

    #[test]
    fn both_parts_of_split_signals_are_the_signals() {
        let mut signals: Signals<2> = Signals::ZERO;
        signals.order = 12;
        for j in 0..12 {
            let j_number = f64::from(i32::try_from(j).unwrap());
            signals.smooth[j] = Lanes([0.5f64.powf(j_number), 0.7f64.powf(j_number)]);
            signals.layer[j] = Lanes([(-0.6f64).powi(i32::try_from(j).unwrap()), 0.3f64.powf(j_number)]);
        }
        let (points, thetas) = (Lanes([0.2, -0.4]), Lanes([3.0, 7.0]));
        let (first, second) = signals.split(points, thetas, 12);
        for l in 0..2 {
            let of = |signals: &Signals<2>| {
                let mut signal = Signal::ZERO;
                signals.of_loop(l, 12, &mut signal);
                signal
            };
            let (whole, first, second) = (of(&signals), of(&first), of(&second));
            let value = |signal: &Signal, s: f64| signal.smooth.iter().rev().fold(0.0, |sum, c| sum * s + c);
            let at = points.0[l];
            // 1e-14: rounding of a few dozen terms of size 1.
            for s in [-1.0, -0.3, 0.9] {
                let (before, after) =
                    (-1.0 + 0.5 * (1.0 + at) * (1.0 + s), 1.0 - 0.5 * (1.0 - at) * (1.0 - s));
                assert!((value(&first, s) - value(&whole, before)).abs() < 1e-14);
                assert!((value(&second, s) - value(&whole, after)).abs() < 1e-14);
            }
            for theta in [0.0, 1.7, 20.0] {
                let expected = layer_at(&whole, thetas.0[l] + theta, 12);
                assert!((layer_at(&second, theta, 12) - expected).abs() < 1e-14);
            }
        }
    }
}
