//! What is controlled, and by what: process, controller with its observer, and the closed loop they make.

pub mod closed_loop;
pub mod controller;
mod error;
pub mod process;
pub mod quantity;

pub use closed_loop::ClosedLoop;
pub use controller::{Controller, DerivativeFilter, Observer, OutputFilter};
pub use error::ModelError;
pub use process::Process;
pub use quantity::{Radians, Seconds};
