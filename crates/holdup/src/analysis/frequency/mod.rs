//! Frequency analysis, exact: crossovers, margins, peaks and the stability verdict.
//!
//! Dead time stays what it is: no approximation by a rational function and no frequency grid. Every bracket is
//! proven, every root polished to rounding; how is said in the modules.

mod characteristic;
mod envelope;
mod error;
pub mod family;
mod functions;
mod lifted;
mod margins;
mod poles;
mod polynomial;
mod quasi_polynomial;
pub mod region;
pub mod sampled;
mod scan;
mod series;
mod taylor;
mod transfer;
mod winding;

pub use error::FrequencyError;
pub use margins::{Margins, margins};
pub use poles::{Pole, dominant_poles};
pub use transfer::{FrequencyPoint, LoopTransfer, loop_without_observer, observer_loop};
