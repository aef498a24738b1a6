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
    longest_delay: f64,
    spread: f64,
}

/// Everything at one frequency: jets in ω.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    pub(super) omega: f64,
    /// N up to a rotation.
    pub(super) numerator: Jet,
    /// D.
    pub(super) denominator: Jet,
    /// N.
    pub(super) delayed: Jet,
    /// Δ = N + D.
    pub(super) closed: Jet,
}

/// Bounds of the derivatives 0 to 3 on |ω| ≤ the upper end of an interval.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    numerator: [f64; 4],
    denominator: [f64; 4],
    /// Of N·conj(D), rotation included.
    cross: [f64; 4],
    /// Of N itself.
    delayed: [f64; 4],
}

/// N, D and Δ = N + D of a loop along the curve on which its stability is judged: the imaginary axis, s = jω, or for a
/// sampled loop the unit circle, z = e^(jω). ω counts radians per dead time or per sample.
pub(super) trait Curve {
    /// Jet of N with its shortest delay taken out.
    fn numerator(&self, omega: f64) -> Jet;
    /// Jet of D.
    fn denominator(&self, omega: f64) -> Jet;
    /// Jet of a positive multiple of D·(−j)ᵏ, k its zeros at ω = 0, that does not vanish there.
    fn reduced(&self, omega: f64) -> Jet;
    /// Bounds of the modulus of N and of its first three derivatives, up to this frequency.
    fn numerator_bounds(&self, omega: f64) -> [f64; 4];
    /// The same of D.
    fn denominator_bounds(&self, omega: f64) -> [f64; 4];
    /// The same of the reduced D.
    fn reduced_bounds(&self, omega: f64) -> [f64; 4];
    /// The delay that is taken out of N.
    fn shortest_delay(&self) -> f64;
    /// The longest delay of Δ: how fast it turns.
    fn longest_delay(&self) -> f64;
    /// Longest minus shortest delay of N: how fast |N| may oscillate.
    fn spread(&self) -> f64;

    /// Everything at one frequency.
    fn at(&self, omega: f64) -> Point {
        let numerator = self.numerator(omega);
        let denominator = self.denominator(omega);
        let delayed = rotated(numerator, self.shortest_delay(), omega);
        let closed = std::array::from_fn(|i| delayed[i] + denominator[i]);
        Point { omega, numerator, denominator, delayed, closed }
    }

    /// L·|D|²/ωᵏ alone, up to a positive factor.
    fn direction(&self, omega: f64) -> Jet {
        product(rotated(self.numerator(omega), self.shortest_delay(), omega), self.reduced(omega))
    }

    /// The same at a point already evaluated.
    fn direction_at(&self, point: &Point) -> Jet {
        product(point.delayed, self.reduced(point.omega))
    }

    /// For the direction up to the frequency `omega`: the bound of its third derivative and its rounding error.
    fn direction_bounds(&self, bounds: &Bounds, omega: f64) -> (f64, f64) {
        let direction = product_bounds(&bounds.delayed, &self.reduced_bounds(omega));
        (direction[3], ROUNDING * direction[0])
    }

    /// |L|.
    fn gain(&self, omega: f64) -> f64 {
        (self.numerator(omega)[0].norm_sqr() / self.denominator(omega)[0].norm_sqr()).sqrt()
    }

    /// |N|² − |D|², positive where |L| > 1, with its bound of the third derivative and its rounding error up to
    /// the frequency `end`.
    fn gain_excess(&self, omega: f64, end: f64) -> (Quadratic, f64, f64) {
        let (n, d) = (self.numerator(omega), self.denominator(omega));
        let n_bounds = squared_bounds(&self.numerator_bounds(end));
        let d_bounds = squared_bounds(&self.denominator_bounds(end));
        (difference(squared(&n), squared(&d)), n_bounds.0 + d_bounds.0, n_bounds.1 + d_bounds.1)
    }

    /// The bounds up to this frequency.
    fn bounds(&self, omega: f64) -> Bounds {
        let (numerator, denominator) = (self.numerator_bounds(omega), self.denominator_bounds(omega));
        let delayed = rotated_bounds(&numerator, self.shortest_delay());
        let cross = product_bounds(&delayed, &denominator);
        Bounds { numerator, denominator, cross, delayed }
    }
}

impl Functions {
    pub(super) fn new(characteristic: &Characteristic) -> Self {
        let shortest_delay = characteristic.numerator.shortest_delay();
        let order_at_zero = characteristic.denominator.order_at_zero();
        Self {
            spread: characteristic.numerator.longest_delay() - shortest_delay,
            numerator: characteristic.numerator.advanced(shortest_delay),
            shortest_delay,
            denominator: characteristic.denominator.clone(),
            reduced: characteristic.denominator.divided_by_power(order_at_zero),
            order_at_zero,
            longest_delay: characteristic.closed.longest_delay(),
        }
    }
}

impl Curve for Functions {
    fn numerator(&self, omega: f64) -> Jet {
        self.numerator.on_axis(omega)
    }

    fn denominator(&self, omega: f64) -> Jet {
        self.denominator.on_axis(omega)
    }

    fn reduced(&self, omega: f64) -> Jet {
        // D/(jω)ᵏ·ωᵏ: what is turned back by jᵏ here turns N·conj(D) by (−j)ᵏ.
        let turn = |z: Complex<f64>| match self.order_at_zero % 4 {
            0 => z,
            1 => Complex::new(-z.im, z.re),
            2 => -z,
            _ => Complex::new(z.im, -z.re),
        };
        self.reduced.on_axis(omega).map(turn)
    }

    fn numerator_bounds(&self, omega: f64) -> [f64; 4] {
        self.numerator.magnitudes(omega)
    }

    fn denominator_bounds(&self, omega: f64) -> [f64; 4] {
        self.denominator.magnitudes(omega)
    }

    fn reduced_bounds(&self, omega: f64) -> [f64; 4] {
        self.reduced.magnitudes(omega)
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

/// Bounds of the derivatives of `p·e^(−jτω)` from those of p.
pub(super) fn rotated_bounds(&[b0, b1, b2, b3]: &[f64; 4], t: f64) -> [f64; 4] {
    [b0, b1 + t * b0, b2 + t * (2.0 * b1 + t * b0), b3 + t * (3.0 * b2 + t * (3.0 * b1 + t * b0))]
}

/// Jet of `a·conj(b)`.
pub(super) fn product(a: Jet, b: Jet) -> Jet {
    let b = b.map(|z| z.conj());
    [a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + a[1] * b[1] * 2.0 + a[0] * b[2]]
}

/// Imaginary part along the axis.
pub(super) fn imaginary(jet: &Jet) -> Quadratic {
    let [f, df, ddf] = jet.map(|z| z.im);
    Quadratic { f, df, ddf }
}

/// Real part along the axis.
pub(super) fn real(jet: &Jet) -> Quadratic {
    let [f, df, ddf] = jet.map(|z| z.re);
    Quadratic { f, df, ddf }
}

/// Bounds of the derivatives of a product.
pub(super) fn product_bounds(p: &[f64; 4], q: &[f64; 4]) -> [f64; 4] {
    [
        p[0] * q[0],
        p[1] * q[0] + p[0] * q[1],
        p[2] * q[0] + 2.0 * p[1] * q[1] + p[0] * q[2],
        p[3] * q[0] + 3.0 * (p[2] * q[1] + p[1] * q[2]) + p[0] * q[3],
    ]
}

/// |z|² along the axis.
pub(super) fn squared(z: &Jet) -> Quadratic {
    let dot = |a: Complex<f64>, b: Complex<f64>| a.re * b.re + a.im * b.im;
    Quadratic {
        f: dot(z[0], z[0]),
        df: 2.0 * dot(z[0], z[1]),
        ddf: 2.0 * (dot(z[1], z[1]) + dot(z[0], z[2])),
    }
}

/// `p − q`, term by term.
pub(super) fn difference(p: Quadratic, q: Quadratic) -> Quadratic {
    Quadratic { f: p.f - q.f, df: p.df - q.df, ddf: p.ddf - q.ddf }
}

pub(super) fn sum(p: Quadratic, q: Quadratic) -> Quadratic {
    Quadratic { f: p.f + q.f, df: p.df + q.df, ddf: p.ddf + q.ddf }
}

pub(super) fn scaled(factor: f64, q: Quadratic) -> Quadratic {
    Quadratic { f: factor * q.f, df: factor * q.df, ddf: factor * q.ddf }
}

/// Bound of the third derivative of |z|², and the rounding error of its value.
pub(super) fn squared_bounds(z: &[f64; 4]) -> (f64, f64) {
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
    /// `level²·|Δ|² − |D or N|²`: positive where |S| or |T| is less than `level`.
    ///
    /// Where L is small (or large) Δ and its top are nearly equal: the difference is then formed term by term,
    /// `(level² − 1)·|D|² + level²·(|N|² + 2·Re(N·conj D))` for S, with D and N exchanged for T.
    pub(super) fn below(&self, peak: Peak, level: f64) -> Quadratic {
        let (top, other) = self.top_and_other(peak);
        let square = level * level;
        if !self.top_prevails(peak) {
            return difference(scaled(square, squared(&self.closed)), squared(top));
        }
        let cross = product(self.delayed, self.denominator).map(|z| 2.0 * z.re);
        let [f, df, ddf] = cross;
        let rest = sum(squared(other), Quadratic { f, df, ddf });
        sum(scaled((level - 1.0) * (level + 1.0), squared(top)), scaled(square, rest))
    }

    /// Whether |D| (for S) or |N| (for T) is well above the other.
    fn top_prevails(&self, peak: Peak) -> bool {
        let (top, other) = self.top_and_other(peak);
        top[0].norm_sqr() > 4.0 * other[0].norm_sqr()
    }

    fn top_and_other(&self, peak: Peak) -> (&Jet, &Jet) {
        match peak {
            Peak::Sensitivity => (&self.denominator, &self.numerator),
            Peak::Complementary => (&self.numerator, &self.denominator),
        }
    }

    /// |S| or |T|.
    pub(super) fn peak_value(&self, peak: Peak) -> f64 {
        (self.top_and_other(peak).0[0].norm_sqr() / self.closed[0].norm_sqr()).sqrt()
    }

    /// First and second derivative of ln|S| or ln|T| in ω.
    pub(super) fn logarithmic(&self, peak: Peak) -> (f64, f64) {
        let log = |q: Quadratic| {
            let first = 0.5 * q.df / q.f;
            (first, 0.5 * q.ddf / q.f - 2.0 * first * first)
        };
        let (top, bottom) = (log(squared(self.top_and_other(peak).0)), log(squared(&self.closed)));
        (top.0 - bottom.0, top.1 - bottom.1)
    }
}

/// For each function its bound of the third derivative and its rounding error.
impl Bounds {
    pub(super) fn below(&self, peak: Peak, level: f64, point: &Point) -> (f64, f64) {
        let (n, d) = (squared_bounds(&self.numerator), squared_bounds(&self.denominator));
        let (top, other) = match peak {
            Peak::Sensitivity => (d, n),
            Peak::Complementary => (n, d),
        };
        let (square, excess) = (level * level, (level - 1.0) * (level + 1.0));
        let third = excess * top.0 + square * (other.0 + 2.0 * self.cross[3]);
        let rounding = if point.top_prevails(peak) {
            excess * top.1 + square * (other.1 + 2.0 * ROUNDING * self.cross[0])
        } else {
            // Near a pole Δ is a small difference: the error of |Δ|² is that of Δ times |Δ|.
            let magnitude = self.numerator[0] + self.denominator[0];
            let closed = ROUNDING * magnitude * (point.closed[0].norm() + ROUNDING * magnitude);
            square * closed + top.1
        };
        (third, rounding)
    }
}
