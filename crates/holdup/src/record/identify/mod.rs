//! Gain, dead time and lag of the process from a record.

mod even;
mod input;
mod joint;
mod kind;
mod load_steps;
mod noise;
mod point;
mod problem;
mod search;
mod squares;
mod strength;
#[cfg(test)]
mod tests;

pub use kind::{Hold, Kind, Load};
pub use noise::Noise;
pub use point::{PointError, PointFit, greatest_dead_time, point_fit};

pub(crate) use input::Shape;
pub(crate) use joint::{Joint, exact, joint, starting_noises, with_noise};
pub(crate) use load_steps::{MOST as MOST_LOAD_STEPS, Stepped, with_load_steps};
pub(crate) use noise::Whitener;
pub(crate) use problem::{Fit, Problem, Whitened};
pub(crate) use search::polish;
pub(crate) use squares::{Basis, dot, generalised, solve};
