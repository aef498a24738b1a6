//! Taylor series of functions of two variables, and bounds of their coefficients on a box.

use num_complex::Complex;

/// Real Taylor coefficients up to second order: 1, x, t, x², xt, t².
#[derive(Debug, Clone, Copy)]
pub(super) struct Series([f64; 6]);

/// Bounds on a box of the moduli of the Taylor coefficients up to third order: those of [`Series`], then x³,
/// x²t, xt², t³.
#[derive(Debug, Clone, Copy)]
pub(super) struct Majorant(pub(super) [f64; 10]);

/// Real and imaginary part of `a·conj(b)`.
pub(super) fn joint(a: &[Complex<f64>; 6], b: &[Complex<f64>; 6]) -> (Series, Series) {
    let b = b.map(|z| z.conj());
    let all = [
        a[0] * b[0],
        a[0] * b[1] + a[1] * b[0],
        a[0] * b[2] + a[2] * b[0],
        a[0] * b[3] + a[1] * b[1] + a[3] * b[0],
        a[0] * b[4] + a[1] * b[2] + a[2] * b[1] + a[4] * b[0],
        a[0] * b[5] + a[2] * b[2] + a[5] * b[0],
    ];
    (Series(all.map(|z| z.re)), Series(all.map(|z| z.im)))
}

/// |a|².
pub(super) fn magnitude(a: &[Complex<f64>; 6]) -> Series {
    joint(a, a).0
}

impl Series {
    pub(super) fn value(&self) -> f64 {
        self.0[0]
    }

    pub(super) fn scaled(&self, factor: f64) -> Self {
        Self(self.0.map(|c| factor * c))
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        let complex = |s: &Self| s.0.map(|c| Complex::new(c, 0.0));
        joint(&complex(self), &complex(other)).0
    }

    /// Whether the function is proven positive, beyond the rounding error `noise`, within `width` and `height` of the middle.
    pub(super) fn exceeds(&self, noise: f64, majorant: &Majorant, width: f64, height: f64) -> bool {
        let [c, x, t, xx, xt, tt] = self.0;
        let linear = c - x.abs() * width - t.abs() * height;
        let quadratic =
            xx.min(0.0) * width * width + tt.min(0.0) * height * height - xt.abs() * width * height;
        linear + quadratic > majorant.rest(width, height) + noise
    }

    /// Whether the function is proven convex there.
    pub(super) fn convex(&self, majorant: &Majorant, width: f64, height: f64) -> bool {
        let [_, _, _, xx, xt, tt] = self.0;
        let [_, _, _, _, _, _, xxx, xxt, xtt, ttt] = majorant.0;
        let first = 2.0 * xx - 6.0 * xxx * width - 2.0 * xxt * height;
        let last = 2.0 * tt - 6.0 * ttt * height - 2.0 * xtt * width;
        let mixed = xt.abs() + 2.0 * xxt * width + 2.0 * xtt * height;
        first > 0.0 && last > 0.0 && first * last > mixed * mixed
    }

    /// Whether the tangent plane at the middle is above `floor` on the box from `low` to `high`.
    pub(super) fn tangent_plane_exceeds(&self, floor: f64, low: (f64, f64), high: (f64, f64)) -> bool {
        let least = |slope: f64, low: f64, high: f64| (slope * low).min(slope * high);
        self.0[0] + least(self.0[1], low.0, high.0) + least(self.0[2], low.1, high.1) > floor
    }

    /// A step towards the least value on the box from `low` to `high`.
    pub(super) fn step(&self, low: (f64, f64), high: (f64, f64)) -> (f64, f64) {
        let [_, x, t, xx, xt, tt] = self.0;
        let determinant = 4.0 * xx * tt - xt * xt;
        let dx = ((xt * t - 2.0 * tt * x) / determinant).clamp(low.0, high.0);
        // The least value along θ for this x.
        let dt = (-(t + xt * dx) / (2.0 * tt)).clamp(low.1, high.1);
        (dx, dt)
    }

    /// How far the function is from certain in either direction.
    pub(super) fn uncertainty(&self, majorant: &Majorant, width: f64, height: f64) -> (f64, f64) {
        let [_, x, t, xx, xt, tt] = self.0.map(f64::abs);
        let [_, _, _, _, _, _, xxx, xxt, xtt, ttt] = majorant.0;
        let mixed = xt * height + xxt * width * height + xtt * height * height;
        (
            width * (x + mixed + width * (xx + width * xxx)),
            height * (t + mixed * width / height + height * (tt + height * ttt)),
        )
    }
}

impl Majorant {
    pub(super) fn scaled(&self, factor: f64) -> Self {
        Self(self.0.map(|c| factor * c))
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        let (a, b) = (&self.0, &other.0);
        Self([
            a[0] * b[0],
            a[0] * b[1] + a[1] * b[0],
            a[0] * b[2] + a[2] * b[0],
            a[0] * b[3] + a[1] * b[1] + a[3] * b[0],
            a[0] * b[4] + a[1] * b[2] + a[2] * b[1] + a[4] * b[0],
            a[0] * b[5] + a[2] * b[2] + a[5] * b[0],
            a[0] * b[6] + a[1] * b[3] + a[3] * b[1] + a[6] * b[0],
            a[0] * b[7] + a[1] * b[4] + a[2] * b[3] + a[3] * b[2] + a[4] * b[1] + a[7] * b[0],
            a[0] * b[8] + a[1] * b[5] + a[2] * b[4] + a[4] * b[2] + a[5] * b[1] + a[8] * b[0],
            a[0] * b[9] + a[2] * b[5] + a[5] * b[2] + a[9] * b[0],
        ])
    }

    pub(super) fn squared(&self) -> Self {
        self.times(self)
    }

    /// Bound of the third-order rest.
    fn rest(&self, width: f64, height: f64) -> f64 {
        let [.., xxx, xxt, xtt, ttt] = self.0;
        width * (width * (xxx * width + xxt * height) + xtt * height * height)
            + ttt * height * height * height
    }
}
