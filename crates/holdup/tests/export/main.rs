//! Exported controllers against `holdup_control`: each language runs what it was given, on rich traces, and must answer
//! the same bits.
#![expect(clippy::unwrap_used, reason = "helpers of tests may unwrap")]

mod c;
mod cortex_m4;
mod plcopen;
mod rust;
mod sources;
mod st;
mod text;
mod trace;
