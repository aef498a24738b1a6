//! N, D and Δ of a sampled loop on the unit circle, z = e^(jθ), with bounds of their derivatives in θ.

use std::f64::consts::PI;

use num_complex::Complex;

use super::pulse::{Pulse, Terms, product};
use crate::analysis::frequency::envelope::Modulus;
use crate::analysis::frequency::functions::{Curve, rotated_bounds};
use crate::analysis::frequency::quasi_polynomial::{Jet, rotated};

/// The loop along the circle; θ counts radians per sample.
#[derive(Debug, Clone)]
pub(super) struct Circle {
    numerator: Terms,
    shortest_delay: f64,
    denominator: Terms,
    reduced: Terms,
    integrators: f64,
    longest_delay: f64,
    spread: f64,
    /// Degree of z·(N + D): how many closed-loop poles there are beside those that delays make.
    pub(super) order: f64,
    factors: Option<Vec<(f64, f64)>>,
}

impl Circle {
    pub(super) fn new(pulse: &Pulse) -> Self {
        let delays = || pulse.numerator.iter().map(|(delay, _)| *delay);
        let shortest_delay = delays().fold(f64::INFINITY, f64::min);
        let base = pulse.factors.iter().fold(vec![1.0], |base, &(a, b)| product(&base, &[a, b]));
        let reduced = match &pulse.prediction {
            None => vec![(0.0, base)],
            Some(terms) => terms.iter().map(|(delay, p)| (*delay, product(p, &base))).collect(),
        };
        let mut power = vec![0.0; pulse.integrators];
        power.push(1.0);
        let denominator: Terms = reduced.iter().map(|(delay, p)| (*delay, product(p, &power))).collect();
        #[expect(clippy::cast_precision_loss, reason = "a handful")]
        let (integrators, order) =
            (pulse.integrators as f64, denominator.first().map_or(0, |(_, p)| p.len() - 1) as f64);
        let longest = denominator.iter().map(|(delay, _)| *delay).chain(delays()).fold(0.0, f64::max);
        let spread = delays().fold(0.0, f64::max) - shortest_delay;
        Self {
            numerator: pulse.numerator.iter().map(|(d, p)| (d - shortest_delay, p.clone())).collect(),
            shortest_delay,
            denominator,
            reduced,
            integrators,
            longest_delay: longest,
            spread,
            order,
            factors: pulse.prediction.is_none().then(|| pulse.factors.clone()),
        }
    }

    /// Jet of Δ.
    pub(super) fn closed(&self, theta: f64) -> Jet {
        self.at(theta).closed
    }

    /// Bounds of Δ and its derivatives up to this angle.
    pub(super) fn closed_bounds(&self, theta: f64) -> [f64; 4] {
        let bounds = rotated_bounds(&self.numerator_bounds(theta), self.shortest_delay);
        let denominator = self.denominator_bounds(theta);
        std::array::from_fn(|i| bounds[i] + denominator[i])
    }

    /// L, where D is not 0.
    pub(super) fn open(&self, theta: f64) -> Complex<f64> {
        let point = self.at(theta);
        point.delayed[0] / point.denominator[0]
    }

    /// Change of the argument of D over [from, to] with from > 0, where all its factors are known.
    pub(super) fn turn_of_denominator(&self, from: f64, to: f64) -> Option<f64> {
        let factors = self.factors.as_ref()?;
        // w = 2·sin(θ/2)·e^(j(θ + π)/2); the argument of a + b·w stays within 0 … π.
        let argument = |theta: f64, &(a, b): &(f64, f64)| (b * theta.sin()).atan2((a - b) + b * theta.cos());
        let turns = factors.iter().map(|factor| argument(to, factor) - argument(from, factor));
        Some(0.5 * self.integrators * (to - from) + turns.sum::<f64>())
    }
}

impl Curve for Circle {
    fn numerator(&self, theta: f64) -> Jet {
        jet(&self.numerator, theta)
    }

    fn denominator(&self, theta: f64) -> Jet {
        jet(&self.denominator, theta)
    }

    fn reduced(&self, theta: f64) -> Jet {
        // wᵏ is jᵏ·e^(jkθ/2) times a positive number.
        let turn = match self.integrators % 4.0 {
            0.0 => Complex::new(1.0, 0.0),
            1.0 => Complex::i(),
            2.0 => Complex::new(-1.0, 0.0),
            _ => -Complex::i(),
        };
        rotated(jet(&self.reduced, theta), -0.5 * self.integrators, theta).map(|z| z * turn)
    }

    fn numerator_bounds(&self, theta: f64) -> [f64; 4] {
        bounds(&self.numerator, theta)
    }

    fn denominator_bounds(&self, theta: f64) -> [f64; 4] {
        bounds(&self.denominator, theta)
    }

    fn reduced_bounds(&self, theta: f64) -> [f64; 4] {
        rotated_bounds(&bounds(&self.reduced, theta), 0.5 * self.integrators)
    }

    fn shortest_delay(&self) -> f64 {
        self.shortest_delay
    }

    fn longest_delay(&self) -> f64 {
        self.longest_delay
    }

    fn spread(&self) -> f64 {
        self.spread
    }
}

impl Modulus for Circle {
    fn gain_is_below(&self, bound: f64, from: f64, to: f64) -> bool {
        let Some(factors) = &self.factors else { return false };
        // Every factor of D grows along the half circle.
        let square = |&(a, b): &(f64, f64)| {
            let (re, im) = ((a - b) + b * from.cos(), b * from.sin());
            re * re + im * im
        };
        #[expect(clippy::cast_possible_truncation, reason = "a handful")]
        let integrators = chord(from).powi(self.integrators as i32);
        let least = integrators * factors.iter().map(square).product::<f64>().sqrt();
        bounds(&self.numerator, to)[0] * (1.0 + 1e-13) < bound * least
    }

    fn gain_is_above_one(&self, _: f64, _: f64) -> bool {
        false // near z = 1 Taylor polynomials show it at once
    }
}

/// |w| = |e^(jθ) − 1|.
fn chord(theta: f64) -> f64 {
    2.0 * (0.5 * theta.min(PI)).sin()
}

/// Value and two derivatives in θ of a sum of terms.
fn jet(terms: &Terms, theta: f64) -> Jet {
    let half = (0.5 * theta).sin();
    let w = Complex::new(-2.0 * half * half, theta.sin());
    let z = w + 1.0;
    let mut total = [Complex::new(0.0, 0.0); 3];
    for (delay, p) in terms {
        let zero = Complex::new(0.0, 0.0);
        let [p, dp, ddp] = p
            .iter()
            .rev()
            .fold([zero; 3], |[p, dp, half_ddp], &c| [p * w + c, dp * w + p, half_ddp * w + dp]);
        let ddp = ddp * 2.0;
        // dw/dθ = j·z, and z = 1 + w turns with it.
        let along = [p, z * dp * Complex::<f64>::i(), -z * (z * ddp + dp)];
        let turned = rotated(along, *delay, theta);
        for (sum, part) in total.iter_mut().zip(turned) {
            *sum += part;
        }
    }
    total
}

/// Bounds of the modulus and of the first three derivatives in θ, from 0 to `theta`.
fn bounds(terms: &Terms, theta: f64) -> [f64; 4] {
    let reach = chord(theta);
    let mut total = [0.0; 4];
    for (delay, p) in terms {
        let [mut b0, mut b1, mut b2, mut b3] = [0.0; 4];
        for c in p.iter().rev() {
            b3 = b3 * reach + b2;
            b2 = b2 * reach + b1;
            b1 = b1 * reach + b0;
            b0 = b0 * reach + c.abs();
        }
        let (b2, b3) = (2.0 * b2, 6.0 * b3);
        let along = [b0, b1, b2 + b1, b3 + 3.0 * b2 + b1];
        for (sum, part) in total.iter_mut().zip(rotated_bounds(&along, *delay)) {
            *sum += part;
        }
    }
    total
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_along_the_circle_are_those_of_powers_of_z() {
        // (1 + 2w + w²)·z^(−5) = z^(−3).
        let terms = vec![(5.0, vec![1.0, 2.0, 1.0])];
        for theta in [0.0, 0.4, 2.0, PI] {
            let z = Complex::from_polar(1.0, -3.0 * theta);
            let expected = [z, z * Complex::new(0.0, -3.0), z * -9.0];
            for (found, expected) in jet(&terms, theta).iter().zip(expected) {
                assert!((found - expected).norm() < 1e-13); // a dozen roundings of numbers up to 25
            }
            let bounds = bounds(&terms, theta);
            assert!(bounds.iter().zip([1.0, 3.0, 9.0, 27.0]).all(|(bound, value)| *bound >= value));
        }
    }
}
