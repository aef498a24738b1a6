//! Comparing loops and telling what was found.
pub mod figures;
pub mod output;
