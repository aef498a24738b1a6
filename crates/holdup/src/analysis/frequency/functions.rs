//! The real functions of frequency whose zeros and maxima are the crossovers and the peaks.

use num_complex::Complex;

use super::characteristic::Characteristic;
use super::quasi_polynomial::{Jet, QuasiPolynomial, rotated};
use super::taylor::Quadratic;

/// N, D and Δ of a loop prepared for evaluation on s = jω.
#[derive(Debug, Clone)]
pub(super) struct Functions {
    /// N with its shortest delay taken out: |N| without the rotation that does not change it.
    numerator: QuasiPolynomial,
    shortest_delay: f64,
    denominator: QuasiPolynomial,
    /// D/sᵏ: the sign of L near ω = 0 is then that of a function that does not vanish there.
    reduced: QuasiPolynomial,
    order_at_zero: usize,
    pub(super) longest_delay: f64,
}

/// Everything at one frequency: jets in ω.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    pub(super) omega: f64,
    /// N up to a rotation.
    pub(super) numerator: Jet,
    /// D.
    pub(super) denominator: Jet,
    /// Δ = N + D.
    pub(super) closed: Jet,
    /// L·|D|²/ωᵏ: L up to a positive factor.
    pub(super) direction: Jet,
}

/// Bounds of the derivatives 0 to 3 on |ω| ≤ the upper end of an interval.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    numerator: [f64; 4],
    denominator: [f64; 4],
    closed: [f64; 4],
    direction: [f64; 4],
}

impl Functions {
    pub(super) fn new(characteristic: &Characteristic) -> Self {
        let shortest_delay = characteristic.numerator.shortest_delay();
        let order_at_zero = characteristic.denominator.order_at_zero();
        Self {
            numerator: characteristic.numerator.advanced(shortest_delay),
            shortest_delay,
            denominator: characteristic.denominator.clone(),
            reduced: characteristic.denominator.divided_by_power(order_at_zero),
            order_at_zero,
            longest_delay: characteristic.closed.longest_delay(),
        }
    }

    pub(super) fn at(&self, omega: f64) -> Point {
        let numerator = self.numerator.on_axis(omega);
        let denominator = self.denominator.on_axis(omega);
        let delayed = rotated(numerator, self.shortest_delay, omega);
        let closed = std::array::from_fn(|i| delayed[i] + denominator[i]);
        Point { omega, numerator, denominator, closed, direction: self.direction_of(delayed, omega) }
    }

    /// L·|D|²/ωᵏ alone.
    pub(super) fn direction(&self, omega: f64) -> Jet {
        self.direction_of(rotated(self.numerator.on_axis(omega), self.shortest_delay, omega), omega)
    }

    fn direction_of(&self, delayed: Jet, omega: f64) -> Jet {
        let turn = |z: Complex<f64>| match self.order_at_zero % 4 {
            0 => z,
            1 => Complex::new(z.im, -z.re),
            2 => -z,
            _ => Complex::new(-z.im, z.re),
        };
        // 1/(jω)ᵏ = (−j)ᵏ/ωᵏ, and 1/D̃ = conj D̃/|D̃|².
        product(delayed, self.reduced.on_axis(omega)).map(turn)
    }

    pub(super) fn bounds(&self, omega: f64) -> Bounds {
        let numerator = self.numerator.magnitudes(omega);
        let denominator = self.denominator.magnitudes(omega);
        let reduced = if self.order_at_zero == 0 { denominator } else { self.reduced.magnitudes(omega) };
        let t = self.shortest_delay;
        let [n0, n1, n2, n3] = numerator;
        let delayed =
            [n0, n1 + t * n0, n2 + t * (2.0 * n1 + t * n0), n3 + t * (3.0 * n2 + t * (3.0 * n1 + t * n0))];
        let closed = std::array::from_fn(|i| delayed[i] + denominator[i]);
        let [p, q] = [delayed, reduced];
        let direction = [
            p[0] * q[0],
            p[1] * q[0] + p[0] * q[1],
            p[2] * q[0] + 2.0 * p[1] * q[1] + p[0] * q[2],
            p[3] * q[0] + 3.0 * (p[2] * q[1] + p[1] * q[2]) + p[0] * q[3],
        ];
        Bounds { numerator, denominator, closed, direction }
    }
}

/// Jet of `a·conj(b)`.
fn product(a: Jet, b: Jet) -> Jet {
    let b = b.map(|z| z.conj());
    [a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + a[1] * b[1] * 2.0 + a[0] * b[2]]
}

/// |z|² along the axis.
fn squared(z: &Jet) -> Quadratic {
    let dot = |a: Complex<f64>, b: Complex<f64>| a.re * b.re + a.im * b.im;
    Quadratic {
        f: dot(z[0], z[0]),
        df: 2.0 * dot(z[0], z[1]),
        ddf: 2.0 * (dot(z[1], z[1]) + dot(z[0], z[2])),
    }
}

/// `p − q`, term by term.
fn difference(p: Quadratic, q: Quadratic) -> Quadratic {
    Quadratic { f: p.f - q.f, df: p.df - q.df, ddf: p.ddf - q.ddf }
}

fn scaled(factor: f64, q: Quadratic) -> Quadratic {
    Quadratic { f: factor * q.f, df: factor * q.df, ddf: factor * q.ddf }
}

/// Bound of the third derivative of |z|², and the rounding error of its value.
fn squared_bounds(z: &[f64; 4]) -> (f64, f64) {
    (2.0 * (z[0] * z[3] + 3.0 * z[1] * z[2]), ROUNDING * z[0] * z[0])
}

/// Relative rounding error of a value: a Horner scheme of degree ≤ 15 and a product.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// Which of the two closed-loop transfer functions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Peak {
    /// S = D/Δ.
    Sensitivity,
    /// T = N/Δ.
    Complementary,
}

impl Point {
    /// |L|.
    pub(super) fn gain(&self) -> f64 {
        self.numerator[0].norm() / self.denominator[0].norm()
    }

    /// |N|² − |D|²: positive where |L| > 1.
    pub(super) fn gain_excess(&self) -> Quadratic {
        difference(squared(&self.numerator), squared(&self.denominator))
    }

    /// Imaginary part of L up to a positive factor.
    pub(super) fn imaginary(&self) -> Quadratic {
        let [f, df, ddf] = self.direction.map(|z| z.im);
        Quadratic { f, df, ddf }
    }

    /// Real part of L up to the same factor.
    pub(super) fn real(&self) -> Quadratic {
        let [f, df, ddf] = self.direction.map(|z| z.re);
        Quadratic { f, df, ddf }
    }

    /// `level²·|Δ|² − |D or N|²`: positive where |S| or |T| is less than `level`.
    pub(super) fn below(&self, peak: Peak, level: f64) -> Quadratic {
        difference(scaled(level * level, squared(&self.closed)), squared(self.top(peak)))
    }

    /// |S| or |T|.
    pub(super) fn peak_value(&self, peak: Peak) -> f64 {
        self.top(peak)[0].norm() / self.closed[0].norm()
    }

    /// First and second derivative of ln|S| or ln|T| in ω.
    pub(super) fn logarithmic(&self, peak: Peak) -> (f64, f64) {
        let log = |q: Quadratic| {
            let first = 0.5 * q.df / q.f;
            (first, 0.5 * q.ddf / q.f - 2.0 * first * first)
        };
        let (top, bottom) = (log(squared(self.top(peak))), log(squared(&self.closed)));
        (top.0 - bottom.0, top.1 - bottom.1)
    }

    fn top(&self, peak: Peak) -> &Jet {
        match peak {
            Peak::Sensitivity => &self.denominator,
            Peak::Complementary => &self.numerator,
        }
    }
}

/// For each function its bound of the third derivative and its rounding error.
impl Bounds {
    pub(super) fn gain_excess(&self) -> (f64, f64) {
        let (n, d) = (squared_bounds(&self.numerator), squared_bounds(&self.denominator));
        (n.0 + d.0, n.1 + d.1)
    }

    pub(super) fn direction(&self) -> (f64, f64) {
        (self.direction[3], ROUNDING * self.direction[0])
    }

    pub(super) fn below(&self, peak: Peak, level: f64, point: &Point) -> (f64, f64) {
        let top = match peak {
            Peak::Sensitivity => &self.denominator,
            Peak::Complementary => &self.numerator,
        };
        let (c, t) = (squared_bounds(&self.closed), squared_bounds(top));
        // Near a pole Δ is a small difference: the error of |Δ|² is that of Δ times |Δ|.
        let closed = ROUNDING * self.closed[0] * (point.closed[0].norm() + ROUNDING * self.closed[0]);
        (level * level * c.0 + t.0, level * level * closed + t.1)
    }
}
