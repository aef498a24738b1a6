//! One signal on one segment: a polynomial and a layer.

use super::super::legendre::{Poly, TERMS};

/// Number of coefficients of a layer: a breakpoint that has gone through the loop j times has j + 1.
pub(in super::super) const LAYER_TERMS: usize = 64;

/// Coefficients of a layer.
pub(in super::super) type Layer = [f64; LAYER_TERMS];

/// `Σ smooth_j·s^j + e^(−θ)·Σ layer_j·θ^j/j!`.
#[derive(Debug, Clone)]
pub(in super::super) struct Signal {
    /// Powers of s, which runs from −1 to 1 over the segment.
    pub(in super::super) smooth: Poly,
    /// Coefficients of θ^j/j!, where θ is the time since the start in units of the fast pole; zero beyond the segment's terms.
    pub(in super::super) layer: Layer,
}

impl Signal {
    pub(super) const ZERO: Self = Self { smooth: [0.0; TERMS], layer: [0.0; LAYER_TERMS] };

    /// `self += weight·other`, `terms` of the layers.
    #[inline(always)]
    pub(super) fn add(&mut self, weight: f64, other: &Self, terms: usize) {
        for j in 0..TERMS {
            self.smooth[j] += weight * other.smooth[j];
        }
        for (mine, theirs) in self.layer[..terms].iter_mut().zip(&other.layer[..terms]) {
            *mine += weight * theirs;
        }
    }

    /// A bound on the magnitude of the smooth part.
    #[inline(always)]
    pub(super) fn smooth_size(&self) -> f64 {
        sum_of_magnitudes(&self.smooth)
    }

    /// A bound on the magnitude of the layer: no `e^(−θ)·θ^j/j!` exceeds 1.
    #[inline(always)]
    pub(super) fn layer_size(&self, terms: usize) -> f64 {
        self.layer[..terms].iter().map(|q| q.abs()).sum()
    }

    /// Values of the smooth part at both ends.
    #[inline(always)]
    pub(super) fn smooth_ends(&self) -> (f64, f64) {
        let mut lanes = [0.0; 8];
        for j in 0..TERMS {
            lanes[j % 8] += self.smooth[j];
        }
        let [a, b, c, d, e, f, g, h] = lanes;
        let (even, odd) = ((a + e) + (c + g), (b + f) + (d + h));
        (even - odd, even + odd)
    }

    /// The parts before and after the point `s`, each as a signal of its own; `theta` is that point on the layer's axis.
    pub(super) fn split(&self, s: f64, theta: f64, terms: usize) -> (Self, Self) {
        let (mut first, mut second) = (self.clone(), Self::ZERO);
        first.smooth = restricted(&self.smooth, -1.0, s);
        second.smooth = restricted(&self.smooth, s, 1.0);
        second.layer = shifted(&self.layer, theta, terms);
        (first, second)
    }
}

#[inline(always)]
pub(super) fn sum_of_magnitudes(p: &Poly) -> f64 {
    let mut lanes = [0.0; 8];
    for j in 0..TERMS {
        lanes[j % 8] += p[j].abs();
    }
    lanes.iter().sum()
}

/// The polynomial on the part from `from` to `to`, in powers of that part's own s.
fn restricted(p: &Poly, from: f64, to: f64) -> Poly {
    let (middle, ratio) = (0.5 * (from + to), 0.5 * (to - from));
    let mut part = *p;
    for lowest in 0..TERMS {
        for j in (lowest..TERMS - 1).rev() {
            part[j] += middle * part[j + 1];
        }
    }
    let mut power = 1.0;
    for c in &mut part {
        *c *= power;
        power *= ratio;
    }
    part
}

/// Coefficients of a layer about the later point `theta`: `q_j → e^(−θ)·Σ q_(j+i)·θ^i/i!`.
fn shifted(layer: &Layer, theta: f64, terms: usize) -> Layer {
    let mut weights = [0.0; LAYER_TERMS];
    if has_decayed(theta, terms) {
        return weights;
    }
    let mut weight = (-theta).exp();
    let mut index = 1.0;
    for w in &mut weights[..terms] {
        *w = weight;
        weight *= theta / index;
        index += 1.0;
    }
    let mut later = [0.0; LAYER_TERMS];
    for j in 0..terms {
        later[j] = layer[j..terms].iter().zip(&weights).map(|(q, w)| q * w).sum();
    }
    later
}

/// Whether every `e^(−θ)·θ^j/j!` with j below `terms` is below 1e-22, and stays so from here on.
pub(super) fn has_decayed(theta: f64, terms: usize) -> bool {
    terms == 0 || theta > decay(terms)
}

/// From here on a layer of so many terms is nothing.
pub(super) fn decay(terms: usize) -> f64 {
    // The factor at θ = 2n + 60 is largest, 1e-24, near n = 30 (computed for n from 1 to 64).
    if terms == 0 { 0.0 } else { 60.0 + 2.0 * terms_as_number(terms) }
}

#[expect(clippy::cast_precision_loss, reason = "at most 64")]
fn terms_as_number(terms: usize) -> f64 {
    terms as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layer_value(layer: &Layer, theta: f64) -> f64 {
        let mut weight = (-theta).exp();
        let mut sum = 0.0;
        for (j, q) in layer.iter().enumerate() {
            sum += q * weight;
            weight *= theta / f64::from(u32::try_from(j + 1).unwrap());
        }
        sum
    }

    #[test]
    fn both_parts_of_a_split_signal_are_the_signal() {
        let mut signal = Signal::ZERO;
        for j in 0..12 {
            let j_number = f64::from(u32::try_from(j).unwrap());
            signal.smooth[j] = 0.5f64.powf(j_number);
            signal.layer[j] = (-0.6f64).powf(j_number);
        }
        let value = |p: &Poly, s: f64| p.iter().rev().fold(0.0, |sum, c| sum * s + c);
        let (first, second) = signal.split(0.2, 3.0, 12);
        // 1e-14: rounding of a few dozen terms of size 1.
        for s in [-1.0, -0.3, 0.9] {
            assert!((value(&first.smooth, s) - value(&signal.smooth, -0.4 + 0.6 * s)).abs() < 1e-14);
            assert!((value(&second.smooth, s) - value(&signal.smooth, 0.6 + 0.4 * s)).abs() < 1e-14);
        }
        for theta in [0.0, 1.7, 20.0] {
            let whole = layer_value(&signal.layer, 3.0 + theta);
            assert!((layer_value(&second.layer, theta) - whole).abs() < 1e-14);
        }
    }

    #[test]
    fn a_layer_that_has_decayed_is_nothing() {
        for terms in 1..=LAYER_TERMS {
            let theta = decay(terms);
            let mut weight = (-theta).exp();
            for j in 1..terms {
                weight *= theta / f64::from(u32::try_from(j).unwrap());
            }
            assert!(weight < 1e-22, "{terms}: {weight}");
        }
    }
}
