#![doc = include_str!("../../../README.md")]

pub mod analysis;
pub mod deploy;
pub mod model;
pub mod record;
pub mod study;
pub mod tuning;
