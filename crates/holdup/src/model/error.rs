//! What may be wrong with a process, a controller or their text.

use thiserror::Error;

/// A value or a combination of values that no process or controller can have.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ModelError {
    /// A number lies outside its range, or is not a finite number.
    #[error("{name} is {value}: must be {allowed}")]
    OutOfRange {
        /// Name of the quantity, as in the files and on the command line.
        name: &'static str,
        /// The value given.
        value: f64,
        /// What is allowed, in words.
        allowed: &'static str,
    },
    /// Two settings contradict each other, or one needs another that is absent.
    #[error("{name}: {reason}")]
    Conflict {
        /// Name of the setting that cannot stand.
        name: &'static str,
        /// Why not.
        reason: &'static str,
    },
}

/// `value` if it is finite and greater than 0.
pub(crate) fn positive(name: &'static str, value: f64) -> Result<f64, ModelError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(out_of_range(name, value, "a finite number greater than 0"))
    }
}

/// `value` if it is finite and not 0.
pub(crate) fn non_zero(name: &'static str, value: f64) -> Result<f64, ModelError> {
    if value.is_finite() && value != 0.0 {
        Ok(value)
    } else {
        Err(out_of_range(name, value, "a finite number other than 0"))
    }
}

/// `value` if it is finite.
pub(crate) fn finite(name: &'static str, value: f64) -> Result<f64, ModelError> {
    if value.is_finite() { Ok(value) } else { Err(out_of_range(name, value, "a finite number")) }
}

pub(crate) fn out_of_range(name: &'static str, value: f64, allowed: &'static str) -> ModelError {
    ModelError::OutOfRange { name, value, allowed }
}
