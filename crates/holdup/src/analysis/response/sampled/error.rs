//! Why a sampled loop cannot be simulated.

use holdup_control::SettingError;
use thiserror::Error;

use crate::model::NoSampledLaw;

/// Why a sampled loop cannot be simulated. `sample_period` and `horizon` are called as in the files.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SampledError {
    /// There is no sampled law for this controller on this process.
    #[error(transparent)]
    Law(#[from] NoSampledLaw),
    /// The law refuses its settings.
    #[error("the sampled law: {0}")]
    Setting(#[from] SettingError),
    /// The sample period is longer than the dead time.
    #[error("sample_period is {value}: must be at most the dead time of {dead_time} s")]
    SlowerThanDeadTime {
        /// The sample period [s].
        value: f64,
        /// The dead time [s].
        dead_time: f64,
    },
    /// The continuous loop is stable and the sampled one is not.
    #[error(
        "sample_period is {value}: must be at most about {largest:.4} s: the loop is stable without sampling, and unstable \
         with samples this far apart"
    )]
    SlowerThanStable {
        /// The sample period [s].
        value: f64,
        /// The largest sample period up to which the loop is stable [s].
        largest: f64,
    },
    /// There are too many samples in a dead time or in the horizon.
    #[error(
        "sample_period is {value}: must be at least {least}, so that the {of} has at most {most} samples"
    )]
    TooManySamples {
        /// The sample period [s].
        value: f64,
        /// The least sample period [s].
        least: f64,
        /// What has too many samples.
        of: &'static str,
        /// How many it may have.
        most: u32,
    },
    /// A load ramp does not end before the horizon.
    #[error("load_ramp ends at {value} s: must end before the horizon of {horizon} s or at it")]
    RampBeyondHorizon {
        /// Its end [s].
        value: f64,
        /// The horizon [s].
        horizon: f64,
    },
    /// A requested time is outside 0 … horizon, or not a number.
    #[error("time {value} s is outside 0 to the horizon of {horizon} s")]
    TimeOutside {
        /// The time asked for [s].
        value: f64,
        /// The horizon [s].
        horizon: f64,
    },
}

impl SampledError {
    /// The setting that the line begins with, where it is one of the equipment's or the scenario's.
    #[must_use]
    pub fn setting(&self) -> Option<&'static str> {
        match self {
            Self::SlowerThanDeadTime { .. } | Self::SlowerThanStable { .. } | Self::TooManySamples { .. } => {
                Some("sample_period")
            }
            Self::RampBeyondHorizon { .. } => Some("load_ramp"),
            Self::Law(_) | Self::Setting(_) | Self::TimeOutside { .. } => None,
        }
    }

    /// The line with that setting called `name`.
    #[must_use]
    pub fn called(&self, name: &str) -> String {
        let line = self.to_string();
        match self.setting() {
            Some(setting) => format!("{name}{}", line.strip_prefix(setting).unwrap_or(&line)),
            None => line,
        }
    }
}
