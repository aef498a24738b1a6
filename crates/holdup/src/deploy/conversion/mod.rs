//! From a controller to the numbers that are typed into a vendor's block, and back.
//!
//! Every vendor's block is one file of `deploy/vendors`: a description of its equation, its parameters and its units
//! ([`Vendor`]). Both directions are computed from that description, so that what is typed and what is read back
//! cannot drift apart.
//!
//! ```
//! use holdup::deploy::conversion::{Scaling, Span, Value, convert, vendor};
//! use holdup::model::notation::read_controller;
//!
//! let pi = read_controller("Kc=20,Ti=300")?;
//! let scaling = Scaling::new(Span::new(0.0, 5.0)?, Span::new(0.0, 100.0)?);
//! let sheet = convert(vendor("yokogawa-centum")?, &pi, &scaling).sheet?;
//! // A gain of 20 %/m on a span of 5 m is 1 % per %: a proportional band of 100 %.
//! assert_eq!(sheet.parameters[0].value, Value::Number(100.0));
//! assert_eq!(sheet.run, pi);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod back;
mod effect;
mod error;
mod interacting;
mod numbers;
mod scaling;
mod settings;
mod sheet;
mod vendor;
mod weights;

pub use back::read;
pub use effect::Effect;
pub use error::{ConvertError, Refusal};
pub use scaling::{Scaling, Span};
pub use settings::{Given, Value};
pub use sheet::{Conversion, Parameter, Sheet, convert};
pub use vendor::{
    Action, Choice, Derivative, Filter, Fixed, Gain, Integral, Kind, Number, Off, Scale, Source, SpanNames,
    Vendor, Weight, Weights,
};

use crate::model::text::nearest;

/// Every registered vendor's block, in the order of the identifiers.
#[must_use]
pub fn vendors() -> &'static [&'static Vendor] {
    super::vendors::REGISTRY
}

/// The block of this identifier; underscores count as hyphens, letter case does not.
///
/// # Errors
/// [`ConvertError::UnknownVendor`], with the nearest identifier.
pub fn vendor(id: &str) -> Result<&'static Vendor, ConvertError> {
    let wanted = id.to_lowercase().replace('_', "-");
    let ids = || vendors().iter().map(|vendor| vendor.id);
    let begins = || {
        let mut matching =
            vendors().iter().copied().filter(|vendor| vendor.id.split('-').any(|word| word == wanted));
        matching.next().filter(|_| matching.next().is_none())
    };
    let named = vendors().iter().copied().find(|vendor| vendor.id == wanted);
    named.or_else(begins).ok_or_else(|| ConvertError::UnknownVendor {
        given: id.to_owned(),
        nearest: ids()
            .find(|id| id.split('-').any(|word| word == wanted))
            .or_else(|| nearest(&wanted, ids())),
    })
}
