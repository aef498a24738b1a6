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
    /// Number of smooth coefficients, at least 1; beyond, they are zero.
    pub(in super::super) order: usize,
}

impl Signal {
    pub(super) const ZERO: Self = Self { smooth: [0.0; TERMS], layer: [0.0; LAYER_TERMS], order: 1 };

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
}

#[inline(always)]
pub(super) fn sum_of_magnitudes(p: &Poly) -> f64 {
    let mut lanes = [0.0; 8];
    for j in 0..TERMS {
        lanes[j % 8] += p[j].abs();
    }
    lanes.iter().sum()
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
