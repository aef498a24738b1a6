//! What goes into an update and what comes out.

use crate::{Limited, Scalar};

/// Who computes the output.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Mode<T> {
    /// The law.
    #[default]
    Automatic,
    /// The operator: this output [output unit], within the limits.
    Manual(T),
    /// Nobody: the output stays where it is. The way into manual without a bump.
    Hold,
}

/// What a controller is told at one update.
///
/// ```
/// use holdup_control::{Input, Mode};
///
/// let input = Input::automatic(0.5, 50.0, 48.7); // 0.5 s since the last one, setpoint, measurement
/// let manual = Input { mode: Mode::Manual(35.0), ..input };
/// assert_eq!(manual.setpoint, 50.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input<T> {
    /// Time since the last update [s], measured. One that is not finite and above 0 changes nothing.
    pub sample_period: T,
    /// Setpoint [input unit]. One that is not finite is not taken: the last good one stands.
    pub setpoint: T,
    /// Controlled variable [input unit] where a new sample came since the last update; a bad one is NaN.
    pub controlled_variable: Option<T>,
    /// Feed-forward [output unit], added to the output: the known part of what balances the load. The observer
    /// estimates what is left of the load. One that is not finite is not taken.
    pub feed_forward: T,
    /// The manipulated variable that was really applied since the last update [output unit], where it is known:
    /// an actuator's position, another controller's choice. Otherwise it is the one that was returned.
    pub applied: Option<T>,
    /// Who computes the output.
    pub mode: Mode<T>,
}

impl<T: Scalar> Input<T> {
    /// A new measurement in automatic, no feed-forward, the returned output applied.
    pub fn automatic(sample_period: T, setpoint: T, controlled_variable: T) -> Self {
        Self {
            sample_period,
            setpoint,
            controlled_variable: Some(controlled_variable),
            feed_forward: T::ZERO,
            applied: None,
            mode: Mode::Automatic,
        }
    }
}

/// What a controller answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Output<T> {
    /// Manipulated variable [output unit]: finite and within the limits, always.
    pub manipulated_variable: T,
    /// What the law wanted before the limits [output unit].
    pub wanted: T,
    /// The limit that the manipulated variable stands at.
    pub limited: Limited,
    /// The observer's estimate of the load [output unit], less what feed-forward and bias balance.
    pub load_estimate: Option<T>,
    /// Whether all inputs were good.
    pub status: Status,
}

/// Whether all inputs were good, and what was done where not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Status {
    /// All good.
    #[default]
    Good,
    /// Setpoint, feed-forward, applied or manual output is not finite: the last good one was used.
    InputRejected,
    /// The new law needs a longer delay line than there is: the old one runs on.
    SettingsRejected,
    /// The sample period is not finite and above 0: nothing moved, the output is held.
    SamplePeriodRejected,
    /// The measurement is not finite, out of its range, or too large to compute with: automatic holds the output.
    MeasurementRejected,
    /// No new measurement for longer than the stale time, or none yet: automatic holds the output.
    MeasurementStale,
    /// No good measurement for longer than the failure time: automatic takes the safe output.
    MeasurementFailed,
}
