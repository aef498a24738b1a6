//! The process: what is controlled.

use super::error::{ModelError, non_zero, positive};
use super::quantity::Seconds;

/// A process with one or two integrators and a dead time, `G(s) = K·e^(−d·s) / (sⁿ·(T·s + 1))`.
///
/// The load disturbance enters at its input, before the dead time. The process gain K may be negative: a
/// level held by its outlet valve falls when the valve opens, and then the proportional gain is negative too.
///
/// ```
/// use holdup::model::{Process, Seconds};
/// let level = Process::integrating(0.0506, Seconds(6.0))?;
/// assert_eq!(level.dead_time(), 6.0);
/// assert!(Process::integrating(0.0506, Seconds(0.0)).is_err());
/// # Ok::<(), holdup::model::ModelError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(clippy::struct_field_names, reason = "process_gain is the word for it, here as everywhere")]
pub struct Process {
    process_gain: f64,
    dead_time: f64,
    lag: Option<f64>,
    integrators: u8,
}

impl Process {
    /// An integrator with dead time, `K·e^(−d·s)/s`.
    ///
    /// `process_gain` [output unit per (input unit · s)] is any finite number but 0.
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] if the gain is 0 or a value is not finite, or if `dead_time` ≤ 0.
    pub fn integrating(process_gain: f64, dead_time: Seconds) -> Result<Self, ModelError> {
        Ok(Self {
            process_gain: non_zero("process_gain", process_gain)?,
            dead_time: positive("dead_time", dead_time.0)?,
            lag: None,
            integrators: 1,
        })
    }

    /// A double integrator with dead time, `K·e^(−d·s)/s²`; K in output unit per (input unit · s²).
    ///
    /// # Errors
    /// As [`Process::integrating`].
    pub fn double_integrating(process_gain: f64, dead_time: Seconds) -> Result<Self, ModelError> {
        Ok(Self { integrators: 2, ..Self::integrating(process_gain, dead_time)? })
    }

    /// The same process with a lag T [s] > 0 in series.
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] if `lag` is not finite or not positive.
    pub fn with_lag(self, lag: Seconds) -> Result<Self, ModelError> {
        Ok(Self { lag: Some(positive("lag", lag.0)?), ..self })
    }

    /// The same process with its gain and its dead time multiplied by these factors [–].
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] if the gain becomes 0, or the dead time is not positive or not finite.
    pub fn perturbed(self, gain_factor: f64, dead_time_factor: f64) -> Result<Self, ModelError> {
        Ok(Self {
            process_gain: non_zero("process_gain", self.process_gain * gain_factor)?,
            dead_time: positive("dead_time", self.dead_time * dead_time_factor)?,
            ..self
        })
    }

    /// Process gain K [output unit per (input unit · sⁿ), n the number of integrators].
    #[must_use]
    pub fn process_gain(&self) -> f64 {
        self.process_gain
    }

    /// Dead time d [s].
    #[must_use]
    pub fn dead_time(&self) -> f64 {
        self.dead_time
    }

    /// Lag T [s], where the process has one.
    #[must_use]
    pub fn lag(&self) -> Option<f64> {
        self.lag
    }

    /// Number of integrators: 1 or 2.
    #[must_use]
    pub fn integrators(&self) -> u8 {
        self.integrators
    }

    /// Whether this is the plain integrator with dead time, without lag.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.integrators == 1 && self.lag.is_none()
    }
}
