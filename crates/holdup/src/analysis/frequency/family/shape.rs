//! Which factors on gain and dead time belong to a family of processes.

use thiserror::Error;

/// Factors on the gain and on the dead time of a process: a box, or an ellipse.
///
/// ```
/// use holdup::analysis::frequency::family::Family;
/// let family = Family::ranges([0.8, 1.2], [0.8, 1.2])?;
/// assert!(Family::ranges([-0.1, 1.2], [1.0, 1.0]).is_err());
/// # Ok::<(), holdup::analysis::frequency::family::FamilyError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Family {
    shape: Shape,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Shape {
    Ranges {
        gain: [f64; 2],
        dead_time: [f64; 2],
    },
    /// Half axes of the ellipse's bounding box, and the correlation.
    Ellipse {
        gain: f64,
        dead_time: f64,
        correlation: f64,
    },
}

/// Factors that are no family of processes.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FamilyError {
    /// A range that is empty, or not of positive finite factors.
    #[error("the factors on the {of} run from {low} to {high}: 0 < low <= high < infinity is allowed")]
    Range {
        /// Gain or dead time.
        of: &'static str,
        /// Its least factor.
        low: f64,
        /// Its greatest factor.
        high: f64,
    },
    /// A correlation that makes no ellipse.
    #[error("the correlation of gain and dead time is {0}: more than -1 and less than 1 is allowed")]
    Correlation(f64),
}

impl Family {
    /// All pairs of a gain factor and a dead-time factor in these closed ranges \[–\].
    ///
    /// # Errors
    /// [`FamilyError::Range`] unless 0 < low ≤ high < ∞ in both.
    pub fn ranges(gain: [f64; 2], dead_time: [f64; 2]) -> Result<Self, FamilyError> {
        positive("gain", gain)?;
        positive("dead time", dead_time)?;
        Ok(Self { shape: Shape::Ranges { gain, dead_time } })
    }

    /// The ellipse about (1, 1) that reaches `gain` and `dead_time` \[–\] to either side, the two correlated: for a
    /// confidence region of 95 % these are 2.448 relative standard deviations.
    ///
    /// # Errors
    /// [`FamilyError`] where the ellipse holds a factor that is not positive, or the correlation is not in (−1, 1).
    pub fn ellipse(gain: f64, dead_time: f64, correlation: f64) -> Result<Self, FamilyError> {
        positive("gain", [1.0 - gain, 1.0 + gain])?;
        positive("dead time", [1.0 - dead_time, 1.0 + dead_time])?;
        if correlation.is_nan() || correlation.abs() >= 1.0 {
            return Err(FamilyError::Correlation(correlation));
        }
        Ok(Self { shape: Shape::Ellipse { gain, dead_time, correlation } })
    }

    /// The family with every factor's distance from 1 multiplied by `size` ≥ 0.
    ///
    /// # Errors
    /// [`FamilyError`] where a factor is then not positive.
    pub fn scaled(&self, size: f64) -> Result<Self, FamilyError> {
        match self.shape {
            Shape::Ranges { gain, dead_time } => {
                let about_one = |range: [f64; 2]| range.map(|factor| 1.0 + size * (factor - 1.0));
                Self::ranges(about_one(gain), about_one(dead_time))
            }
            Shape::Ellipse { gain, dead_time, correlation } => {
                Self::ellipse(size * gain, size * dead_time, correlation)
            }
        }
    }

    /// Least and greatest gain factor \[–\].
    #[must_use]
    pub fn gain(&self) -> [f64; 2] {
        match self.shape {
            Shape::Ranges { gain, .. } => gain,
            Shape::Ellipse { gain, .. } => [1.0 - gain, 1.0 + gain],
        }
    }

    /// Least and greatest dead-time factor \[–\].
    #[must_use]
    pub fn dead_time(&self) -> [f64; 2] {
        match self.shape {
            Shape::Ranges { dead_time, .. } => dead_time,
            Shape::Ellipse { dead_time, .. } => [1.0 - dead_time, 1.0 + dead_time],
        }
    }

    /// Whether the gain factors are the same for every dead time.
    pub(crate) fn is_box(&self) -> bool {
        matches!(self.shape, Shape::Ranges { .. })
    }

    /// Least and greatest gain factor over the dead-time factors from `low` to `high`, which lie in the family.
    pub(super) fn gain_over(&self, low: f64, high: f64) -> [f64; 2] {
        match self.shape {
            Shape::Ranges { gain, .. } => gain,
            Shape::Ellipse { gain, dead_time, correlation } => {
                // In units of the half axes: the upper edge is ρ·x + √(1−ρ²)·√(1−x²), concave, greatest at x = ρ.
                let x = |factor: f64| ((factor - 1.0) / dead_time).clamp(-1.0, 1.0);
                let (from, to) = (x(low), x(high));
                let edge = |x: f64, rho: f64| rho * x + ((1.0 - rho * rho) * (1.0 - x * x)).sqrt();
                let greatest = |rho: f64| {
                    if dead_time == 0.0 { 1.0 } else { edge(rho.clamp(from, to), rho) }
                };
                // The lower edge is the upper one of −ρ, mirrored.
                [1.0 - gain * greatest(-correlation), 1.0 + gain * greatest(correlation)]
            }
        }
    }

    /// A member of the family in its middle.
    pub(super) fn middle(&self) -> [f64; 2] {
        let middle = |range: [f64; 2]| f64::midpoint(range[0], range[1]);
        [middle(self.gain()), middle(self.dead_time())]
    }
}

fn positive(of: &'static str, [low, high]: [f64; 2]) -> Result<(), FamilyError> {
    if low > 0.0 && low <= high && high.is_finite() {
        Ok(())
    } else {
        Err(FamilyError::Range { of, low, high })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gains_of_an_ellipse_hold_every_point_of_it_and_touch_it() {
        let family = Family::ellipse(0.3, 0.2, 0.6).unwrap();
        for (low, high) in [(0.8, 1.2), (0.85, 0.9), (1.05, 1.2), (1.0, 1.0)] {
            let [least, greatest] = family.gain_over(low, high);
            let (mut seen_low, mut seen_high) = (f64::INFINITY, 0.0_f64);
            for i in 0..=20_000 {
                let angle = f64::from(i) * std::f64::consts::TAU / 20_000.0;
                // The ellipse as the image of a circle.
                let (x, z) = (angle.cos(), angle.sin());
                let (dead_time, gain) = (1.0 + 0.2 * x, 1.0 + 0.3 * (0.6 * x + 0.8 * z));
                if (low..=high).contains(&dead_time) || (low == high && (dead_time - low).abs() < 1e-4) {
                    seen_low = seen_low.min(gain);
                    seen_high = seen_high.max(gain);
                }
            }
            // The angles are 3e-4 apart; where the dead time is one value the circle is met within 1e-4.
            assert!(least <= seen_low + 1e-3 && seen_low - least < 1e-3, "{low} {high}: {least} {seen_low}");
            assert!(greatest >= seen_high - 1e-3 && greatest - seen_high < 1e-3);
        }
    }

    #[test]
    fn factors_that_are_not_positive_are_named() {
        assert!(Family::ranges([0.0, 1.0], [1.0, 1.0]).is_err());
        assert!(Family::ranges([1.2, 0.8], [1.0, 1.0]).is_err());
        assert!(Family::ellipse(1.0, 0.1, 0.0).is_err());
        assert_eq!(Family::ellipse(0.1, 0.1, 1.0), Err(FamilyError::Correlation(1.0)));
        assert!(Family::ranges([0.8, 1.2], [f64::NAN, 1.0]).is_err());
        let family = Family::ranges([0.8, 1.3], [0.9, 1.0]).unwrap();
        assert!(family.scaled(6.0).is_err() && family.scaled(2.0).unwrap().dead_time() == [0.8, 1.0]);
    }
}
