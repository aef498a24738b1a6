//! One signal of several loops on one segment each.

use super::super::legendre::TERMS;
use super::lanes::Lanes;
use super::signal::{LAYER_TERMS, Signal, decay};
use super::tables::INVERSE;

/// Coefficients are summed in blocks of so many, in chains that do not wait for each other.
pub(super) const BLOCK: usize = 4;

/// The number of coefficients in whole blocks.
#[inline(always)]
pub(super) fn in_blocks(terms: usize) -> usize {
    terms.next_multiple_of(BLOCK)
}

/// What [`Signal`] is, for each of some loops.
#[derive(Clone)]
#[repr(align(64))]
pub(super) struct Signals<V: Lanes> {
    /// Powers of s; beyond [`order`](Self::order) they mean nothing, but zeros fill the last block of what is shown.
    pub(super) smooth: [V; TERMS],
    /// Coefficients of θ^j/j!; beyond the segment's terms they mean nothing, as the powers of s.
    pub(super) layer: [V; LAYER_TERMS],
    /// Number of smooth coefficients, at least 1.
    pub(super) order: usize,
}

/// Bounds on the magnitude of signals.
#[derive(Clone, Copy)]
pub(super) struct Sizes<V> {
    /// Of the smooth part without its coefficient 0.
    pub(super) swing: V,
    /// Of the layer: no `e^(−θ)·θ^j/j!` exceeds 1.
    pub(super) layer: V,
}

impl<V: Lanes> Signals<V> {
    #[inline(always)]
    pub(super) fn zero(token: V::Token) -> Self {
        let zero = V::zero(token);
        Self { smooth: [zero; TERMS], layer: [zero; LAYER_TERMS], order: 1 }
    }

    /// Becomes zero, `terms` of the layers.
    #[inline(always)]
    pub(super) fn clear(&mut self, terms: usize) {
        let zero = self.smooth[0].like(0.0);
        self.smooth[0] = zero;
        self.layer[..terms].fill(zero);
        self.order = 1;
    }

    /// `self = weight·other`: of the other's layer `terms`.
    #[inline(always)]
    pub(super) fn assign(&mut self, weight: V, other: &Self, terms: usize) {
        self.order = other.order;
        for (mine, theirs) in self.smooth[..other.order].iter_mut().zip(&other.smooth) {
            *mine = weight * *theirs;
        }
        for (mine, theirs) in self.layer[..terms].iter_mut().zip(&other.layer) {
            *mine = weight * *theirs;
        }
    }

    /// `self += weight·other`: of the other's layer `terms`.
    #[inline(always)]
    pub(super) fn add(&mut self, weight: V, other: &Self, terms: usize) {
        if other.order > self.order {
            self.smooth[self.order..other.order].fill(weight.like(0.0));
            self.order = other.order;
        }
        for (mine, theirs) in self.smooth[..other.order].iter_mut().zip(&other.smooth) {
            *mine = weight.times_plus(*theirs, *mine);
        }
        for (mine, theirs) in self.layer[..terms].iter_mut().zip(&other.layer) {
            *mine = weight.times_plus(*theirs, *mine);
        }
    }

    /// Fills the last blocks with zeros.
    #[inline(always)]
    pub(super) fn fill(&mut self, terms: usize) {
        let zero = self.smooth[0].like(0.0);
        fill_last(&mut self.smooth, self.order, zero);
        fill_last(&mut self.layer, terms, zero);
    }

    /// All blocks of powers of s.
    #[inline(always)]
    pub(super) fn smooth_blocks(&self) -> &[V] {
        &self.smooth[..in_blocks(self.order)]
    }

    /// All blocks of a layer of so many terms.
    #[inline(always)]
    pub(super) fn layer_blocks(&self, terms: usize) -> &[V] {
        &self.layer[..in_blocks(terms)]
    }

    /// Bounds on the magnitude of a signal whose last blocks are filled.
    #[inline(always)]
    pub(super) fn sizes(&self, terms: usize) -> Sizes<V> {
        let zero = self.smooth[0].like(0.0);
        let (blocks, _) = self.smooth_blocks().as_chunks();
        let swing =
            magnitude([zero, blocks[0][1].abs(), blocks[0][2].abs(), blocks[0][3].abs()], &blocks[1..]);
        Sizes { swing, layer: magnitude([zero; BLOCK], self.layer_blocks(terms).as_chunks().0) }
    }

    /// Values of the smooth part at both ends.
    #[inline(always)]
    pub(super) fn smooth_ends(&self) -> (V, V) {
        let zero = self.smooth[0].like(0.0);
        let (mut even, mut odd) = (zero, zero);
        let (pairs, rest) = self.smooth[..self.order].as_chunks::<2>();
        for [a, b] in pairs {
            even += *a;
            odd += *b;
        }
        for c in rest {
            even += *c;
        }
        (even - odd, even + odd)
    }

    /// The signal of one loop, times `factor`.
    #[inline(always)]
    pub(super) fn of_loop(&self, l: usize, factor: f64, terms: usize, signal: &mut Signal) {
        *signal = Signal::ZERO;
        for (c, lanes) in signal.smooth.iter_mut().zip(&self.smooth[..self.order]) {
            *c = factor * lanes[l];
        }
        for (q, lanes) in signal.layer.iter_mut().zip(&self.layer[..terms]) {
            *q = factor * lanes[l];
        }
        signal.order = self.order;
    }

    /// Keeps the part before the point `s` and returns the part after it; `end` is that point on the layers' axis.
    #[inline(always)]
    pub(super) fn split(&mut self, s: V, end: &End<V>, terms: usize) -> Self {
        let mut second = self.clone();
        restrict(&mut self.smooth[..second.order], s.like(-1.0), s);
        restrict(&mut second.smooth[..self.order], s, s.like(1.0));
        end.shift(&mut second.layer, terms);
        second
    }
}

/// Fills the last block of so many numbers with zeros; number by number, as it is less than a call.
#[inline(always)]
fn fill_last<V: Lanes>(list: &mut [V], count: usize, zero: V) {
    let (blocks, _) = list.as_chunks_mut::<BLOCK>();
    if let Some(block) = blocks.get_mut(count / BLOCK).filter(|_| !count.is_multiple_of(BLOCK)) {
        for (k, number) in block.iter_mut().enumerate() {
            *number = if k < count % BLOCK { *number } else { zero };
        }
    }
}

/// Sum of these numbers and of the magnitudes in the blocks.
#[inline(always)]
fn magnitude<V: Lanes>(mut sums: [V; BLOCK], blocks: &[[V; BLOCK]]) -> V {
    for block in blocks {
        for k in 0..BLOCK {
            sums[k] += block[k].abs();
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}

/// The polynomial on the part from `from` to `to`, in powers of that part's own s.
#[inline(always)]
fn restrict<V: Lanes>(p: &mut [V], from: V, to: V) {
    let (middle, ratio) = ((from + to) * 0.5, (to - from) * 0.5);
    for lowest in 0..p.len() {
        for j in (lowest..p.len() - 1).rev() {
            p[j] = middle.times_plus(p[j + 1], p[j]);
        }
    }
    let mut power = from.like(1.0);
    for c in p {
        *c = *c * power;
        power = power * ratio;
    }
}

/// A point on the layers' axis where they have decayed, or a stretch ends.
pub(super) struct End<V> {
    /// `e^(−θ)·θ^j/j!`
    weights: [V; LAYER_TERMS],
    /// `∫ e^(−θ)·θ^j/j! dθ` from there to infinity, `e^(−θ)·Σ θ^i/i!` with i = 0 … j.
    areas: [V; LAYER_TERMS],
    /// Whether layers of so many terms are nothing there.
    pub(super) decayed: bool,
}

impl<V: Lanes> End<V> {
    #[inline(always)]
    pub(super) fn new(token: V::Token) -> Self {
        let zero = V::zero(token);
        Self { weights: [zero; LAYER_TERMS], areas: [zero; LAYER_TERMS], decayed: true }
    }

    /// Moves to `theta`, for layers of so many terms.
    #[inline(always)]
    pub(super) fn move_to(&mut self, theta: V, terms: usize) {
        let over = decay(terms);
        self.decayed = theta.smallest() > over;
        if self.decayed {
            return;
        }
        let over = theta.like(over);
        let mut weight = theta.min(over).decayed().only_in(theta.at_most(over), theta.like(0.0));
        let mut area = weight;
        for j in 0..terms {
            self.weights[j] = weight;
            self.areas[j] = area;
            weight = weight * (theta * INVERSE[j + 1]);
            area += weight;
        }
    }

    /// Value of a layer.
    #[inline(always)]
    pub(super) fn value(&self, layer: &[V], zero: V) -> V {
        if self.decayed { zero } else { dot(layer, &self.weights, zero) }
    }

    /// A bound on the integral over θ of what is left of a layer, its sign left out.
    #[inline(always)]
    pub(super) fn area(&self, layer: &[V], zero: V) -> V {
        let mut bound = zero;
        if !self.decayed {
            for (q, area) in layer.iter().zip(&self.areas) {
                bound = q.abs().times_plus(*area, bound);
            }
        }
        bound
    }

    /// Coefficients of a layer of so many terms about this point: `q_j → e^(−θ)·Σ q_(j+i)·θ^i/i!`.
    #[inline(always)]
    pub(super) fn shift(&self, layer: &mut [V; LAYER_TERMS], terms: usize) {
        let zero = layer[0].like(0.0);
        // The last blocks of sums that begin within a block end beyond it.
        layer[terms..LAYER_TERMS.min(terms + BLOCK)].fill(zero);
        for j in 0..terms {
            let to = LAYER_TERMS.min(j + in_blocks(terms - j));
            layer[j] = self.value(&layer[j..to], zero);
        }
    }
}

/// What is left of a layer at the end of a stretch.
pub(super) struct Remainder<V> {
    /// A bound on its integral over θ, its sign left out.
    pub(super) area: V,
    layer: [V; LAYER_TERMS],
    is_known: bool,
}

impl<V: Lanes> Remainder<V> {
    #[inline(always)]
    pub(super) fn new(token: V::Token) -> Self {
        let zero = V::zero(token);
        Self { area: zero, layer: [zero; LAYER_TERMS], is_known: false }
    }

    /// Becomes that of a layer of so many terms.
    #[inline(always)]
    pub(super) fn begin(&mut self, end: &End<V>, layer: &[V; LAYER_TERMS], terms: usize) {
        self.area = end.area(&layer[..terms], layer[0].like(0.0));
        self.is_known = false;
    }

    /// Its coefficients about the end, found when first asked for.
    #[inline(always)]
    pub(super) fn layer(
        &mut self,
        end: &End<V>,
        layer: &[V; LAYER_TERMS],
        terms: usize,
    ) -> &[V; LAYER_TERMS] {
        if !self.is_known {
            self.layer[..terms].copy_from_slice(&layer[..terms]);
            end.shift(&mut self.layer, terms);
            self.is_known = true;
        }
        &self.layer
    }
}

/// Sum of products.
#[inline(always)]
fn dot<V: Lanes>(list: &[V], others: &[V], zero: V) -> V {
    in_chains(
        (list, others),
        zero,
        #[inline(always)]
        |c, other, sum| c.times_plus(*other, sum),
    )
}

/// The sum over pairs, each added by `plus`, block by block; there may be more of the second than of the first.
#[inline(always)]
pub(super) fn in_chains<V: Lanes, W>(
    (list, others): (&[V], &[W]),
    zero: V,
    plus: impl Fn(V, &W, V) -> V,
) -> V {
    let mut sums = [zero; BLOCK];
    let (blocks, rest) = list.as_chunks::<BLOCK>();
    let (other_blocks, _) = others.as_chunks::<BLOCK>();
    for (block, others) in blocks.iter().zip(other_blocks) {
        for k in 0..BLOCK {
            sums[k] = plus(block[k], &others[k], sums[k]);
        }
    }
    for (k, c) in rest.iter().enumerate() {
        sums[k] = plus(*c, &others[BLOCK * blocks.len() + k], sums[k]);
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::*;
    use crate::analysis::response::layered::lanes::One;
    use crate::analysis::response::layered::segment::layer_at;

    /// A signal, and its parts before and after `s`, which is `theta` on the layers' axis.
    fn split<V: Lanes>(token: V::Token, (s, theta): (f64, f64)) -> [Signal; 3] {
        let mut signals: Signals<V> = Signals::zero(token);
        signals.order = 12;
        for j in 0..12 {
            let power = |base: f64| V::all(token, base.powi(i32::try_from(j).unwrap()));
            (signals.smooth[j], signals.layer[j]) = (power(0.7), power(-0.6));
        }
        // Beyond its terms a layer means nothing.
        signals.layer[12..].fill(V::all(token, 1e3));
        let mut end = End::new(token);
        end.move_to(V::all(token, theta), 12);
        let mut first = signals.clone();
        let second = first.split(V::all(token, s), &end, 12);
        [signals, first, second].map(|signals| {
            let mut signal = Signal::ZERO;
            signals.of_loop(0, 1.0, 12, &mut signal);
            signal
        })
    }

    #[test]
    fn both_parts_of_split_signals_are_the_signals() {
        for (at, theta_there) in [(0.2, 3.0), (-0.4, 7.0)] {
            let parts = dispatch!(Level::new(), simd => split::<One<_>>(simd, (at, theta_there)));
            let [whole, first, second] = parts;
            let value = |signal: &Signal, s: f64| signal.smooth.iter().rev().fold(0.0, |sum, c| sum * s + c);
            // 1e-14: rounding of a few dozen terms of size 1.
            for s in [-1.0, -0.3, 0.9] {
                let (before, after) =
                    (-1.0 + 0.5 * (1.0 + at) * (1.0 + s), 1.0 - 0.5 * (1.0 - at) * (1.0 - s));
                assert!((value(&first, s) - value(&whole, before)).abs() < 1e-14);
                assert!((value(&second, s) - value(&whole, after)).abs() < 1e-14);
            }
            for theta in [0.0, 1.7, 20.0] {
                let expected = layer_at(&whole, theta_there + theta, 12);
                assert!((layer_at(&second, theta, 12) - expected).abs() < 1e-14);
            }
        }
    }
}
