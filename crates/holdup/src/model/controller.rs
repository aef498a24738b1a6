//! The controller: P, PI, PD or PID in ideal form, with the observer where it has one; or a dead-time compensator.

use super::compensator::Compensator;
use super::error::{ModelError, finite, non_zero, positive};
use super::process::Process;
use super::quantity::Seconds;

/// The filter of the derivative action, `Td·s/(Tf·s + 1)`, given as its source gives it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DerivativeFilter {
    /// Bandwidth N [rad/s]: derivative action `Td·N·s/(s + N)`.
    Bandwidth(f64),
    /// Filter time Tf [s], the reciprocal of the bandwidth.
    Time(f64),
}

impl DerivativeFilter {
    /// Filter time Tf [s].
    #[must_use]
    pub fn time(self) -> f64 {
        match self {
            Self::Bandwidth(n) => 1.0 / n,
            Self::Time(tf) => tf,
        }
    }

    /// Filter bandwidth N [rad/s].
    #[must_use]
    pub fn bandwidth(self) -> f64 {
        match self {
            Self::Bandwidth(n) => n,
            Self::Time(tf) => 1.0 / tf,
        }
    }
}

/// A filter on the whole controller output, `1/(a2·s² + a1·s + 1)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutputFilter {
    /// Coefficient a1 [s], > 0.
    pub a1: f64,
    /// Coefficient a2 [s²], ≥ 0.
    pub a2: f64,
}

/// The disturbance observer: `u = u_pd − D̂`, `D̂ = Ko·(y − y_m)`, `y_m = G_m·u_pd`.
///
/// Its model G_m has the structure of the process; gain and dead time are the process's unless given.
/// Source: Kadam (2017), equations 16 to 22, where Ko = Kc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observer {
    gain: f64,
    model_gain: Option<f64>,
    model_dead_time: Option<f64>,
}

impl Observer {
    /// An observer of gain Ko [input unit / output unit] with a perfect model.
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] if the gain is 0 or not finite.
    pub fn new(observer_gain: f64) -> Result<Self, ModelError> {
        Ok(Self { gain: non_zero("observer_gain", observer_gain)?, model_gain: None, model_dead_time: None })
    }

    /// The same observer with a model gain Km that differs from the process gain.
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] if the gain is 0 or not finite.
    pub fn with_model_gain(self, model_gain: f64) -> Result<Self, ModelError> {
        Ok(Self { model_gain: Some(non_zero("observer_model_gain", model_gain)?), ..self })
    }

    /// The same observer with a model dead time dm [s] that differs from the process's.
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] if the time is not positive and finite.
    pub fn with_model_dead_time(self, dead_time: Seconds) -> Result<Self, ModelError> {
        Ok(Self { model_dead_time: Some(positive("observer_model_dead_time", dead_time.0)?), ..self })
    }

    /// Observer gain Ko [input unit / output unit].
    #[must_use]
    pub fn gain(&self) -> f64 {
        self.gain
    }

    /// Gain Km of the model, where it was given apart from the process's.
    #[must_use]
    pub fn model_gain(&self) -> Option<f64> {
        self.model_gain
    }

    /// Dead time dm [s] of the model, where it was given apart from the process's.
    #[must_use]
    pub fn model_dead_time(&self) -> Option<f64> {
        self.model_dead_time
    }
}

/// A controller in ideal (ISA standard) form,
/// `u = Kc·(b·r − y + (1/Ti)·∫e + Td·s/(Tf·s + 1)·(c·r − y))`, with `e = r − y`.
///
/// Terms that are absent are absent: no integral time means no integral action, no filter an unfiltered
/// derivative. For negative feedback the proportional gain has the sign of the process gain.
///
/// Instead of all that it may be a dead-time compensator, made by `Controller::from(compensator)`: then
/// [`Controller::compensator`] says what it is, the proportional gain is that of its main control, the other
/// terms are absent, and setting one is an error.
///
/// ```
/// use holdup::model::{Controller, Seconds};
/// let pid = Controller::proportional(2.95)?
///     .with_integral_time(Seconds(15.0))?
///     .with_derivative_time(Seconds(3.0))?
///     .with_filter_bandwidth(100.0)?;
/// assert_eq!(pid.structure(), "PID");
/// # Ok::<(), holdup::model::ModelError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Controller {
    proportional_gain: f64,
    integral_time: Option<f64>,
    derivative_time: Option<f64>,
    derivative_filter: Option<DerivativeFilter>,
    setpoint_weight: f64,
    derivative_setpoint_weight: f64,
    output_filter: Option<OutputFilter>,
    observer: Option<Observer>,
    compensator: Option<Compensator>,
}

impl From<Compensator> for Controller {
    fn from(compensator: Compensator) -> Self {
        Self {
            proportional_gain: compensator.main_gain(),
            integral_time: None,
            derivative_time: None,
            derivative_filter: None,
            setpoint_weight: 1.0,
            derivative_setpoint_weight: 1.0,
            output_filter: None,
            observer: None,
            compensator: Some(compensator),
        }
    }
}

impl Controller {
    /// A proportional controller of gain Kc [input unit / output unit], any finite number but 0.
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] if the gain is 0 or not finite.
    pub fn proportional(proportional_gain: f64) -> Result<Self, ModelError> {
        Ok(Self {
            proportional_gain: non_zero("proportional_gain", proportional_gain)?,
            integral_time: None,
            derivative_time: None,
            derivative_filter: None,
            setpoint_weight: 1.0,
            derivative_setpoint_weight: 1.0,
            output_filter: None,
            observer: None,
            compensator: None,
        })
    }

    /// This controller, if it is a PID law, to which terms may be added.
    fn pid(self, name: &'static str) -> Result<Self, ModelError> {
        let reason = "is not a setting of a dead-time compensator";
        if self.compensator.is_some() { Err(ModelError::Conflict { name, reason }) } else { Ok(self) }
    }

    /// The same controller with integral time Ti [s] > 0.
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] if the time is not positive and finite.
    pub fn with_integral_time(self, integral_time: Seconds) -> Result<Self, ModelError> {
        let integral_time = positive("integral_time", integral_time.0)?;
        Ok(Self { integral_time: Some(integral_time), ..self.pid("integral_time")? })
    }

    /// The same controller with derivative time Td [s] ≥ 0; a derivative time of 0 is no derivative action.
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] if the time is negative or not finite.
    pub fn with_derivative_time(self, derivative_time: Seconds) -> Result<Self, ModelError> {
        let Seconds(td) = derivative_time;
        if td == 0.0 {
            return Ok(Self { derivative_time: None, derivative_filter: None, ..self });
        }
        if td.is_finite() && td > 0.0 {
            return Ok(Self { derivative_time: Some(td), ..self.pid("derivative_time")? });
        }
        Err(super::error::out_of_range("derivative_time", td, "a finite number, 0 or greater"))
    }

    /// The same controller with the derivative filtered at bandwidth N [rad/s] > 0. Without derivative
    /// action there is nothing to filter, and the controller is returned as it is.
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] if the bandwidth is not positive and finite.
    pub fn with_filter_bandwidth(self, bandwidth: f64) -> Result<Self, ModelError> {
        let n = positive("derivative_filter_bandwidth", bandwidth)?;
        positive("derivative_filter_bandwidth", 1.0 / n)?;
        Ok(self.filtered(DerivativeFilter::Bandwidth(n)))
    }

    /// The same controller with the derivative filtered with time Tf [s] > 0; see
    /// [`Controller::with_filter_bandwidth`].
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] if the time is not positive and finite.
    pub fn with_filter_time(self, filter_time: Seconds) -> Result<Self, ModelError> {
        let tf = positive("filter_time", filter_time.0)?;
        positive("filter_time", 1.0 / tf)?;
        Ok(self.filtered(DerivativeFilter::Time(tf)))
    }

    fn filtered(self, filter: DerivativeFilter) -> Self {
        Self { derivative_filter: self.derivative_time.map(|_| filter), ..self }
    }

    /// The same controller with setpoint weights b (proportional) and c (derivative).
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] if a weight is not finite.
    pub fn with_setpoint_weights(self, b: f64, c: f64) -> Result<Self, ModelError> {
        if (b, c) != (1.0, 1.0) {
            self.pid("setpoint_weight")?;
        }
        Ok(Self {
            setpoint_weight: finite("setpoint_weight", b)?,
            derivative_setpoint_weight: finite("derivative_setpoint_weight", c)?,
            ..self
        })
    }

    /// The same controller with its output filtered by `1/(a2·s² + a1·s + 1)`.
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] unless a1 > 0 and a2 ≥ 0 are finite.
    pub fn with_output_filter(self, a1: f64, a2: f64) -> Result<Self, ModelError> {
        positive("output_filter.a1", a1)?;
        if a2 != 0.0 {
            positive("output_filter.a2", a2)?;
        }
        Ok(Self { output_filter: Some(OutputFilter { a1, a2 }), ..self.pid("output_filter")? })
    }

    /// The same controller with a disturbance observer beside it. A dead-time compensator has its own and is returned
    /// as it is.
    #[must_use]
    pub fn with_observer(self, observer: Observer) -> Self {
        Self { observer: self.compensator.is_none().then_some(observer), ..self }
    }

    /// The same controller; its observer gets the model of this process where it has none of its own, and keeps it when
    /// the process changes.
    ///
    /// # Errors
    /// None for a valid process: [`ModelError`] is passed on from the constructors.
    pub fn with_model_of(self, process: &Process) -> Result<Self, ModelError> {
        let Some(observer) = self.observer else { return Ok(self) };
        let gain = observer.model_gain().unwrap_or(process.process_gain());
        let dead_time = observer.model_dead_time().unwrap_or(process.dead_time());
        Ok(self.with_observer(observer.with_model_gain(gain)?.with_model_dead_time(Seconds(dead_time))?))
    }

    /// The same controller without its observer.
    #[must_use]
    pub fn without_observer(self) -> Self {
        Self { observer: None, ..self }
    }

    /// The dead-time compensator that this controller is, where it is one.
    #[must_use]
    pub fn compensator(&self) -> Option<Compensator> {
        self.compensator
    }

    /// Proportional gain Kc [input unit / output unit]; of a compensator [`Compensator::main_gain`].
    #[must_use]
    pub fn proportional_gain(&self) -> f64 {
        self.proportional_gain
    }

    /// Integral time Ti [s], where there is integral action.
    #[must_use]
    pub fn integral_time(&self) -> Option<f64> {
        self.integral_time
    }

    /// Derivative time Td [s], where there is derivative action.
    #[must_use]
    pub fn derivative_time(&self) -> Option<f64> {
        self.derivative_time
    }

    /// Filter of the derivative, where it has one.
    #[must_use]
    pub fn derivative_filter(&self) -> Option<DerivativeFilter> {
        self.derivative_filter
    }

    /// Setpoint weight b of the proportional action [–].
    #[must_use]
    pub fn setpoint_weight(&self) -> f64 {
        self.setpoint_weight
    }

    /// Setpoint weight c of the derivative action [–].
    #[must_use]
    pub fn derivative_setpoint_weight(&self) -> f64 {
        self.derivative_setpoint_weight
    }

    /// Filter of the whole output, where there is one.
    #[must_use]
    pub fn output_filter(&self) -> Option<OutputFilter> {
        self.output_filter
    }

    /// Disturbance observer, where there is one.
    #[must_use]
    pub fn observer(&self) -> Option<Observer> {
        self.observer
    }

    /// Name of the structure: `P`, `PI`, `PD` or `PID`, followed by `+DOB` with an observer; of a dead-time
    /// compensator [`Compensator::structure`].
    #[must_use]
    pub fn structure(&self) -> &'static str {
        if let Some(compensator) = &self.compensator {
            return compensator.structure();
        }
        match (self.integral_time, self.derivative_time, self.observer) {
            (None, None, None) => "P",
            (Some(_), None, None) => "PI",
            (None, Some(_), None) => "PD",
            (Some(_), Some(_), None) => "PID",
            (None, None, Some(_)) => "P+DOB",
            (Some(_), None, Some(_)) => "PI+DOB",
            (None, Some(_), Some(_)) => "PD+DOB",
            (Some(_), Some(_), Some(_)) => "PID+DOB",
        }
    }

    /// Noise gain: the high-frequency limit of the gain from measurement to controller output [input unit /
    /// output unit]; `None` where it is infinite (an unfiltered derivative).
    #[must_use]
    pub fn noise_gain(&self) -> Option<f64> {
        if let Some(compensator) = &self.compensator {
            return Some(compensator.noise_gain());
        }
        let pid = match (self.derivative_time, self.derivative_filter, self.output_filter) {
            (None, _, None) => self.proportional_gain,
            (Some(td), Some(filter), None) => self.proportional_gain * (1.0 + td * filter.bandwidth()),
            (Some(_), None, None) => return None,
            (Some(td), None, Some(OutputFilter { a1, a2: 0.0 })) => self.proportional_gain * td / a1,
            (_, _, Some(_)) => 0.0,
        };
        Some((pid + self.observer.map_or(0.0, |o| o.gain)).abs())
    }
}
