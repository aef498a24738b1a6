//! Process and controller as plain data with the names of the JSON contract: what is written and read there.

use serde::{Deserialize, Serialize};

use super::compensator::Compensator;
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
    /// [`Controller::structure`]; read back only of a dead-time compensator, which has `parameters`.
    #[serde(default)]
    pub structure: String,
    /// Proportional gain Kc [input unit / output unit]; of a compensator the gain of its main control, not read back.
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
    /// The parameters of a dead-time compensator ([`Compensator::parameters`]); empty for a PID law.
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
            parameters: controller.compensator().map_or_else(serde_json::Map::new, |compensator| {
                let named = compensator.parameters().into_iter();
                named.map(|(name, value)| (name.to_owned(), value.into())).collect()
            }),
            published: serde_json::Value::Null,
        }
    }
}

impl TryFrom<&ControllerDescription> for Controller {
    type Error = ModelError;

    fn try_from(description: &ControllerDescription) -> Result<Self, ModelError> {
        if !description.parameters.is_empty() {
            return compensator(description);
        }
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

/// The compensator of a description with parameters; the terms of a PID law beside them are a contradiction.
fn compensator(description: &ControllerDescription) -> Result<Controller, ModelError> {
    let number = |(name, value): (&String, &serde_json::Value)| match value.as_f64() {
        Some(number) => Ok((name.clone(), number)),
        None => Err(ModelError::Conflict { name: "parameters", reason: "has a value that is not a number" }),
    };
    let parameters = description.parameters.iter().map(number).collect::<Result<Vec<_>, _>>()?;
    let controller: Controller = Compensator::from_parameters(&description.structure, &parameters)?.into();
    let same = ControllerDescription {
        proportional_gain: description.proportional_gain,
        published: description.published.clone(),
        parameters: description.parameters.clone(),
        ..ControllerDescription::from(&controller)
    };
    if same == *description {
        Ok(controller)
    } else {
        let reason = "are those of a dead-time compensator: no term of a PID law can stand beside them";
        Err(ModelError::Conflict { name: "parameters", reason })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::notation::read_controller;
    use crate::model::{CompensatorLaw, Seconds};
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

    #[test]
    fn a_compensator_comes_back_from_json_and_takes_no_terms_beside_it() {
        let law = CompensatorLaw::InverseModel { main_gain: 0.25, filter_time: 2.0 };
        let controller = Controller::from(Compensator::new(law, 0.5, Seconds(3.0)).unwrap());
        let mut json = serde_json::to_value(ControllerDescription::from(&controller)).unwrap();
        assert_eq!(
            (&json["structure"], &json["parameters"]["filter_time_s"]),
            (&"P+inverse-DOB".into(), &2.0.into())
        );
        let read = |json: &serde_json::Value| {
            Controller::try_from(&serde_json::from_value::<ControllerDescription>(json.clone()).unwrap())
        };
        assert_eq!(read(&json), Ok(controller));
        json["integral_time_s"] = 3.0.into();
        assert!(read(&json).unwrap_err().to_string().contains("no term of a PID law"));
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
