//! The distance of a sector from −1 over a band of frequencies, to second order.
//!
//! The least distance lies on an arc, on an edge of one dead time, or in a corner. Each of them is a real function of
//! N and D alone, without arguments: its Taylor polynomial at the middle of the band and a bound of its third derivative
//! prove it positive. Next to the worst frequency, where the distance is flat, bands may then be wide.

use crate::analysis::frequency::functions::{
    difference, imaginary, product, product_bounds, real, rotated_bounds, scaled, squared, squared_bounds,
    sum,
};
use crate::analysis::frequency::quasi_polynomial::{Jet, rotated};
use crate::analysis::frequency::taylor::Quadratic;

/// N, without the delays of the family, and D on a band: jets at its middle, bounds over it.
pub(super) struct Faces<'a> {
    pub(super) omega: f64,
    /// Half the width of the band.
    pub(super) half: f64,
    pub(super) numerator: &'a Jet,
    pub(super) denominator: &'a Jet,
    pub(super) numerator_bounds: &'a [f64; 4],
    pub(super) denominator_bounds: &'a [f64; 4],
}

impl Faces<'_> {
    /// Whether every member whose factor on the gain and whose delay are in these ranges is proven to keep
    /// `|D + k·N·e^(−jωτ)| > wanted·|D|` on the band; `towards` says whether one of them points at −1 at its middle.
    pub(super) fn keep(&self, gain: [f64; 2], delay: [f64; 2], wanted: f64, towards: bool) -> bool {
        let (n, d) = (squared(self.numerator), squared(self.denominator));
        let (of_n, of_d) = (squared_bounds(self.numerator_bounds), squared_bounds(self.denominator_bounds));
        // The greatest modulus is far enough below that of −1, or the least above.
        let arc = |k: f64, at: f64, sign: f64| {
            let (p, q) = (scaled(sign * at * at, d), scaled(sign * k * k, n));
            let bounds = (at * at * of_d.0 + k * k * of_n.0, at * at * of_d.1 + k * k * of_n.1);
            self.positive(difference(p, q), bounds)
        };
        if arc(gain[1], 1.0 - wanted, 1.0) || arc(gain[0], 1.0 + wanted, -1.0) {
            return true;
        }
        !towards && delay.into_iter().all(|delay| self.edge_keeps(gain, delay, wanted))
    }

    /// The same for one delay; and L does not point at −1 anywhere on the band. Where that holds for the least and
    /// the greatest delay and at the middle of the band for those between, they are farther from −1 than one of the two.
    fn edge_keeps(&self, [least, greatest]: [f64; 2], delay: f64, wanted: f64) -> bool {
        let turned = rotated(*self.numerator, delay, self.omega);
        let turned_bounds = rotated_bounds(self.numerator_bounds, delay.abs());
        // N·e^(−jωτ)·conj D has the angle of L.
        let way = product(turned, *self.denominator);
        let [z0, z1, z2, z3] = product_bounds(&turned_bounds, self.denominator_bounds);
        let linear = (z3, 8.0 * ROUNDING * z0);
        let (towards, across) = (scaled(-1.0, real(&way)), imaginary(&way));
        let aside = self.positive(across, linear)
            || self.positive(scaled(-1.0, across), linear)
            || self.positive(scaled(-1.0, towards), linear);
        if !aside {
            return false;
        }
        // The whole ray keeps the distance: sin² of the angle.
        let square = squares(across);
        let third = 2.0 * (z0 * z3 + 3.0 * z1 * z2);
        let ray = difference(square, scaled(wanted * wanted, squared(&way)));
        let rest = (1.0 + wanted * wanted) * third;
        if self.positive(ray, (rest, 16.0 * ROUNDING * z0 * z0)) {
            return true;
        }
        let size = squared(self.numerator);
        let of_size = squared_bounds(self.numerator_bounds);
        let corner = |k: f64| {
            let closed: Jet = std::array::from_fn(|i| self.denominator[i] + turned[i] * k);
            let bounds: [f64; 4] = std::array::from_fn(|i| self.denominator_bounds[i] + k * turned_bounds[i]);
            let square = wanted * wanted;
            let function = difference(squared(&closed), scaled(square, squared(self.denominator)));
            let (third, _) = squared_bounds(&bounds);
            let (third_of_d, rounding) = squared_bounds(self.denominator_bounds);
            let own = ROUNDING * bounds[0];
            let rounding = 2.0 * own * (closed[0].norm() + own) + square * rounding;
            self.positive(function, (third + square * third_of_d, rounding))
        };
        // P − k·|N|² tells whether the foot of the perpendicular lies beyond k.
        let beyond = |k: f64, sign: f64| {
            let function = scaled(sign, sum(towards, scaled(-k, size)));
            self.positive(function, (z3 + k * of_size.0, linear.1 + k * of_size.1))
        };
        (beyond(greatest, 1.0) && corner(greatest)) || (beyond(least, -1.0) && corner(least))
    }

    fn positive(&self, function: Quadratic, (third, rounding): (f64, f64)) -> bool {
        function.range(self.half).0 > third * self.half.powi(3) / 6.0 + rounding
    }
}

/// Relative rounding error of a value: a Horner scheme, a rotation and a product.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The square of a real function.
fn squares(q: Quadratic) -> Quadratic {
    Quadratic { f: q.f * q.f, df: 2.0 * q.f * q.df, ddf: 2.0 * (q.df * q.df + q.f * q.ddf) }
}
