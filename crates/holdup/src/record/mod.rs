//! From plant data to a model: records are read, looked at, and identified.

mod advice;
pub mod confidence;
pub mod controller;
mod diagnosis;
mod excitation;
mod identification;
pub mod identify;
mod judgement;
mod load;
mod load_steps;
mod read;
pub mod relay;
mod replay;
mod retuning;
mod samples;
mod survey;
mod valve;
pub(crate) mod wording;

pub use advice::SafeTest;
pub use diagnosis::Diagnosis;
pub use excitation::Excitation;
pub use identification::{
    Candidate, FitQuality, Identification, IdentifiedProcess, IdentifyOptions, Verdict,
};
pub use judgement::{IdentifyError, identify};
pub use load::RecoveredLoad;
pub use load_steps::LoadStep;
pub use read::{
    DateOrder, DecimalMark, Found, FoundColumn, GREATEST, PARQUET_THREAD, Place, ReadError, ReadOptions,
    Reading, Repair, RepairKind, TimeFormat, read, read_bytes,
};
pub use retuning::{Replay, RetuneError, Retuning, Worst, retune, running_controller};
pub use samples::{Operation, Record, RecordError};
pub use survey::{
    Compression, CompressionKind, Gap, Limit, Move, Noise, OperationShares, Oscillation, Quantisation,
    Sampling, Shape, Signal, Span, Survey, Switch, Window,
};
