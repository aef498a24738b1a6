//! Which term of the characteristic equation outweighs the others on a whole band of frequencies.
//!
//! The moduli |pₖ(jω)| know nothing of the delays: they are smooth where L turns round thousands of times. So
//! `|L| ≤ A` (the denominator outweighs the numerator) or `|L| > 1` (one term of the numerator outweighs all)
//! is proven in one step on a wide band, or up to infinite frequency.

use super::characteristic::Characteristic;
use super::polynomial::Polynomial;

/// What is known of |L| on a whole band of frequencies.
pub(super) trait Modulus {
    /// Whether `|L| < bound` is proven on [from, to].
    fn gain_is_below(&self, bound: f64, from: f64, to: f64) -> bool;
    /// Whether `|L| > 1` is proven on [from, to].
    fn gain_is_above_one(&self, from: f64, to: f64) -> bool;
}

impl Modulus for Envelope {
    fn gain_is_below(&self, bound: f64, from: f64, to: f64) -> bool {
        bound > 0.0 && self.outweighs(0, bound, from, to)
    }

    fn gain_is_above_one(&self, from: f64, to: f64) -> bool {
        let heaviest = self.heaviest(if to.is_finite() { f64::midpoint(from, to) } else { from });
        !self.parts[heaviest].of_denominator && self.outweighs(heaviest, 1.0, from, to)
    }
}

/// |pₖ(jω)|², in x = ω², for every term of N and D.
#[derive(Debug, Clone)]
pub(super) struct Envelope {
    parts: Vec<Part>,
}

#[derive(Debug, Clone)]
struct Part {
    squared: Polynomial,
    of_denominator: bool,
}

impl Envelope {
    pub(super) fn new(characteristic: &Characteristic) -> Self {
        let part = |p: &Polynomial, of_denominator| Part { squared: p.squared_magnitude(), of_denominator };
        let denominator = characteristic.denominator.terms().iter().map(|(_, p)| part(p, true));
        let numerator = characteristic.numerator.terms().iter().map(|(_, p)| part(p, false));
        Self { parts: denominator.chain(numerator).collect() }
    }

    /// The term of largest modulus at this frequency; terms of D come first, then those of N.
    pub(super) fn heaviest(&self, omega: f64) -> usize {
        let x = omega * omega;
        let value = |i: usize| self.parts[i].squared.value(x);
        (1..self.parts.len()).fold(0, |best, i| if value(i) > value(best) { i } else { best })
    }

    /// Whether `A·|p_k| > Σ |p_l|` over the other terms is proven on [from, to], `to` infinite included, where
    /// A is `bound` and multiplies the terms of D on either side.
    pub(super) fn outweighs(&self, k: usize, bound: f64, from: f64, to: f64) -> bool {
        let factor = |part: &Part| if part.of_denominator { bound } else { 1.0 };
        let (low, high) = (from * from, to * to);
        let middle = if to.is_finite() { f64::midpoint(low, high) } else { low.max(1e-300) };
        let others = || self.parts.iter().enumerate().filter(move |(l, _)| *l != k).map(|(_, part)| part);
        let weight = |part: &Part| factor(part) * part.squared.value(middle).max(0.0).sqrt();
        let sum: f64 = others().map(weight).sum();
        let mut excess = Polynomial::ZERO.plus(&self.parts[k].squared, factor(&self.parts[k]).powi(2));
        for part in others() {
            // Cauchy–Schwarz, (Σ aₗ)² ≤ Σ aₗ²/λₗ with Σ λₗ = 1, is tight where λₗ is the share of term l.
            let share = if sum > 0.0 { (weight(part) / sum).max(1e-6) } else { 1.0 };
            excess = excess.plus(&part.squared, -factor(part).powi(2) / share);
        }
        if to.is_finite() {
            let rounding = 1e-15 * self.parts[k].squared.magnitudes(low)[0];
            excess.exceeds(rounding, low, high)
        } else {
            excess.positive_beyond(low)
        }
    }
}

/// From which frequency on L turns clockwise only.
#[derive(Debug, Clone)]
pub(super) struct Steady<'a> {
    characteristic: &'a Characteristic,
}

impl<'a> Steady<'a> {
    pub(super) fn new(characteristic: &'a Characteristic) -> Self {
        Self { characteristic }
    }

    /// Whether arg L is proven to fall strictly on [from, ∞).
    ///
    /// With `N = n₁·e^(−τ₁s)·(1 + ε)` and |ε| ≤ 1/8 the rate is at most `−τ₁ + |n₁'/n₁| + |D'/D| + |ε'|·8/7`.
    pub(super) fn beyond(&self, from: f64) -> bool {
        let Characteristic { numerator, denominator, .. } = self.characteristic;
        let [(_, denominator)] = denominator.terms() else { return false };
        let Some(((shortest, first), rest)) = numerator.terms().split_first() else { return false };
        if from < 1.0 {
            return false;
        }
        let Some(outer) = denominator.logarithmic_bound(from) else { return false };
        let Some(inner) = first.logarithmic_bound(from) else { return false };
        let mut rate = -shortest + (inner + outer) / from;
        let mut share = Polynomial::ZERO.plus(&first.squared_magnitude(), 1.0 / 64.0);
        #[expect(clippy::cast_precision_loss, reason = "at most 16 terms")]
        let terms = rest.len() as f64;
        for (delay, p) in rest {
            let Some(own) = p.logarithmic_bound(from) else { return false };
            rate += (8.0 / 7.0) * 0.125 * ((inner + own) / from + (delay - shortest));
            // (Σ|aₗ|)² ≤ m·Σ|aₗ|²
            share = share.plus(&p.squared_magnitude(), -terms);
        }
        rate < 0.0 && (rest.is_empty() || share.positive_beyond(from * from))
    }
}
