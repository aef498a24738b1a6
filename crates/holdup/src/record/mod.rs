//! From plant data to a model: records are read, looked at, and identified.

pub mod confidence;
pub mod controller;
pub mod identify;
mod read;
mod replay;
mod samples;

pub use read::{
    DateOrder, DecimalMark, Found, FoundColumn, GREATEST, Place, ReadError, ReadOptions, Reading, Repair,
    RepairKind, TimeFormat, read, read_bytes,
};
pub use samples::{Operation, Record, RecordError};
