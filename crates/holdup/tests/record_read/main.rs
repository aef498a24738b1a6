//! Files as plants have them, and the records in them.

#![expect(clippy::unwrap_used, reason = "helpers of tests")]

mod adversarial;
mod dialects;
mod faults;
mod parquet;
mod plant_records;
mod readings;
mod repairs;
mod sample;
