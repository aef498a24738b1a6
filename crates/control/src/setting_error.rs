//! Why a setting is refused.

use core::fmt;

/// A setting that no controller can run with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SettingError {
    /// A value outside what the parameter allows.
    OutOfRange {
        /// The parameter, by its name in this crate.
        parameter: &'static str,
        /// The value given, in the parameter's unit.
        value: f64,
        /// What is allowed.
        requirement: &'static str,
    },
    /// A delay line with too few segments for the dead time at the sample period.
    LineTooShort {
        /// Segments the storage has.
        segments: usize,
        /// Segments it needs.
        needed: usize,
    },
}

impl fmt::Display for SettingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange { parameter, value, requirement } => {
                write!(f, "{parameter} = {value}: {requirement}")
            }
            Self::LineTooShort { segments, needed } => {
                write!(f, "the delay line has {segments} segments: the dead time needs {needed}")
            }
        }
    }
}

impl core::error::Error for SettingError {}

pub(crate) mod require {
    //! The requirements that several parameters share.

    use super::SettingError;
    use crate::Scalar;

    fn check<T: Scalar>(
        holds: bool,
        parameter: &'static str,
        value: T,
        requirement: &'static str,
    ) -> Result<T, SettingError> {
        if holds {
            Ok(value)
        } else {
            Err(SettingError::OutOfRange { parameter, value: value.to_f64(), requirement })
        }
    }

    pub(crate) fn finite<T: Scalar>(parameter: &'static str, value: T) -> Result<T, SettingError> {
        check(value.is_finite(), parameter, value, "must be finite")
    }

    pub(crate) fn nonzero<T: Scalar>(parameter: &'static str, value: T) -> Result<T, SettingError> {
        check(value.is_finite() && value != T::ZERO, parameter, value, "must be finite and not 0")
    }

    pub(crate) fn positive<T: Scalar>(parameter: &'static str, value: T) -> Result<T, SettingError> {
        check(value.is_finite() && value > T::ZERO, parameter, value, "must be finite and above 0")
    }

    pub(crate) fn not_negative<T: Scalar>(parameter: &'static str, value: T) -> Result<T, SettingError> {
        check(value.is_finite() && value >= T::ZERO, parameter, value, "must be finite and not below 0")
    }

    pub(crate) fn that<T: Scalar>(
        holds: bool,
        parameter: &'static str,
        value: T,
        requirement: &'static str,
    ) -> Result<(), SettingError> {
        check(holds, parameter, value, requirement).map(|_| ())
    }
}
