//! From plant data to a model: records are read, looked at, and identified.

pub mod confidence;
pub mod controller;
pub mod identify;
mod read;
mod replay;
mod samples;
mod survey;

pub use read::{
    DateOrder, DecimalMark, Found, FoundColumn, GREATEST, PARQUET_THREAD, Place, ReadError, ReadOptions,
    Reading, Repair, RepairKind, TimeFormat, read, read_bytes,
};
pub use samples::{Operation, Record, RecordError};
pub use survey::{
    Compression, CompressionKind, Gap, Limit, Move, Noise, OperationShares, Oscillation, Quantisation,
    Sampling, Shape, Signal, Span, Survey, Switch, Window,
};
