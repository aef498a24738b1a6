//! Why there is no conversion.

use thiserror::Error;

use crate::model::TextError;
use crate::model::text::one_line;

/// Bad input to a conversion.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ConvertError {
    /// No vendor's block has this identifier.
    #[error("unknown vendor '{}'{}", one_line(given), hint(*nearest))]
    UnknownVendor {
        /// The identifier given.
        given: String,
        /// The known identifier that looks most like it.
        nearest: Option<&'static str>,
    },
    /// A span or a setting is not what it must be.
    #[error(transparent)]
    Text(#[from] TextError),
}

fn hint(nearest: Option<&str>) -> String {
    nearest.map_or_else(
        || ": 'holdup convert' lists them".to_owned(),
        |nearest| format!(": did you mean '{nearest}'?"),
    )
}

/// Why a vendor's block cannot run a controller at all: an answer, not a mistake of the user.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{reason}")]
pub struct Refusal {
    /// The reason, one sentence without a full stop.
    pub reason: String,
}

impl Refusal {
    pub(crate) fn because(reason: impl Into<String>) -> Self {
        Self { reason: reason.into() }
    }
}
