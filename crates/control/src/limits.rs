//! What the actuator allows.

use crate::setting_error::require;
use crate::{Scalar, SettingError};

/// Limits of the output and of its rate; each may be absent.
///
/// ```
/// use holdup_control::{Limited, Limits};
///
/// let limits = Limits::new(Some(0.0), Some(100.0))?.with_rate(2.0)?; // percent, percent per second
/// assert_eq!(limits.apply(80.0, 50.0, 1.0), (52.0, Limited::Rate));
/// assert_eq!(limits.apply(-3.0, 1.0, 1.0), (0.0, Limited::Low));
/// assert!(Limits::new(Some(100.0), Some(0.0)).is_err());
/// # Ok::<(), holdup_control::SettingError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits<T> {
    low: Option<T>,
    high: Option<T>,
    rate: Option<T>,
}

/// Which limit the output stands at.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Limited {
    /// None: the output is the one wanted.
    #[default]
    No,
    /// The low output limit.
    Low,
    /// The high output limit.
    High,
    /// The rate limit.
    Rate,
}

impl<T: Scalar> Limits<T> {
    /// No limit at all.
    #[must_use]
    pub fn none() -> Self {
        Self { low: None, high: None, rate: None }
    }

    /// Output limits [output unit], without a rate limit.
    ///
    /// # Errors
    /// A limit that is not finite; a low limit that is not below the high one.
    pub fn new(low: Option<T>, high: Option<T>) -> Result<Self, SettingError> {
        if let Some(low) = low {
            require::finite("output_low", low)?;
        }
        if let Some(high) = high {
            require::finite("output_high", high)?;
        }
        if let (Some(low), Some(high)) = (low, high) {
            require::that(low < high, "output_low", low, "must be below output_high")?;
        }
        Ok(Self { low, high, rate: None })
    }

    /// The same with a rate limit [output unit/s], up and down.
    ///
    /// # Errors
    /// A rate that is not finite and above 0.
    pub fn with_rate(mut self, rate: T) -> Result<Self, SettingError> {
        self.rate = Some(require::positive("rate_limit", rate)?);
        Ok(self)
    }

    /// Low output limit [output unit].
    #[must_use]
    pub fn low(&self) -> Option<T> {
        self.low
    }

    /// High output limit [output unit].
    #[must_use]
    pub fn high(&self) -> Option<T> {
        self.high
    }

    /// Rate limit [output unit/s].
    #[must_use]
    pub fn rate(&self) -> Option<T> {
        self.rate
    }

    /// The output [output unit] nearest to `wanted` within the output limits, whatever the rate.
    #[must_use]
    pub fn within(&self, wanted: T) -> T {
        self.bound(wanted).0
    }

    /// The output [output unit] nearest to `wanted` that may follow `last` after `sample_period`, and the limit
    /// that it stands at. Where a new output limit is beyond the rate's reach, the output limit wins.
    #[must_use]
    pub fn apply(&self, wanted: T, last: T, sample_period: T) -> (T, Limited) {
        let mut reachable = wanted;
        let mut limited = Limited::No;
        if let Some(rate) = self.rate {
            let step = rate * sample_period;
            if wanted > last + step {
                reachable = last + step;
                limited = Limited::Rate;
            } else if wanted < last - step {
                reachable = last - step;
                limited = Limited::Rate;
            }
        }
        match self.bound(reachable) {
            (output, Limited::No) => (output, limited),
            bounded => bounded,
        }
    }

    fn bound(&self, wanted: T) -> (T, Limited) {
        if let Some(high) = self.high
            && wanted > high
        {
            return (high, Limited::High);
        }
        if let Some(low) = self.low
            && wanted < low
        {
            return (low, Limited::Low);
        }
        (wanted, Limited::No)
    }
}
