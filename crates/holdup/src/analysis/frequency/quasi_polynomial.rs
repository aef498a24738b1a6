//! Quasi-polynomials Σ pₖ(s)·e^(−τₖ·s): what a loop with dead time has for polynomials.

use num_complex::Complex;

use super::polynomial::Polynomial;

/// Value and first two derivatives in ω of a function on s = jω.
pub(super) type Jet = [Complex<f64>; 3];

/// Σ pₖ(s)·e^(−τₖ·s) with real polynomials, time counted in dead times of the process.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct QuasiPolynomial {
    terms: Vec<(f64, Polynomial)>,
}

impl QuasiPolynomial {
    /// Adds `value·s^power·e^(−delay·s)`.
    pub(super) fn add_to(&mut self, delay: f64, power: usize, value: f64) {
        if let Some((_, p)) = self.terms.iter_mut().find(|(d, _)| *d == delay) {
            p.add_to(power, value);
        } else if value != 0.0 {
            let mut p = Polynomial::ZERO;
            p.add_to(power, value);
            self.terms.push((delay, p));
        }
    }

    /// Delays and polynomials.
    pub(super) fn terms(&self) -> &[(f64, Polynomial)] {
        &self.terms
    }

    /// Puts the terms in order of their delays and removes those that cancelled.
    pub(super) fn sort(&mut self) {
        self.terms.retain(|(_, p)| !p.is_zero());
        self.terms.sort_by(|a, b| a.0.total_cmp(&b.0));
    }

    /// Shortest delay.
    pub(super) fn shortest_delay(&self) -> f64 {
        self.terms.first().map_or(0.0, |(delay, _)| *delay)
    }

    /// Longest delay.
    pub(super) fn longest_delay(&self) -> f64 {
        self.terms.last().map_or(0.0, |(delay, _)| *delay)
    }

    /// The same with every delay shortened by `by`: on the axis a rotation, the modulus stays.
    pub(super) fn advanced(&self, by: f64) -> Self {
        Self { terms: self.terms.iter().map(|&(delay, p)| (delay - by, p)).collect() }
    }

    /// The quasi-polynomial in `s − by`: its zeros lie by that much farther to the right.
    pub(super) fn shifted(&self, by: f64) -> Self {
        let term = |&(delay, p): &(f64, Polynomial)| {
            (delay, Polynomial::ZERO.plus(&p.shifted(-by), (delay * by).exp()))
        };
        Self { terms: self.terms.iter().map(term).collect() }
    }

    /// How often s divides every polynomial.
    pub(super) fn order_at_zero(&self) -> usize {
        self.terms.iter().map(|(_, p)| p.order_at_zero()).min().unwrap_or(0)
    }

    /// This divided by `s^order`.
    pub(super) fn divided_by_power(&self, order: usize) -> Self {
        Self { terms: self.terms.iter().map(|&(delay, p)| (delay, p.divided_by_power(order))).collect() }
    }

    /// Value and derivatives on s = jω.
    pub(super) fn on_axis(&self, omega: f64) -> Jet {
        let mut sum = [Complex::new(0.0, 0.0); 3];
        for (delay, p) in &self.terms {
            let jet = rotated(p.on_axis(omega), *delay, omega);
            for (s, v) in sum.iter_mut().zip(jet) {
                *s += v;
            }
        }
        sum
    }

    /// Value and derivative in s at any complex s.
    pub(super) fn at(&self, s: Complex<f64>) -> [Complex<f64>; 2] {
        self.terms.iter().fold([Complex::new(0.0, 0.0); 2], |[f, df], (delay, p)| {
            let [value, derivative] = p.at(s);
            let lag = (-s * delay).exp();
            [f + value * lag, df + (derivative - value * *delay) * lag]
        })
    }

    /// Bounds of the modulus and of the first three derivatives in ω on |ω| ≤ `omega`.
    pub(super) fn magnitudes(&self, omega: f64) -> [f64; 4] {
        let mut sum = [0.0; 4];
        for (t, p) in &self.terms {
            let [b0, b1, b2, b3] = p.magnitudes(omega);
            sum[0] += b0;
            sum[1] += b1 + t * b0;
            sum[2] += b2 + t * (2.0 * b1 + t * b0);
            sum[3] += b3 + t * (3.0 * b2 + t * (3.0 * b1 + t * b0));
        }
        sum
    }
}

/// The jet of `p(ω)·e^(−jτω)` from the jet of p.
pub(super) fn rotated(p: Jet, delay: f64, omega: f64) -> Jet {
    if delay == 0.0 {
        return p;
    }
    let (sin, cos) = (delay * omega).sin_cos();
    let e = Complex::new(cos, -sin);
    let minus_j = |z: Complex<f64>| Complex::new(z.im, -z.re) * delay;
    let first = p[1] + minus_j(p[0]);
    let second = p[2] + minus_j(p[1]) * 2.0 - p[0] * (delay * delay);
    [p[0] * e, first * e, second * e]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jets_on_the_axis_agree_with_difference_quotients() {
        let mut q = QuasiPolynomial::default();
        q.add_to(0.0, 2, 1.0);
        q.add_to(1.0, 1, 0.7);
        q.add_to(1.0, 0, 0.2);
        q.add_to(1.5, 0, -0.4);
        let (w, h) = (1.3, 1e-4);
        let [f, df, ddf] = q.on_axis(w);
        let [up, down] = [q.on_axis(w + h)[0], q.on_axis(w - h)[0]];
        // Central differences: error h²/6·f''' ≈ 1e-8, rounding 1e-16/h² = 1e-8 in the second.
        assert!((df - (up - down) / (2.0 * h)).norm() < 1e-7);
        assert!((ddf - (up + down - f * 2.0) / (h * h)).norm() < 1e-6);
        let bounds = q.magnitudes(w);
        assert!(f.norm() <= bounds[0] && df.norm() <= bounds[1] && ddf.norm() <= bounds[2]);
        let [value, derivative] = q.at(Complex::new(0.0, w));
        // The same sums in another order: a few roundings.
        assert!((value - f).norm() < 1e-14 && (derivative * Complex::i() - df).norm() < 1e-14);
    }
}
