#![doc = include_str!("../README.md")]
#![no_std]

mod delay_line;
mod limits;
mod observer;
mod pid;
mod scalar;
mod setting_error;
mod settings;
mod signals;
mod state;
mod sum;
mod update;
mod watch;

pub use delay_line::{DelayLine, Segment, segments_needed};
pub use limits::{Limited, Limits};
pub use observer::{Observer, ObserverState};
pub use pid::{Action, Pid, PidState, Sample};
pub use scalar::Scalar;
pub use setting_error::SettingError;
pub use settings::{Law, Settings};
pub use signals::{Input, Mode, Output, Status};
pub use state::State;
pub use sum::Sum;
pub use watch::Watch;
