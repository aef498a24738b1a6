//! Tuning that meets its specification exactly, or says that it cannot be met.
//!
//! Everything is solved in units of the dead time for |K| = 1, so that the answer scales with the process exactly.

mod curve;
mod dob;
mod goal;
mod margins;
mod observer;
mod pd;
mod pi;
mod root;
mod settling;

pub(super) use dob::tune as dob;
pub(super) use pd::tune as pd;
pub(super) use pi::tune as pi;

use super::RuleError;
use crate::analysis::frequency::{self, Margins};
use crate::model::{ClosedLoop, Controller, ModelError, Observer, Process, Seconds};

/// A loop in units of the dead time, |K| = 1.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Normal {
    /// |K·Kc|·d.
    gain: f64,
    /// Td/d.
    derivative: f64,
    /// Filter time over dead time, 0 without a filter.
    filter: f64,
    /// |K·Ko|·d, 0 without an observer.
    observer: f64,
}

impl Normal {
    fn closed(&self) -> Result<ClosedLoop, ModelError> {
        let process = Process::integrating(1.0, Seconds(1.0))?;
        let mut controller =
            Controller::proportional(self.gain)?.with_derivative_time(Seconds(self.derivative))?;
        if self.filter > 0.0 {
            controller = controller.with_filter_time(Seconds(self.filter))?;
        }
        if self.observer > 0.0 {
            controller = controller.with_observer(Observer::new(self.observer)?);
        }
        Ok(ClosedLoop::new(&process, &controller))
    }

    /// What the loop achieves; times in dead times.
    fn margins(&self, rule: &'static str) -> Result<Margins, RuleError> {
        let closed = self.closed().map_err(|error| RuleError::Setting { rule, error })?;
        frequency::margins(&closed).map_err(|error| RuleError::Analysis { rule, reason: error.to_string() })
    }
}
