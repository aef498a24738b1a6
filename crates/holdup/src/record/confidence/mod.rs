//! What the record does not exclude, and what follows for trust in it.

mod inflation;
mod profile;
mod quantile;

pub use profile::{Confidence, Slice};

pub(crate) use inflation::{Inflation, Inflations, inflations};
pub(crate) use profile::{Profile, open_ended};
pub(crate) use quantile::one;
