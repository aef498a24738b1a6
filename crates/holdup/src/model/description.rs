//! Process and controller as plain data with the names of the JSON contract: what is written and read there.

use serde::{Deserialize, Serialize};

use super::controller::{Controller, DerivativeFilter};
use super::error::ModelError;
use super::process::Process;
use super::settings::{ControllerSettings, Extras, ProcessSettings};

/// A process under the names of the JSON contract.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ProcessDescription {
    /// Process gain K [output unit per (input unit · sⁿ)].
    pub process_gain: f64,
    /// Dead time d [s].
    pub dead_time_s: f64,
    /// Lag T [s], or null.
    #[serde(default)]
    pub lag_s: Option<f64>,
    /// Number of integrators.
    #[serde(default = "one")]
    pub integrators: u8,
}

/// A controller under the names of the JSON contract; what is absent is null.
///
/// ```
/// use holdup::model::{Controller, description::ControllerDescription, notation::read_controller};
/// let description = ControllerDescription::from(&read_controller("Kc=2,Ti=15")?);
/// assert_eq!((description.structure.as_str(), description.integral_time_s), ("PI", Some(15.0)));
/// assert_eq!(Controller::try_from(&description).unwrap(), read_controller("Kc=2,Ti=15")?);
/// # Ok::<(), holdup::model::TextError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ControllerDescription {
    /// `P`, `PI`, `PD` or `PID`, followed by `+DOB` with an observer; not read back.
    #[serde(default)]
    pub structure: String,
    /// Proportional gain Kc [input unit / output unit].
    pub proportional_gain: f64,
    /// Integral time Ti [s].
    #[serde(default)]
    pub integral_time_s: Option<f64>,
    /// Derivative time Td [s].
    #[serde(default)]
    pub derivative_time_s: Option<f64>,
    /// Bandwidth N [rad/s] of the derivative filter, where it was given as a bandwidth.
    #[serde(default)]
    pub derivative_filter_bandwidth: Option<f64>,
    /// Time Tf [s] of the derivative filter, where it was given as a time.
    #[serde(default)]
    pub filter_time_s: Option<f64>,
    /// Observer gain Ko [input unit / output unit].
    #[serde(default)]
    pub observer_gain: Option<f64>,
    /// Gain of the observer's model, where it differs from the process's.
    #[serde(default)]
    pub observer_model_gain: Option<f64>,
    /// Dead time [s] of the observer's model, where it differs from the process's.
    #[serde(default)]
    pub observer_model_dead_time_s: Option<f64>,
    /// Setpoint weight b of the proportional action [–].
    #[serde(default = "one")]
    pub setpoint_weight: f64,
    /// Setpoint weight c of the derivative action [–].
    #[serde(default = "one")]
    pub derivative_setpoint_weight: f64,
    /// Filter of the whole output.
    #[serde(default)]
    pub output_filter: Option<OutputFilterDescription>,
    /// Further parameters; empty for the structures that need none.
    #[serde(default)]
    pub parameters: serde_json::Map<String, serde_json::Value>,
    /// The settings in the form of their source, where they come from a rule.
    #[serde(default)]
    pub published: serde_json::Value,
}

/// The coefficients of an output filter `1/(a2·s² + a1·s + 1)`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OutputFilterDescription {
    /// Coefficient a1 [s].
    pub a1_s: f64,
    /// Coefficient a2 [s²].
    pub a2_s2: f64,
}

fn one<T: From<u8>>() -> T {
    T::from(1)
}

impl From<&Process> for ProcessDescription {
    fn from(process: &Process) -> Self {
        Self {
            process_gain: process.process_gain(),
            dead_time_s: process.dead_time(),
            lag_s: process.lag(),
            integrators: process.integrators(),
        }
    }
}

impl TryFrom<&ProcessDescription> for Process {
    type Error = ModelError;

    fn try_from(description: &ProcessDescription) -> Result<Self, ModelError> {
        ProcessSettings {
            process_gain: description.process_gain,
            dead_time: description.dead_time_s,
            lag: description.lag_s,
            integrators: Some(f64::from(description.integrators)),
        }
        .process()
    }
}

impl From<&Controller> for ControllerDescription {
    fn from(controller: &Controller) -> Self {
        let (bandwidth, filter_time) = match controller.derivative_filter() {
            None => (None, None),
            Some(DerivativeFilter::Bandwidth(n)) => (Some(n), None),
            Some(DerivativeFilter::Time(tf)) => (None, Some(tf)),
        };
        let observer = controller.observer();
        Self {
            structure: controller.structure().to_owned(),
            proportional_gain: controller.proportional_gain(),
            integral_time_s: controller.integral_time(),
            derivative_time_s: controller.derivative_time(),
            derivative_filter_bandwidth: bandwidth,
            filter_time_s: filter_time,
            observer_gain: observer.map(|o| o.gain()),
            observer_model_gain: observer.and_then(|o| o.model_gain()),
            observer_model_dead_time_s: observer.and_then(|o| o.model_dead_time()),
            setpoint_weight: controller.setpoint_weight(),
            derivative_setpoint_weight: controller.derivative_setpoint_weight(),
            output_filter: controller
                .output_filter()
                .map(|filter| OutputFilterDescription { a1_s: filter.a1, a2_s2: filter.a2 }),
            parameters: serde_json::Map::new(),
            published: serde_json::Value::Null,
        }
    }
}

impl TryFrom<&ControllerDescription> for Controller {
    type Error = ModelError;

    fn try_from(description: &ControllerDescription) -> Result<Self, ModelError> {
        ControllerSettings {
            proportional_gain: description.proportional_gain,
            integral_time: description.integral_time_s,
            derivative_time: description.derivative_time_s,
            extras: Extras {
                derivative_filter_bandwidth: description.derivative_filter_bandwidth,
                filter_time: description.filter_time_s,
                observer_gain: description.observer_gain,
                observer_model_gain: description.observer_model_gain,
                observer_model_dead_time: description.observer_model_dead_time_s,
                setpoint_weight: Some(description.setpoint_weight),
                derivative_setpoint_weight: Some(description.derivative_setpoint_weight),
                output_filter: description.output_filter.map(|filter| (filter.a1_s, filter.a2_s2)),
            },
            ..ControllerSettings::default()
        }
        .controller()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::notation::read_controller;
    use proptest::prelude::*;

    #[test]
    fn the_json_names_are_those_of_the_contract_and_absence_is_null() {
        let json =
            serde_json::to_value(ControllerDescription::from(&read_controller("Kc=2").unwrap())).unwrap();
        for name in [
            "structure",
            "proportional_gain",
            "integral_time_s",
            "derivative_time_s",
            "derivative_filter_bandwidth",
            "filter_time_s",
            "observer_gain",
            "setpoint_weight",
            "derivative_setpoint_weight",
            "output_filter",
            "parameters",
            "published",
        ] {
            assert!(json.get(name).is_some(), "{name}");
        }
        assert!(json["integral_time_s"].is_null() && json["output_filter"].is_null());
    }

    proptest! {
        #[test]
        fn a_controller_comes_back_from_json(
            kc in 0.01..9.0_f64, ti in proptest::option::of(0.01..9.0_f64), td in proptest::option::of(0.01..9.0_f64),
            filter in 0..3_u8, value in 0.01..9.0_f64, observer in any::<bool>(), output in any::<bool>(),
        ) {
            let mut text = format!("Kc={kc},b={value},c={}", -value);
            ti.inspect(|ti| text.push_str(&format!(",Ti={ti}")));
            td.inspect(|td| text.push_str(&format!(",Td={td}{}", [String::new(), format!(",N={value}"), format!(",Tf={value}")][usize::from(filter)])));
            if observer { text.push_str(&format!(",Ko={value},dm={value}")); }
            if output { text.push_str(&format!(",a1={value}")); }
            let controller = read_controller(&text).unwrap();
            let json = serde_json::to_string(&ControllerDescription::from(&controller)).unwrap();
            let back: ControllerDescription = serde_json::from_str(&json).unwrap();
            // serde_json reads floats to the last bit only with a feature; compact text carries the exact ones.
            prop_assert_eq!(back.structure, controller.structure());
            prop_assert_eq!(Controller::try_from(&ControllerDescription::from(&controller)), Ok(controller));
        }
    }
}
