//! The settings of a dead-time compensator by name, as JSON and the loop file have them.

use super::compensator::{Compensator, CompensatorLaw, Lead};
use super::error::ModelError;
use super::quantity::Seconds;

/// The structures of compensators and the names of their settings, the model's last.
const NAMES: [(&str, &[&str]); 4] = [
    (
        "SP+DOB",
        &["main_gain", "disturbance_gain", "lead_time_s", "filter_time_s", "model_gain", "model_dead_time_s"],
    ),
    ("2DOF-DTC", &["setpoint_time_s", "a1_s", "a2_s2", "model_gain", "model_dead_time_s"]),
    ("P+inverse-DOB", &["main_gain", "filter_time_s", "model_gain", "model_dead_time_s"]),
    ("ADRC", &["controller_bandwidth_rad_s", "observer_bandwidth_rad_s", "model_gain", "model_dead_time_s"]),
];

impl Compensator {
    /// The settings by name, the unit in the name: what [`Compensator::from_parameters`] reads.
    ///
    /// ```
    /// use holdup::model::{Compensator, CompensatorLaw, Seconds};
    /// let law = CompensatorLaw::InverseModel { main_gain: 0.4, filter_time: 2.0 };
    /// let compensator = Compensator::new(law, 1.0, Seconds(2.0))?;
    /// let parameters = compensator.parameters();
    /// assert_eq!(parameters[1], ("filter_time_s", 2.0));
    /// assert_eq!(Compensator::from_parameters(compensator.structure(), &parameters), Ok(compensator));
    /// # Ok::<(), holdup::model::ModelError>(())
    /// ```
    #[must_use]
    pub fn parameters(&self) -> Vec<(&'static str, f64)> {
        let mut settings = match self.law() {
            CompensatorLaw::ModifiedSmith { main_gain, disturbance_gain, lead } => {
                let mut settings = vec![("main_gain", main_gain), ("disturbance_gain", disturbance_gain)];
                if let Some(Lead { derivative_time, filter_time }) = lead {
                    settings.extend([("lead_time_s", derivative_time), ("filter_time_s", filter_time)]);
                }
                settings
            }
            CompensatorLaw::TwoDegree { setpoint_time, a1, a2 } => {
                vec![("setpoint_time_s", setpoint_time), ("a1_s", a1), ("a2_s2", a2)]
            }
            CompensatorLaw::InverseModel { main_gain, filter_time } => {
                vec![("main_gain", main_gain), ("filter_time_s", filter_time)]
            }
            CompensatorLaw::DisturbanceRejection { controller_bandwidth, observer_bandwidth } => vec![
                ("controller_bandwidth_rad_s", controller_bandwidth),
                ("observer_bandwidth_rad_s", observer_bandwidth),
            ],
        };
        settings.extend([("model_gain", self.model_gain()), ("model_dead_time_s", self.model_dead_time())]);
        settings
    }

    /// The compensator of a structure with these settings.
    ///
    /// # Errors
    /// [`ModelError`] if the structure is none of a compensator, a setting is missing, unknown to it, or out of
    /// its range.
    pub fn from_parameters<N: AsRef<str>>(
        structure: &str,
        settings: &[(N, f64)],
    ) -> Result<Self, ModelError> {
        let conflict = |name, reason| Err(ModelError::Conflict { name, reason });
        let Some((_, names)) = NAMES.iter().find(|(name, _)| *name == structure) else {
            let reason = "must be SP+DOB, 2DOF-DTC, P+inverse-DOB or ADRC where there are parameters";
            return conflict("structure", reason);
        };
        if settings.iter().any(|(name, _)| !names.contains(&name.as_ref())) {
            return conflict("parameters", "has a name that this structure does not know");
        }
        let optional =
            |name: &str| settings.iter().find(|(given, _)| given.as_ref() == name).map(|(_, v)| *v);
        let required = |name: &'static str| {
            optional(name).ok_or(ModelError::Conflict { name, reason: "is missing from the parameters" })
        };
        let law = match structure {
            "SP+DOB" => CompensatorLaw::ModifiedSmith {
                main_gain: required("main_gain")?,
                disturbance_gain: required("disturbance_gain")?,
                lead: match (optional("lead_time_s"), optional("filter_time_s")) {
                    (None, None) => None,
                    _ => Some(Lead {
                        derivative_time: required("lead_time_s")?,
                        filter_time: required("filter_time_s")?,
                    }),
                },
            },
            "2DOF-DTC" => CompensatorLaw::TwoDegree {
                setpoint_time: required("setpoint_time_s")?,
                a1: required("a1_s")?,
                a2: required("a2_s2")?,
            },
            "P+inverse-DOB" => CompensatorLaw::InverseModel {
                main_gain: required("main_gain")?,
                filter_time: required("filter_time_s")?,
            },
            _ => CompensatorLaw::DisturbanceRejection {
                controller_bandwidth: required("controller_bandwidth_rad_s")?,
                observer_bandwidth: required("observer_bandwidth_rad_s")?,
            },
        };
        Self::new(law, required("model_gain")?, Seconds(required("model_dead_time_s")?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrong_structure_a_missing_and_an_unknown_setting_are_named() {
        let message = |structure: &str, settings: &[(&str, f64)]| {
            Compensator::from_parameters(structure, settings).unwrap_err().to_string()
        };
        assert!(message("PID", &[]).starts_with("structure: must be SP+DOB"));
        assert!(message("ADRC", &[("a1_s", 1.0)]).starts_with("parameters: has a name"));
        assert!(message("P+inverse-DOB", &[("main_gain", 1.0)]).starts_with("filter_time_s: is missing"));
    }
}
