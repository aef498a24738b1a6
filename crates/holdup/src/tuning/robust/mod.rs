//! What a tuning is worth where gain and dead time of the process are not known exactly: a guarantee over a family of
//! processes ([`crate::analysis::frequency::family`]), the largest family that a limit allows, and Monte Carlo beside it.

mod draws;
mod largest;
mod monte_carlo;
mod quantiles;
mod touching;

pub use draws::{Distribution, DrawError, Draws};
pub use largest::{Largest, largest_family};
pub(crate) use largest::{most, proven_size};
pub use monte_carlo::{COLUMNS, Column, MonteCarlo, MonteCarloError, Percentiles, Run, Summary};
pub use quantiles::Quantiles;
pub(crate) use touching::{Boxes, Touching};
