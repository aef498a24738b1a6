//! What stands between the law and the process: sampling, sensor and valve.

use crate::model::ModelError;
use crate::model::error::{finite, out_of_range, positive};

/// Settings of the equipment, before they are checked; [`Equipment::new`] checks them. The default is sampling without
/// any imperfection.
///
/// Limits, rate, stiction and quanta of the output are in the unit of the manipulated variable and in its own scale, in
/// which it rests at `initial_manipulated`: with a rest of 40 and limits of 0 and 100 the valve can close by 40 and open by 60.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EquipmentSettings {
    /// Sample period h [s].
    pub sample_period: f64,
    /// Least and greatest manipulated variable; the law knows them.
    pub limits: Option<(f64, f64)>,
    /// Greatest rate at which the valve moves [input unit/s]; the law knows it.
    pub rate_limit: Option<f64>,
    /// The manipulated variable at rest, before the first event.
    pub initial_manipulated: f64,
    /// Stickband plus deadband S and slip jump J of the valve [input unit]: the valve of Kano and others (2004).
    pub stiction: Option<(f64, f64)>,
    /// Steps in which the output comes to the valve [input unit].
    pub output_quantum: Option<f64>,
    /// Steps in which the measurement comes to the law [output unit].
    pub measurement_quantum: Option<f64>,
    /// Standard deviation of the white Gaussian noise on each measurement [output unit].
    pub noise: f64,
    /// Seed of all that is random.
    pub seed: u64,
    /// Each sample comes late by a random time, uniform from 0 to this [s].
    pub jitter: f64,
    /// Probability that a measurement is lost on its way to the law [–].
    pub drop: f64,
    /// Time from the sample until the output that follows from it is at the valve [s].
    pub computation_delay: f64,
}

/// Equipment that has been checked.
///
/// ```
/// use holdup::analysis::response::sampled::{Equipment, EquipmentSettings};
/// let settings = EquipmentSettings { sample_period: 0.5, limits: Some((0.0, 100.0)), ..Default::default() };
/// assert!(Equipment::new(settings.clone()).is_ok());
/// let error = Equipment::new(EquipmentSettings { limits: Some((100.0, 0.0)), ..settings }).unwrap_err();
/// assert_eq!(error.to_string(), "limits is 100: must be a low limit below the high one of 0");
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Equipment(EquipmentSettings);

impl Equipment {
    /// Checks the settings.
    ///
    /// # Errors
    /// [`EquipmentError`] that names the setting as the field is named here.
    pub fn new(settings: EquipmentSettings) -> Result<Self, EquipmentError> {
        let h = positive("sample_period", settings.sample_period)?;
        let rest = finite("initial_manipulated", settings.initial_manipulated)?;
        if let Some((low, high)) = settings.limits {
            finite("limits", low)?;
            finite("limits", high)?;
            if low >= high {
                let allowed = format!("a low limit below the high one of {high}");
                return Err(EquipmentError::Outside { name: "limits", value: low, allowed });
            }
            if rest < low || rest > high {
                let allowed = format!("within the limits, {low} to {high}");
                return Err(EquipmentError::Outside { name: "initial_manipulated", value: rest, allowed });
            }
        }
        for (name, value) in [
            ("rate_limit", settings.rate_limit),
            ("output_quantum", settings.output_quantum),
            ("measurement_quantum", settings.measurement_quantum),
        ] {
            value.map_or(Ok(0.0), |value| positive(name, value))?;
        }
        let (s, j) = settings.stiction.unwrap_or_default();
        for (name, value) in [
            ("stiction", s),
            ("stiction", j),
            ("noise", settings.noise),
            ("jitter", settings.jitter),
            ("computation_delay", settings.computation_delay),
        ] {
            if !(value.is_finite() && value >= 0.0) {
                return Err(out_of_range(name, value, "a finite number, 0 or greater").into());
            }
        }
        if !(settings.drop >= 0.0 && settings.drop < 1.0) {
            return Err(out_of_range("drop", settings.drop, "a probability, at least 0 and below 1").into());
        }
        // Then every output is at the valve before the next sample is taken.
        let room = h - settings.jitter;
        if settings.jitter >= h {
            let allowed = format!("below the sample period of {h} s");
            return Err(EquipmentError::Outside { name: "jitter", value: settings.jitter, allowed });
        }
        if settings.computation_delay > room * (1.0 + 1e-12) {
            let value = settings.computation_delay;
            let allowed = format!("at most {room} s: with the jitter within one sample period");
            return Err(EquipmentError::Outside { name: "computation_delay", value, allowed });
        }
        Ok(Self(settings))
    }

    /// The settings.
    #[must_use]
    pub fn settings(&self) -> &EquipmentSettings {
        &self.0
    }

    /// Whether the loop with this equipment is the linear one that the margins speak of: no limit, no friction, no
    /// quantum, nothing random.
    #[must_use]
    pub fn is_linear(&self) -> bool {
        let bare = EquipmentSettings {
            sample_period: self.0.sample_period,
            initial_manipulated: self.0.initial_manipulated,
            seed: self.0.seed,
            computation_delay: self.0.computation_delay,
            ..EquipmentSettings::default()
        };
        self.0 == bare
    }
}

/// Equipment that there cannot be: the setting, its value, what is allowed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum EquipmentError {
    /// A number outside its range.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A number outside a range that follows from another setting.
    #[error("{name} is {value}: must be {allowed}")]
    Outside {
        /// Name of the setting.
        name: &'static str,
        /// The value given.
        value: f64,
        /// What is allowed, in words.
        allowed: String,
    },
}

impl EquipmentError {
    /// Name of the setting.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Model(ModelError::OutOfRange { name, .. } | ModelError::Conflict { name, .. })
            | Self::Outside { name, .. } => name,
        }
    }

    /// The line without the name of the setting: for a file or an option that calls it otherwise.
    #[must_use]
    pub fn bare(&self) -> (String, String) {
        match self {
            Self::Model(ModelError::OutOfRange { value, allowed, .. }) => {
                (value.to_string(), (*allowed).to_owned())
            }
            Self::Model(ModelError::Conflict { reason, .. }) => (String::new(), (*reason).to_owned()),
            Self::Outside { value, allowed, .. } => (value.to_string(), allowed.clone()),
        }
    }
}

/// A load that changes in a straight line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadRamp {
    start: f64,
    end: f64,
    change: f64,
}

impl LoadRamp {
    /// The load changes by `change` [input unit] between `start` and `end` [s], in addition to its steps.
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] unless 0 ≤ start < end and all are finite.
    pub fn new(start: f64, end: f64, change: f64) -> Result<Self, ModelError> {
        if !(start.is_finite() && start >= 0.0) {
            return Err(out_of_range("load_ramp", start, "a finite start, 0 or later"));
        }
        if !(end.is_finite() && end > start) {
            return Err(out_of_range("load_ramp", end, "a finite end after the start"));
        }
        finite("load_ramp", change)?;
        finite("load_ramp", change / (end - start))?;
        Ok(Self { start, end, change })
    }

    /// Start [s].
    #[must_use]
    pub fn start(&self) -> f64 {
        self.start
    }

    /// End [s].
    #[must_use]
    pub fn end(&self) -> f64 {
        self.end
    }

    /// Change of the load from start to end [input unit].
    #[must_use]
    pub fn change(&self) -> f64 {
        self.change
    }

    /// Load and its rate at a time [s], from the right.
    pub(super) fn at(&self, time: f64) -> (f64, f64) {
        if time < self.start {
            (0.0, 0.0)
        } else if time < self.end {
            let rate = self.change / (self.end - self.start);
            ((time - self.start) * rate, rate)
        } else {
            (self.change, 0.0)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_setting_out_of_range_is_named_with_what_is_allowed() {
        let message = |change: fn(&mut EquipmentSettings)| {
            let mut settings = EquipmentSettings { sample_period: 0.5, ..EquipmentSettings::default() };
            change(&mut settings);
            Equipment::new(settings).unwrap_err().to_string()
        };
        assert!(message(|s| s.sample_period = 0.0).starts_with("sample_period is 0"));
        assert!(message(|s| s.noise = -0.1).starts_with("noise is -0.1"));
        assert!(message(|s| s.drop = 1.0).starts_with("drop is 1: must be a probability"));
        assert!(message(|s| s.jitter = 0.5).contains("below the sample period of 0.5 s"));
        assert!(message(|s| (s.jitter, s.computation_delay) = (0.3, 0.3)).contains("at most 0.2 s"));
        assert!(message(|s| s.rate_limit = Some(0.0)).starts_with("rate_limit is 0"));
        assert!(message(|s| s.stiction = Some((2.0, f64::NAN))).starts_with("stiction is NaN"));
        let rest = message(|s| (s.limits, s.initial_manipulated) = (Some((0.0, 100.0)), -1.0));
        assert!(rest.contains("initial_manipulated is -1: must be within the limits, 0 to 100"));
    }

    #[test]
    fn a_ramp_is_a_straight_line_between_its_ends() {
        let ramp = LoadRamp::new(10.0, 30.0, 4.0).unwrap();
        assert_eq!(ramp.at(9.0), (0.0, 0.0));
        assert_eq!(ramp.at(15.0), (1.0, 0.2));
        assert_eq!(ramp.at(30.0), (4.0, 0.0));
        assert!(LoadRamp::new(30.0, 10.0, 1.0).unwrap_err().to_string().starts_with("load_ramp is 10"));
    }
}
