//! @header@
//!
//! Units: times in s; controlled variable and setpoint in the input unit; manipulated variable, feed-forward, load
//! estimate, bias and limits in the output unit.
//!
//! This file is a module of a crate that depends on `holdup-control`: no standard library, no allocation, no clock.
//!
//! ```ignore
//! // Once, when it is switched on, so that the output begins where the actuator stands:
//! let mut controller = @name@::Controller::switched_on(actuator_position())?;
//!
//! // Then about every @nominal_period@ s:
//! let input = Input::automatic(seconds_since_the_last_step(), setpoint(), measurement());
//! write_actuator(controller.step(&input).manipulated_variable);
//! ```
//!
//! Time is measured: the sample period of an input is the time since the last step, whatever it was meant to be. A bad
//! measurement is a NaN, an absent one `None`. `Controller` is plain data: a copy of it is a save, and running on from
//! it continues bit for bit.
//!
//! To change the settings, change the constants below, or give `Controller::change` other settings while running: they
//! take over without bump. A longer dead time or a shorter sample period needs more segments: `SEGMENTS` must be at
//! least `Settings::segments_needed`.

use holdup_control::{Input, Limits, Observer, Output, Pid, Segment, SettingError, Settings, State, Watch};

/// Segments of the delay line: what the dead time needs, and spare ones.
pub const SEGMENTS: usize = @segments@;

/// Proportional gain Kc [output/input unit]; negative where the output must rise with the measurement.
pub const PROPORTIONAL_GAIN: @real@ = @proportional_gain@;
/// Setpoint weight b of the proportional action [-].
pub const SETPOINT_WEIGHT: @real@ = @setpoint_weight@;
/// Setpoint weight c of the derivative action [-].
pub const DERIVATIVE_SETPOINT_WEIGHT: @real@ = @derivative_setpoint_weight@;
/// Integral time Ti [s].
pub const INTEGRAL_TIME: Option<@real@> = @integral_time@;
/// Tracking time Tt [s]: how fast the integral follows what was applied; absent, Ti.
pub const TRACKING_TIME: Option<@real@> = @tracking_time@;
/// Derivative time Td [s].
pub const DERIVATIVE_TIME: Option<@real@> = @derivative_time@;
/// Filter time Tf of the derivative [s].
pub const FILTER_TIME: Option<@real@> = @filter_time@;
/// Bias [output unit].
pub const BIAS: @real@ = @bias@;
/// Time in which a bias that a transfer moved returns [s]; absent, it stays.
pub const BLEED_TIME: Option<@real@> = @bleed_time@;

/// Observer gain Ko [output/input unit], with the sign of Km; absent, there is no observer.
pub const OBSERVER_GAIN: Option<@real@> = @observer_gain@;
/// Gain Km of the observer's model [input unit/(output unit s)].
pub const MODEL_GAIN: Option<@real@> = @model_gain@;
/// Dead time dm of the observer's model [s].
pub const DEAD_TIME: Option<@real@> = @dead_time@;
/// Nominal sample period [s]: says how long the delay line must be, nothing else.
pub const SAMPLE_PERIOD: Option<@real@> = @sample_period@;
/// Lead in the load estimate: derivative time [s].
pub const LEAD_TIME: Option<@real@> = @lead_time@;
/// Lead in the load estimate: filter time [s].
pub const LEAD_FILTER_TIME: Option<@real@> = @lead_filter_time@;
/// Whether the PID terms act on the predicted controlled variable: a modified Smith predictor.
pub const PREDICTS: bool = @predicts@;

/// Low limit of the output [output unit].
pub const LOW: Option<@real@> = @low@;
/// High limit of the output [output unit].
pub const HIGH: Option<@real@> = @high@;
/// Rate limit of the output [output unit/s], up and down.
pub const RATE: Option<@real@> = @rate@;

/// Low end of the measurement's range [input unit]: a measurement outside the range is none.
pub const RANGE_LOW: Option<@real@> = @range_low@;
/// High end of the measurement's range [input unit].
pub const RANGE_HIGH: Option<@real@> = @range_high@;
/// Stale time [s]: an older measurement holds the output.
pub const STALE_TIME: Option<@real@> = @stale_time@;
/// Failure time [s]: after it the safe output is taken.
pub const FAILURE_TIME: Option<@real@> = @failure_time@;
/// Safe output [output unit].
pub const SAFE_OUTPUT: Option<@real@> = @safe_output@;

/// The settings of the constants above.
///
/// # Errors
/// A constant that no controller can run with, by name and with what is allowed.
pub fn design() -> Result<Settings<@real@>, SettingError> {
    let mut pid = Pid::proportional(PROPORTIONAL_GAIN)?
        .with_setpoint_weights(SETPOINT_WEIGHT, DERIVATIVE_SETPOINT_WEIGHT)?
        .with_bias(BIAS, BLEED_TIME)?;
    if let Some(integral_time) = INTEGRAL_TIME {
        pid = pid.with_integral(integral_time)?;
    }
    if let Some(tracking_time) = TRACKING_TIME {
        pid = pid.with_tracking_time(tracking_time)?;
    }
    if let Some(derivative_time) = DERIVATIVE_TIME {
        pid = pid.with_derivative(derivative_time, FILTER_TIME)?;
    }
    let mut limits = Limits::new(LOW, HIGH)?;
    if let Some(rate) = RATE {
        limits = limits.with_rate(rate)?;
    }
    let mut watch = Watch::none();
    if let (Some(low), Some(high)) = (RANGE_LOW, RANGE_HIGH) {
        watch = watch.with_range(low, high)?;
    }
    if let Some(stale_time) = STALE_TIME {
        watch = watch.with_stale_time(stale_time)?;
    }
    if let (Some(failure_time), Some(safe_output)) = (FAILURE_TIME, SAFE_OUTPUT) {
        watch = watch.with_failure(failure_time, safe_output)?;
    }
    let settings = Settings::new(pid).with_limits(limits)?.with_watch(watch)?;
    let (Some(gain), Some(model_gain), Some(dead_time), Some(sample_period)) =
        (OBSERVER_GAIN, MODEL_GAIN, DEAD_TIME, SAMPLE_PERIOD)
    else {
        return Ok(settings);
    };
    let mut observer = Observer::new(gain, model_gain, dead_time, sample_period)?;
    if let (Some(lead_time), Some(filter_time)) = (LEAD_TIME, LEAD_FILTER_TIME) {
        observer = observer.with_lead(lead_time, filter_time)?;
    }
    settings.with_observer(if PREDICTS { observer.predicting() } else { observer })
}

/// The controller: its settings and its running state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Controller {
    settings: Settings<@real@>,
    state: State<@real@, [Segment<@real@>; SEGMENTS]>,
}

impl Controller {
    /// A controller that is switched on at this manipulated variable: its first automatic output is that one,
    /// whatever the measurement.
    ///
    /// # Errors
    /// A constant that no controller can run with; an output that is not finite.
    pub fn switched_on(manipulated_variable: @real@) -> Result<Self, SettingError> {
        let settings = design()?;
        let line = [Segment::default(); SEGMENTS];
        Ok(Self { settings, state: State::switched_on(&settings, line, manipulated_variable)? })
    }

    /// A controller that has long been in automatic at this setpoint, controlled and manipulated variable: it answers
    /// the next change of any of them at once.
    ///
    /// # Errors
    /// As [`Controller::switched_on`], and for a value that is not finite.
    pub fn at_rest(
        setpoint: @real@,
        controlled_variable: @real@,
        manipulated_variable: @real@,
    ) -> Result<Self, SettingError> {
        let settings = design()?;
        let line = [Segment::default(); SEGMENTS];
        let state = State::at_rest(&settings, line, setpoint, controlled_variable, manipulated_variable)?;
        Ok(Self { settings, state })
    }

    /// One update: takes the measurement, returns the manipulated variable. It never fails: what was wrong with the
    /// input is the output's status.
    pub fn step(&mut self, input: &Input<@real@>) -> Output<@real@> {
        self.state.update(&self.settings, input)
    }

    /// Other settings from the next step on, without bump.
    ///
    /// # Errors
    /// A dead time that needs more than `SEGMENTS`: the old settings run on.
    pub fn change(&mut self, settings: Settings<@real@>) -> Result<(), SettingError> {
        self.state.fits(&settings)?;
        self.settings = settings;
        Ok(())
    }
}
