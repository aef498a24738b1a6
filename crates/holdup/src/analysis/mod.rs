//! What the loop does, exactly.

pub mod frequency;
