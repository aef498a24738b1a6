//! The settings of a process and of a controller as a text gives them, before they are checked: what the
//! compact notation, the files and JSON have in common.

use super::controller::{Controller, Observer};
use super::error::ModelError;
use super::forms::{Form, Parallel, Series};
use super::process::Process;
use super::quantity::Seconds;

/// The settings of a process, unchecked.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ProcessSettings {
    pub(crate) process_gain: f64,
    pub(crate) dead_time: f64,
    pub(crate) lag: Option<f64>,
    pub(crate) integrators: Option<f64>,
}

impl ProcessSettings {
    pub(crate) fn process(self) -> Result<Process, ModelError> {
        let dead_time = Seconds(self.dead_time);
        let process = match self.integrators {
            None | Some(1.0) => Process::integrating(self.process_gain, dead_time)?,
            Some(2.0) => Process::double_integrating(self.process_gain, dead_time)?,
            Some(value) => {
                return Err(ModelError::OutOfRange { name: "integrators", value, allowed: "1 or 2" });
            }
        };
        self.lag.map_or(Ok(process), |lag| process.with_lag(Seconds(lag)))
    }
}

/// The settings of a controller, unchecked. Names of errors are those of the fields.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ControllerSettings {
    pub(crate) proportional_gain: f64,
    pub(crate) integral_time: Option<f64>,
    pub(crate) derivative_time: Option<f64>,
    pub(crate) integral_gain: Option<f64>,
    pub(crate) derivative_gain: Option<f64>,
    pub(crate) extras: Extras,
    pub(crate) form: Form,
}

/// The settings beside the three terms: filters, weights and observer.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Extras {
    /// Bandwidth N of the derivative filter [rad/s].
    pub derivative_filter_bandwidth: Option<f64>,
    /// Time Tf of the derivative filter [s].
    pub filter_time: Option<f64>,
    /// Observer gain Ko [input unit / output unit].
    pub observer_gain: Option<f64>,
    /// Gain of the observer's model, where it differs from the process's.
    pub observer_model_gain: Option<f64>,
    /// Dead time of the observer's model [s], where it differs from the process's.
    pub observer_model_dead_time: Option<f64>,
    /// Setpoint weight b of the proportional action [–].
    pub setpoint_weight: Option<f64>,
    /// Setpoint weight c of the derivative action [–].
    pub derivative_setpoint_weight: Option<f64>,
    /// Coefficients a1 [s] and a2 [s²] of the output filter.
    pub output_filter: Option<(f64, f64)>,
}

impl ControllerSettings {
    pub(crate) fn controller(self) -> Result<Controller, ModelError> {
        self.extras.apply(self.three_terms()?)
    }

    fn three_terms(self) -> Result<Controller, ModelError> {
        if self.form != Form::Parallel {
            for (name, gain) in
                [("integral_gain", self.integral_gain), ("derivative_gain", self.derivative_gain)]
            {
                if gain.is_some() {
                    return Err(ModelError::Conflict { name, reason: "needs form = parallel" });
                }
            }
        }
        let Self { proportional_gain, integral_time, derivative_time, .. } = self;
        match self.form {
            Form::Ideal => {
                let mut controller = Controller::proportional(proportional_gain)?;
                if let Some(ti) = integral_time {
                    controller = controller.with_integral_time(Seconds(ti))?;
                }
                if let Some(td) = derivative_time {
                    controller = controller.with_derivative_time(Seconds(td))?;
                }
                Ok(controller)
            }
            Form::Series => Series { proportional_gain, integral_time, derivative_time }.controller(),
            Form::Parallel => self.parallel(),
        }
    }

    /// `Kp + 1/(Ti·s) + Td·s`: each time is the weight of its own term, as where the form is printed with
    /// times; the gains Ki and Kd may be given instead.
    fn parallel(self) -> Result<Controller, ModelError> {
        let once = |name, time: Option<f64>, gain: Option<f64>| match (time, gain) {
            (Some(_), Some(_)) => {
                Err(ModelError::Conflict { name, reason: "is given both as a time and as a gain" })
            }
            (time, gain) => Ok(gain.or(time)),
        };
        if self.integral_time.is_some_and(|ti| ti == 0.0) || self.integral_gain == Some(0.0) {
            let reason = "is 0: leave it away where there is no integral action";
            let name = if self.integral_gain.is_some() { "integral_gain" } else { "integral_time" };
            return Err(ModelError::Conflict { name, reason });
        }
        Parallel {
            proportional_gain: self.proportional_gain,
            integral_gain: once("integral_gain", self.integral_time.map(|ti| 1.0 / ti), self.integral_gain)?,
            derivative_gain: once("derivative_gain", self.derivative_time, self.derivative_gain)?,
        }
        .controller()
    }
}

impl Extras {
    /// `controller` with these settings beside its own; what is absent here stays as it is there.
    ///
    /// # Errors
    /// [`ModelError`] if a setting is out of its range, contradicts another or needs one that is absent.
    pub fn apply(self, mut controller: Controller) -> Result<Controller, ModelError> {
        let conflict = |name, reason| Err(ModelError::Conflict { name, reason });
        let has_derivative = controller.derivative_time().is_some();
        match (self.derivative_filter_bandwidth, self.filter_time) {
            (Some(_), Some(_)) => {
                return conflict(
                    "filter_time",
                    "the filter has a bandwidth already: give the bandwidth or the time",
                );
            }
            (Some(_), None) if !has_derivative => {
                return conflict(
                    "derivative_filter_bandwidth",
                    "needs a derivative time greater than 0 to filter",
                );
            }
            (None, Some(_)) if !has_derivative => {
                return conflict("filter_time", "needs a derivative time greater than 0 to filter");
            }
            (Some(n), None) => controller = controller.with_filter_bandwidth(n)?,
            (None, Some(tf)) => controller = controller.with_filter_time(Seconds(tf))?,
            (None, None) => {}
        }
        if controller.compensator().is_some() && self.observer_gain.is_some() {
            return conflict("observer_gain", "is not a setting of a dead-time compensator: it has its own");
        }
        let observer = match (self.observer_gain, controller.observer()) {
            (Some(gain), _) => Some(Observer::new(gain)?),
            (None, given) => given,
        };
        if let Some(mut observer) = observer {
            if let Some(gain) = self.observer_model_gain {
                observer = observer.with_model_gain(gain)?;
            }
            if let Some(dead_time) = self.observer_model_dead_time {
                observer = observer.with_model_dead_time(Seconds(dead_time))?;
            }
            controller = controller.with_observer(observer);
        } else if self.observer_model_gain.is_some() {
            return conflict("observer_model_gain", "needs an observer gain: there is no observer");
        } else if self.observer_model_dead_time.is_some() {
            return conflict("observer_model_dead_time", "needs an observer gain: there is no observer");
        }
        if let Some((a1, a2)) = self.output_filter {
            controller = controller.with_output_filter(a1, a2)?;
        }
        controller.with_setpoint_weights(
            self.setpoint_weight.unwrap_or(controller.setpoint_weight()),
            self.derivative_setpoint_weight.unwrap_or(controller.derivative_setpoint_weight()),
        )
    }
}
