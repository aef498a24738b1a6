//! Frequency analysis, exact: crossovers, margins, peaks and the stability verdict.
//!
//! Dead time stays what it is: no approximation by a rational function and no frequency grid. Every bracket is
//! proven, every root polished to rounding; how is said in the modules.

mod characteristic;
mod envelope;
mod error;
mod functions;
mod margins;
mod polynomial;
mod quasi_polynomial;
mod scan;
mod taylor;
mod winding;

pub use error::FrequencyError;
pub use margins::{Margins, margins};
