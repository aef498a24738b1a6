//! From plant data to a model: records are read, looked at, and identified.

mod samples;

pub use samples::{Operation, Record, RecordError};
