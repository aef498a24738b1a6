//! What happens when the measurement fails.

use crate::setting_error::require;
use crate::{Scalar, SettingError};

/// How long a missing measurement is borne, and the output after that.
///
/// A measurement that is not a finite number, or out of its range, holds the output at once. A measurement that does not come holds it
/// after the stale time. After the failure time without a good measurement the safe output is taken. Absent times
/// mean: never stale, hold for ever.
///
/// ```
/// use holdup_control::Watch;
///
/// let watch = Watch::none().with_stale_time(5.0)?.with_failure(60.0, 20.0)?;
/// assert_eq!(watch.safe_output(), Some(20.0));
/// # Ok::<(), holdup_control::SettingError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Watch<T> {
    range: Option<(T, T)>,
    stale_time: Option<T>,
    failure: Option<Failure<T>>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Failure<T> {
    time: T,
    output: T,
}

impl<T: Scalar> Watch<T> {
    /// Never stale, and a bad measurement holds the output for ever.
    #[must_use]
    pub fn none() -> Self {
        Self { range: None, stale_time: None, failure: None }
    }

    /// The same with a range of the measurement [input unit]: one outside it is no measurement.
    ///
    /// # Errors
    /// An end that is not finite; a low end that is not below the high one.
    pub fn with_range(mut self, low: T, high: T) -> Result<Self, SettingError> {
        require::finite("measurement_low", low)?;
        require::finite("measurement_high", high)?;
        require::that(low < high, "measurement_low", low, "must be below measurement_high")?;
        self.range = Some((low, high));
        Ok(self)
    }

    /// The same with a stale time [s]: a measurement older than this is no measurement.
    ///
    /// It must be longer than the sensor takes between two samples: otherwise the law never runs. Also, when updates themselves were missing for longer than this, the law starts again from the output that
    /// stood.
    ///
    /// # Errors
    /// A time that is not finite and above 0.
    pub fn with_stale_time(mut self, stale_time: T) -> Result<Self, SettingError> {
        self.stale_time = Some(require::positive("stale_time", stale_time)?);
        Ok(self)
    }

    /// The same with a failure time [s], after which the safe output [output unit] is taken.
    ///
    /// # Errors
    /// A time that is not finite and above 0, an output that is not finite.
    pub fn with_failure(mut self, failure_time: T, safe_output: T) -> Result<Self, SettingError> {
        let time = require::positive("failure_time", failure_time)?;
        let output = require::finite("safe_output", safe_output)?;
        self.failure = Some(Failure { time, output });
        Ok(self)
    }

    /// Range of the measurement, low and high [input unit].
    #[must_use]
    pub fn range(&self) -> Option<(T, T)> {
        self.range
    }

    /// Stale time [s].
    #[must_use]
    pub fn stale_time(&self) -> Option<T> {
        self.stale_time
    }

    /// Failure time [s].
    #[must_use]
    pub fn failure_time(&self) -> Option<T> {
        self.failure.map(|failure| failure.time)
    }

    /// Safe output [output unit].
    #[must_use]
    pub fn safe_output(&self) -> Option<T> {
        self.failure.map(|failure| failure.output)
    }

    /// True when this is a measurement.
    pub(crate) fn accepts(&self, measured: T) -> bool {
        measured.is_finite() && self.range.is_none_or(|(low, high)| low <= measured && measured <= high)
    }

    /// True when a measurement of this age [s] is stale.
    pub(crate) fn is_stale(&self, age: T) -> bool {
        self.stale_time.is_some_and(|time| age > time)
    }

    /// The safe output when a measurement of this age [s] means failure.
    pub(crate) fn failed(&self, age: T) -> Option<T> {
        self.failure.filter(|failure| age > failure.time).map(|failure| failure.output)
    }
}
