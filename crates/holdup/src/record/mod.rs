//! From plant data to a model: records are read, looked at, and identified.

pub mod confidence;
pub mod identify;
mod samples;

pub use samples::{Operation, Record, RecordError};
