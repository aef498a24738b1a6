//! What the loop does, exactly.

pub mod batch;
pub mod bounds;
pub mod frequency;
pub mod infinite_horizon;
pub mod metrics;
pub mod response;
