//! What is controlled, and by what: process, controller with its observer, and the closed loop they make.

pub mod closed_loop;
mod compensated_loop;
pub mod compensator;
mod compensator_settings;
pub mod controller;
pub mod description;
pub(crate) mod error;
pub mod events;
pub mod forms;
pub mod loop_file;
pub mod notation;
pub mod process;
pub mod quantity;
mod sampled_law;
pub mod settings;
pub mod text;
pub(crate) mod toml_section;

pub use closed_loop::ClosedLoop;
pub use compensator::{Compensator, CompensatorLaw, Lead};
pub use controller::{Controller, DerivativeFilter, Observer, OutputFilter};
pub use error::ModelError;
pub use process::Process;
pub use quantity::{Radians, Seconds};
pub use sampled_law::{NoSampledLaw, sampled_law};
pub use text::TextError;
