//! What the loop does, exactly.

pub mod actuator;
pub mod batch;
pub mod bounds;
mod exponential;
pub mod frequency;
pub mod infinite_horizon;
pub mod metrics;
pub mod noise;
pub mod response;
mod wide;

pub(crate) use wide::widest;
