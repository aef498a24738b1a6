//! What a controller was asked to do.

use serde::Serialize;

/// What was asked for. What is achieved is another type, which only the analysis makes.
///
/// A rule without a stated property leaves everything absent.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Specification {
    /// Gain margin asked for [ratio].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gain_margin: Option<f64>,
    /// Phase margin asked for [rad]; in JSON in degrees.
    #[serde(
        rename = "phase_margin_deg",
        serialize_with = "in_degrees",
        skip_serializing_if = "Option::is_none"
    )]
    pub phase_margin: Option<f64>,
    /// Settling time asked for, 2 % band, dead time included [s].
    #[serde(rename = "settling_time_s", skip_serializing_if = "Option::is_none")]
    pub settling_time: Option<f64>,
    /// Sensitivity peak asked for [ratio].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sensitivity_peak: Option<f64>,
    /// Delay margin asked for [s].
    #[serde(rename = "delay_margin_s", skip_serializing_if = "Option::is_none")]
    pub delay_margin: Option<f64>,
    /// Overshoot of a setpoint step asked for [ratio].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub overshoot: Option<f64>,
    /// Time constant of the closed loop asked for [s].
    #[serde(rename = "closed_loop_time_constant_s", skip_serializing_if = "Option::is_none")]
    pub closed_loop_time_constant: Option<f64>,
    /// Damping ratio of the dominant poles asked for [ratio].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub damping_ratio: Option<f64>,
}

impl std::fmt::Display for Specification {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let parts = [
            ("gain margin", self.gain_margin, ""),
            ("phase margin", self.phase_margin.map(f64::to_degrees), "°"),
            ("settling time", self.settling_time, " s"),
            ("sensitivity peak", self.sensitivity_peak, ""),
            ("delay margin", self.delay_margin, " s"),
            ("overshoot", self.overshoot, ""),
            ("closed-loop time constant", self.closed_loop_time_constant, " s"),
            ("damping ratio", self.damping_ratio, ""),
        ];
        let mut separator = "";
        for (name, value, unit) in parts {
            if let Some(value) = value {
                write!(f, "{separator}{name} {}{unit}", rounded(value))?;
                separator = ", ";
            }
        }
        Ok(())
    }
}

/// The value with six significant digits, for reading.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

#[expect(clippy::ref_option, reason = "the signature serde calls")]
fn in_degrees<S: serde::Serializer>(angle: &Option<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    angle.map(f64::to_degrees).serialize(serializer)
}

/// The property that a parameter of a rule asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Property {
    /// Gain margin [ratio].
    GainMargin,
    /// Phase margin, in the unit of the parameter.
    PhaseMargin,
    /// Settling time, 2 % [s].
    SettlingTime,
    /// Sensitivity peak [ratio].
    SensitivityPeak,
    /// Delay margin as a multiple of the dead time [ratio].
    RelativeDelayMargin,
    /// Overshoot, in the unit of the parameter.
    Overshoot,
    /// Closed-loop time constant [s].
    ClosedLoopTimeConstant,
    /// Damping ratio of the dominant poles [ratio].
    DampingRatio,
}

#[cfg(test)]
mod tests {
    use super::Specification;

    #[test]
    fn json_carries_the_unit_in_the_name_and_only_what_was_asked() {
        let asked = Specification {
            phase_margin: Some(std::f64::consts::PI),
            settling_time: Some(40.0),
            ..Specification::default()
        };
        let json = serde_json::to_string(&asked).unwrap();
        assert_eq!(json, r#"{"phase_margin_deg":180.0,"settling_time_s":40.0}"#);
    }
}
