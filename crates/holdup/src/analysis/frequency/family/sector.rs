//! The distance of a sector of an annulus from −1.

use std::f64::consts::{PI, TAU};

/// The points `r·e^(jθ)` with r and θ in these ranges.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sector {
    /// Least and greatest modulus, ≥ 0.
    pub(crate) radius: [f64; 2],
    /// From angle to angle \[rad\], rising; 2π or more is the whole annulus.
    pub(crate) angle: [f64; 2],
}

/// A point of a sector and its distance from −1.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Nearest {
    pub(crate) distance: f64,
    pub(crate) radius: f64,
    pub(crate) angle: f64,
    /// Whether a point of the sector has the angle of −1.
    pub(crate) towards: bool,
}

impl Sector {
    /// The point nearest to −1.
    ///
    /// `|1 + r·e^(jθ)|² = (r − cos ψ)² + sin² ψ` with ψ = θ − π: it falls with |ψ|, and for one ψ with |r − cos ψ|.
    pub(crate) fn nearest(&self) -> Nearest {
        let [low, high] = self.angle;
        // The first angle from `low` on that points at −1.
        let towards = low + (PI - low).rem_euclid(TAU);
        let angle = if towards <= high {
            towards
        } else if towards - high < low - (towards - TAU) {
            high
        } else {
            low
        };
        let psi = if towards <= high { 0.0 } else { angle - PI };
        self.at(angle, psi, towards <= high)
    }

    fn at(&self, angle: f64, psi: f64, towards: bool) -> Nearest {
        let (sin, cos) = psi.sin_cos();
        let radius = cos.max(self.radius[0]).min(self.radius[1]);
        Nearest { distance: (radius - cos).hypot(sin), radius, angle, towards }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_complex::Complex;

    #[test]
    fn no_point_of_the_sector_is_nearer_and_the_point_found_is_one_of_them() {
        let cases = [
            ([0.3, 0.6], [2.0, 4.0]),
            ([1.5, 2.0], [3.5, 4.5]),
            ([0.1, 3.0], [-2.9, -0.4]),
            ([0.2, 0.4], [0.1, 0.2]),
            ([0.9, 1.1], [10.0, 17.0]),
            ([0.5, 0.5], [7.0, 7.0]),
            ([0.5, 1.2], [-0.1, 0.3]),
        ];
        for (radius, angle) in cases {
            let found = Sector { radius, angle }.nearest();
            let point = |r: f64, t: f64| (Complex::new(1.0, 0.0) + Complex::from_polar(r, t)).norm();
            let mut least = f64::INFINITY;
            for i in 0..=400 {
                for k in 0..=400 {
                    let part =
                        |range: [f64; 2], n: i32| range[0] + (range[1] - range[0]) * f64::from(n) / 400.0;
                    least = least.min(point(part(radius, i), part(angle, k)));
                }
            }
            // The grid is no finer than 0.02 in the angle and 0.01 in the radius.
            assert!(found.distance <= least + 1e-12 && least - found.distance < 0.02, "{radius:?} {angle:?}");
            assert!((point(found.radius, found.angle) - found.distance).abs() < 1e-12);
            assert!(found.angle >= angle[0] && found.angle <= angle[1]);
        }
    }
}
