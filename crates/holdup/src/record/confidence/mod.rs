//! What the record does not exclude, and what follows for trust in it.

mod inflation;
mod profile;
mod quantile;

pub use profile::{Confidence, Slice};

pub(crate) use inflation::{Inflations, inflations};
pub(crate) use profile::{Profile, open_ended};
