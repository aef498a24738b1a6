//! Random processes: every one has its own stream of numbers, so that no order of computation changes it.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use thiserror::Error;

use crate::analysis::frequency::family::Family;

/// How the factors are distributed over their ranges.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Distribution {
    /// Every factor of the range alike.
    #[default]
    Uniform,
    /// Every ratio alike: the logarithm of the factor is uniform.
    LogUniform,
    /// Most in the middle of the range, none at its ends.
    Triangular,
    /// Normal about the middle of the range, its ends two standard deviations away; values beyond them are drawn again.
    Normal,
}

/// A name that is no distribution.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("'{0}' must be one of uniform, log-uniform, triangular, normal")]
pub struct DrawError(pub String);

impl Distribution {
    /// The distribution of this name: `uniform`, `log-uniform`, `triangular` or `normal`.
    ///
    /// # Errors
    /// [`DrawError`] where there is none.
    pub fn named(name: &str) -> Result<Self, DrawError> {
        match name {
            "uniform" => Ok(Self::Uniform),
            "log-uniform" => Ok(Self::LogUniform),
            "triangular" => Ok(Self::Triangular),
            "normal" => Ok(Self::Normal),
            _ => Err(DrawError(name.to_owned())),
        }
    }
}

/// Factors on gain and dead time, drawn independently of each other.
///
/// ```
/// use holdup::analysis::frequency::family::Family;
/// use holdup::tuning::robust::{Distribution, Draws};
/// let draws = Draws::new(Family::ranges([0.8, 1.2], [0.9, 1.1])?, Distribution::Uniform, 7);
/// assert_eq!(draws.factors(3), draws.factors(3));
/// assert_ne!(draws.factors(3), draws.factors(4));
/// # Ok::<(), holdup::analysis::frequency::family::FamilyError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Draws {
    ranges: [[f64; 2]; 2],
    distribution: Distribution,
    seed: u64,
}

impl Draws {
    /// Draws over the ranges of this family (of an ellipse: the box about it).
    #[must_use]
    pub fn new(family: Family, distribution: Distribution, seed: u64) -> Self {
        Self { ranges: [family.gain(), family.dead_time()], distribution, seed }
    }

    /// Gain factor and dead-time factor of the process of this index \[–\].
    #[must_use]
    pub fn factors(&self, index: u64) -> [f64; 2] {
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        random.set_stream(index);
        self.ranges.map(|[low, high]| {
            let factor = match self.distribution {
                Distribution::Uniform => low + (high - low) * random.random::<f64>(),
                Distribution::LogUniform => low * (high / low).powf(random.random::<f64>()),
                Distribution::Triangular => {
                    let sum = random.random::<f64>() + random.random::<f64>();
                    low + (high - low) * 0.5 * sum
                }
                Distribution::Normal => {
                    f64::midpoint(low, high) + 0.25 * (high - low) * within_two(&mut random)
                }
            };
            factor.clamp(low, high)
        })
    }
}

/// A standard normal number within two standard deviations (Box and Muller 1958, drawn again outside).
fn within_two(random: &mut ChaCha8Rng) -> f64 {
    loop {
        let (u, v) = (1.0 - random.random::<f64>(), random.random::<f64>());
        let value = (-2.0 * u.ln()).sqrt() * (std::f64::consts::TAU * v).cos();
        if value.abs() <= 2.0 {
            return value;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_distribution_has_its_mean_and_its_deviation() {
        let family = Family::ranges([0.5, 1.5], [0.8, 1.2]).unwrap();
        // Deviations in units of the half range: 1/√3, 1/√6; a normal cut at 2σ keeps 0.8796σ = 0.4398 of it.
        for (name, deviation) in [("uniform", 0.57735), ("triangular", 0.40825), ("normal", 0.43981)] {
            let draws = Draws::new(family, Distribution::named(name).unwrap(), 1);
            let count = 40_000_u32;
            for (part, half) in [(0, 0.5), (1, 0.2)] {
                let values: Vec<f64> = (0..count).map(|i| draws.factors(u64::from(i))[part]).collect();
                let mean = values.iter().sum::<f64>() / f64::from(count);
                let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / f64::from(count);
                // Five standard errors of 40 000 draws: 2.5 % of the deviation.
                assert!((mean - 1.0).abs() < 0.025 * half * deviation, "{name}: mean {mean}");
                assert!((variance.sqrt() / half - deviation).abs() < 0.025 * deviation, "{name}: {variance}");
            }
        }
        let draws = Draws::new(Family::ranges([0.25, 4.0], [1.0; 2]).unwrap(), Distribution::LogUniform, 1);
        let mean = (0..40_000_u32).map(|i| draws.factors(u64::from(i))[0].ln()).sum::<f64>() / 40_000.0;
        assert!(mean.abs() < 0.025 * 4.0_f64.ln());
    }
}
