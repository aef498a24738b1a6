//! Why a controller cannot be exported.

use std::fmt::Display;

use holdup_control::SettingError;
use thiserror::Error;

use crate::analysis::frequency::FrequencyError;
use crate::model::NoSampledLaw;

/// Why a controller cannot be exported: the setting, its value and what is allowed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ExportError {
    /// A setting of the installation is out of its range.
    #[error("{name} is {value}: must be {allowed}")]
    OutOfRange {
        /// Name of the setting.
        name: &'static str,
        /// The value given.
        value: String,
        /// What is allowed, in words.
        allowed: String,
    },
    /// The controller has no sampled law.
    #[error(transparent)]
    NoLaw(#[from] NoSampledLaw),
    /// The loop is beyond the reach of double precision.
    #[error(transparent)]
    Frequency(#[from] FrequencyError),
}

impl ExportError {
    pub(super) fn out_of_range(name: &'static str, value: impl Display, allowed: impl Into<String>) -> Self {
        Self::OutOfRange { name, value: format!("{value}"), allowed: allowed.into() }
    }
}

impl From<SettingError> for ExportError {
    fn from(error: SettingError) -> Self {
        Self::NoLaw(NoSampledLaw::Setting(error))
    }
}
