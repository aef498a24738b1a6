//! Real polynomials of low degree, held without allocation.

use num_complex::Complex;

/// Coefficients a polynomial can hold: degree 15, that of p and of |p(jω)|² in ω² for every loop admitted.
const CAPACITY: usize = 16;

/// A polynomial with real coefficients, lowest power first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Polynomial {
    coefficients: [f64; CAPACITY],
    length: usize,
}

impl Polynomial {
    /// The polynomial 0.
    pub(super) const ZERO: Self = Self { coefficients: [0.0; CAPACITY], length: 0 };

    /// The polynomial of these coefficients, lowest power first; what exceeds the capacity is dropped.
    pub(super) fn new(coefficients: &[f64]) -> Self {
        let mut polynomial = Self::ZERO;
        for (power, &c) in coefficients.iter().enumerate() {
            polynomial.add_to(power, c);
        }
        polynomial
    }

    /// Adds `value` to the coefficient of this power.
    pub(super) fn add_to(&mut self, power: usize, value: f64) {
        if power < CAPACITY && value != 0.0 {
            self.coefficients[power] += value;
            self.length = self.length.max(power + 1);
        }
    }

    pub(super) fn coefficients(&self) -> &[f64] {
        &self.coefficients[..self.length]
    }

    /// The coefficient of this power.
    pub(super) fn coefficient(&self, power: usize) -> f64 {
        self.coefficients().get(power).copied().unwrap_or(0.0)
    }

    /// Whether every coefficient is 0.
    pub(super) fn is_zero(&self) -> bool {
        self.coefficients().iter().all(|&c| c == 0.0)
    }

    /// How often s divides this polynomial.
    pub(super) fn order_at_zero(&self) -> usize {
        self.coefficients().iter().take_while(|&&c| c == 0.0).count()
    }

    /// This polynomial divided by `s^order`; the lower coefficients are dropped.
    pub(super) fn divided_by_power(&self, order: usize) -> Self {
        Self::new(self.coefficients().get(order..).unwrap_or(&[]))
    }

    /// This polynomial plus `factor` times `other`.
    pub(super) fn plus(mut self, other: &Self, factor: f64) -> Self {
        for (c, o) in self.coefficients.iter_mut().zip(other.coefficients()) {
            *c += factor * o;
        }
        self.length = self.length.max(other.length);
        self
    }

    /// p at `jω` and its first two derivatives in ω.
    pub(super) fn on_axis(&self, omega: f64) -> [Complex<f64>; 3] {
        // Horner with s = jω: multiplying by s turns (re, im) into (−ω·im, ω·re).
        let (mut p, mut dp, mut ddp) = ((0.0, 0.0), (0.0, 0.0), (0.0, 0.0));
        for &c in self.coefficients().iter().rev() {
            ddp = (dp.0 - omega * ddp.1, dp.1 + omega * ddp.0);
            dp = (p.0 - omega * dp.1, p.1 + omega * dp.0);
            p = (c - omega * p.1, omega * p.0);
        }
        // d/dω = j·d/ds, d²/dω² = −d²/ds²; `ddp` holds half the second derivative.
        [Complex::new(p.0, p.1), Complex::new(-dp.1, dp.0), Complex::new(-2.0 * ddp.0, -2.0 * ddp.1)]
    }

    /// p and dp/ds at any complex s.
    pub(super) fn at(&self, s: Complex<f64>) -> [Complex<f64>; 2] {
        let zero = Complex::new(0.0, 0.0);
        self.coefficients().iter().rev().fold([zero, zero], |[p, dp], &c| [p * s + c, dp * s + p])
    }

    /// Value at a real argument.
    pub(super) fn value(&self, x: f64) -> f64 {
        self.coefficients().iter().rev().fold(0.0, |sum, c| sum * x + c)
    }

    /// Bounds of |p| and of its first three derivatives, in modulus, on the disc of radius `x`.
    pub(super) fn magnitudes(&self, x: f64) -> [f64; 4] {
        let mut b = [0.0; 4];
        for &c in self.coefficients().iter().rev() {
            b[3] = b[3] * x + b[2];
            b[2] = b[2] * x + b[1];
            b[1] = b[1] * x + b[0];
            b[0] = b[0] * x + c.abs();
        }
        [b[0], b[1], 2.0 * b[2], 6.0 * b[3]]
    }

    /// |p(jω)|² as a polynomial in ω².
    pub(super) fn squared_magnitude(&self) -> Self {
        let mut square = Self::ZERO;
        for (i, a) in self.coefficients().iter().enumerate() {
            for (l, b) in self.coefficients().iter().enumerate() {
                if (i + l) % 2 == 0 {
                    let sign = if i.abs_diff(l) % 4 == 0 { 1.0 } else { -1.0 };
                    square.add_to(usize::midpoint(i, l), sign * a * b);
                }
            }
        }
        square
    }

    /// A constant C such that `|dp/ds| ≤ C/ω·|p|` is proven at s = jω for every ω ≥ `from`.
    pub(super) fn logarithmic_bound(&self, from: f64) -> Option<f64> {
        let degree = self.length.saturating_sub(1);
        #[expect(clippy::cast_precision_loss, reason = "at most 15")]
        let bound = 1.2 * degree as f64;
        if self.is_zero() || degree == 0 {
            return (!self.is_zero()).then_some(0.0);
        }
        // Zeros on the real axis are at least ω away from jω: C = degree. The proof covers the others.
        let mut steepness = Self::ZERO; // s·dp/ds
        for (power, &c) in self.coefficients().iter().enumerate() {
            #[expect(clippy::cast_precision_loss, reason = "at most 15")]
            steepness.add_to(power, power as f64 * c);
        }
        let excess = Self::ZERO.plus(&self.squared_magnitude(), bound * bound);
        let excess = excess.plus(&steepness.squared_magnitude(), -1.0);
        excess.positive_beyond(from * from).then_some(bound)
    }

    /// The polynomial `p(x + shift)`.
    pub(super) fn shifted(mut self, shift: f64) -> Self {
        let n = self.length;
        for i in 1..n {
            for k in (i - 1..n - 1).rev() {
                self.coefficients[k] += shift * self.coefficients[k + 1];
            }
        }
        self
    }

    /// Whether the polynomial is proven greater than `floor` on [from, to], by its Bernstein coefficients.
    pub(super) fn exceeds(&self, floor: f64, from: f64, to: f64) -> bool {
        let mut b = self.shifted(from);
        let n = b.length;
        if n == 0 {
            return floor < 0.0;
        }
        // Power basis on the unit interval divided by the binomials, then running sums.
        let (mut scale, mut binomial) = (1.0, 1.0);
        for i in 0..n {
            b.coefficients[i] *= scale / binomial;
            scale *= to - from;
            #[expect(clippy::cast_precision_loss, reason = "at most 15")]
            let ratio = (n - 1 - i) as f64 / (i + 1) as f64;
            binomial *= ratio;
        }
        for i in 1..n {
            for k in (i..n).rev() {
                b.coefficients[k] += b.coefficients[k - 1];
            }
        }
        b.coefficients().iter().all(|&c| c > floor)
    }

    /// Whether the polynomial is proven positive on [from, ∞), by the signs of its Taylor coefficients.
    pub(super) fn positive_beyond(&self, from: f64) -> bool {
        let taylor = self.shifted(from);
        let (scale, mut power) = (self.magnitudes(from)[0], 1.0);
        for &c in taylor.coefficients() {
            // A coefficient that should be 0 comes out as rounding noise of either sign.
            if c.is_nan() || c < 0.0 && (from == 0.0 || c * power < -1e-14 * scale) {
                return false;
            }
            power *= from;
        }
        taylor.coefficient(0) > 1e-14 * scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_along_the_axis_are_those_of_the_powers() {
        let cube = Polynomial::new(&[0.0, 0.0, 0.0, 1.0]); // s³ = −jω³
        let [p, dp, ddp] = cube.on_axis(2.0);
        assert_eq!((p.re, p.im), (0.0, -8.0));
        assert_eq!((dp.re, dp.im), (0.0, -12.0));
        assert_eq!((ddp.re, ddp.im), (0.0, -12.0));
        assert_eq!(cube.magnitudes(2.0), [8.0, 12.0, 12.0, 6.0]);
    }

    #[test]
    fn squared_magnitude_is_a_polynomial_in_the_square_of_the_frequency() {
        let p = Polynomial::new(&[2.0, 3.0, 1.0]); // |2 − x + 3jω|² = (2 − x)² + 9x
        assert_eq!(p.squared_magnitude().coefficients(), &[4.0, 5.0, 1.0]);
    }

    #[test]
    fn bernstein_coefficients_prove_a_sign() {
        let p = Polynomial::new(&[1.01, -2.0, 1.0]); // (x − 1)² + 0.01
        assert!(p.exceeds(0.0, 0.9, 1.05));
        assert!(!p.exceeds(0.02, 0.9, 1.1));
        assert!(p.positive_beyond(1.0));
        assert!(!p.positive_beyond(0.5)); // positive, but not by this test
    }
}
