//! P, PI, PD and PID action.

mod settings;
mod state;

pub use settings::Pid;
pub use state::{PidState, Sample};
