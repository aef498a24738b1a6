//! What the loop does, exactly.

pub mod bounds;
pub mod metrics;
pub mod response;
