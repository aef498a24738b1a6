//! P, PI, PD and PID action.

mod settings;
mod state;

pub use settings::{Action, Pid};
pub use state::{PidState, Sample};
