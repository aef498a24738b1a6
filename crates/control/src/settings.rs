//! Everything that is set on a controller.

use crate::setting_error::require;
use crate::{Limits, Observer, Pid, Scalar, SettingError, Watch};

/// The terms of a law: what computes the wanted output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law<T> {
    /// The PID terms.
    pub pid: Pid<T>,
    /// The disturbance observer, where there is one.
    pub observer: Option<Observer<T>>,
}

/// Settings of a controller: its law, its limits and what happens when the measurement fails.
///
/// Changing settings while running is giving [`State::update`](crate::State::update) other ones: new limits hold at
/// once, a new law takes over from the next sample on, without bump.
///
/// ```
/// use holdup_control::{Limits, Observer, Pid, Settings, Watch};
///
/// let settings = Settings::new(Pid::proportional(1.5321)?.with_derivative(1.0343, Some(0.01))?)
///     .with_observer(Observer::new(1.5321, 0.0506, 6.0, 0.5)?)?
///     .with_limits(Limits::new(Some(0.0), Some(100.0))?)?
///     .with_watch(Watch::none().with_failure(60.0, 20.0)?)?;
/// assert_eq!(settings.segments_needed(), 15);
/// # Ok::<(), holdup_control::SettingError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings<T> {
    law: Law<T>,
    limits: Limits<T>,
    watch: Watch<T>,
}

impl<T: Scalar> Settings<T> {
    /// A controller of these PID terms with no observer, no limits, no watch.
    #[must_use]
    pub fn new(pid: Pid<T>) -> Self {
        Self { law: Law { pid, observer: None }, limits: Limits::none(), watch: Watch::none() }
    }

    /// The same with this disturbance observer.
    ///
    /// # Errors
    /// A proportional gain that differs in sign from the model: the loop would drive itself away.
    pub fn with_observer(mut self, observer: Observer<T>) -> Result<Self, SettingError> {
        self.law.observer = Some(observer);
        self.checked()
    }

    /// The same with these limits.
    ///
    /// # Errors
    /// A safe output outside the output limits.
    pub fn with_limits(mut self, limits: Limits<T>) -> Result<Self, SettingError> {
        self.limits = limits;
        self.checked()
    }

    /// The same with this watch over the measurement.
    ///
    /// # Errors
    /// A safe output outside the output limits; a failure time below the stale time.
    pub fn with_watch(mut self, watch: Watch<T>) -> Result<Self, SettingError> {
        self.watch = watch;
        self.checked()
    }

    fn checked(self) -> Result<Self, SettingError> {
        if let Some(observer) = self.law.observer {
            let gain = self.law.pid.signed_gain();
            let same_sign = (gain > T::ZERO) == (observer.model_gain() > T::ZERO);
            let requirement = "must, with its action, have the sign of model_gain";
            require::that(same_sign, "proportional_gain", gain, requirement)?;
        }
        if let Some(output) = self.watch.safe_output() {
            let within = self.limits.within(output) == output;
            require::that(within, "safe_output", output, "must be within the output limits")?;
        }
        if let (Some(stale), Some(failure)) = (self.watch.stale_time(), self.watch.failure_time()) {
            require::that(failure >= stale, "failure_time", failure, "must not be below stale_time")?;
        }
        Ok(self)
    }

    /// The law.
    #[must_use]
    pub fn law(&self) -> &Law<T> {
        &self.law
    }

    /// The limits of the output.
    #[must_use]
    pub fn limits(&self) -> &Limits<T> {
        &self.limits
    }

    /// The watch over the measurement.
    #[must_use]
    pub fn watch(&self) -> &Watch<T> {
        &self.watch
    }

    /// Segments that the delay line needs: 0 without an observer.
    #[must_use]
    pub fn segments_needed(&self) -> usize {
        self.law.observer.map_or(0, |observer| observer.segments_needed())
    }
}
