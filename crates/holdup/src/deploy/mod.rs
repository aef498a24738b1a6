//! What to run, or to type, in the plant.

pub mod export;
