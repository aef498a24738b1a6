//! What is to be optimised, of what, and within which limits.

use super::design::{Design, Structure};
use super::filter::Filter;
use super::infeasible::conflict;
use super::limits::Limits;
use super::objective::Objective;
use super::progress::Progress;
use super::search::{OptimiseError, Optimum, find};
use crate::analysis::frequency::margins;
use crate::analysis::infinite_horizon::{Input, to_infinity};
use crate::model::{ClosedLoop, Process};

/// A search for the best controller: what [`optimise`](super::optimise) takes, and how the derivative is filtered.
///
/// ```
/// use holdup::model::{Process, Seconds};
/// use holdup::tuning::optimise::{Filter, Limits, Objective, Quantity, Structure, Task};
/// let process = Process::integrating(1.0, Seconds(1.0))?;
/// let limits = Limits::default().with(Quantity::SensitivityPeak, 1.6);
/// let task = Task::new(&process, Structure::Pd, Objective::SetpointIae, &limits).with_filter(Filter::Held(0.1));
/// let best = task.optimise(&|_| {})?;
/// let filter = best.controller.derivative_filter().unwrap().time();
/// assert!((filter / best.controller.derivative_time().unwrap() - 0.1).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Task {
    pub(super) process: Process,
    pub(super) structure: Structure,
    pub(super) filter: Filter,
    pub(super) objective: Objective,
    pub(super) limits: Limits,
}

impl Task {
    /// The search; the derivative is filtered where a limit needs it ([`Filter::for_limits`]).
    #[must_use]
    pub fn new(process: &Process, structure: Structure, objective: Objective, limits: &Limits) -> Self {
        let filter = Filter::for_limits(limits);
        Self { process: *process, structure, filter, objective, limits: limits.clone() }
    }

    /// The same with this filter of the derivative, where there is one.
    #[must_use]
    pub fn with_filter(mut self, filter: Filter) -> Self {
        self.filter = filter;
        self
    }

    /// The filter of the derivative.
    #[must_use]
    pub fn filter(&self) -> Filter {
        self.filter
    }

    /// The search space, or why the objective has no optimum in it.
    pub(super) fn design(&self) -> Result<Design, OptimiseError> {
        let of_setpoint = self.objective.is_of_setpoint()
            || self.limits.list().iter().any(|limit| limit.quantity.is_of_setpoint());
        let design = Design::new(&self.process, self.structure, self.filter, of_setpoint);
        match self.objective.degenerate(&design, &self.limits) {
            Some(reason) => Err(OptimiseError::Degenerate(reason)),
            None => Ok(design),
        }
    }

    /// The best controller. `tell` is called with thousandths of the work as they are done, a thousand in all
    /// ([`WHOLE`](super::WHOLE)), from any thread.
    ///
    /// # Errors
    /// As [`optimise`](super::optimise).
    pub fn optimise(&self, tell: &(dyn Fn(u64) + Sync)) -> Result<Optimum, OptimiseError> {
        let (design, process) = (self.design()?, &self.process);
        let progress = Progress::new(tell);
        let Some(found) = find(&design, self.objective, &self.limits, &progress) else {
            return Err(OptimiseError::Infeasible(conflict(&design, &self.limits)));
        };
        let controller = found.best.controller;
        let integrals = |input| to_infinity(process, &controller, input).ok();
        let mut warnings = design.at_ends(&found.parts);
        if self.structure.weights_setpoint() && !design.weights_setpoint() {
            warnings.push(
                "No setpoint step is looked at, so the setpoint weight has no part in this optimum: it stays at 1."
                    .to_owned(),
            );
        }
        let optimum = Optimum {
            controller,
            value: found.best.value,
            achieved: margins(&ClosedLoop::new(process, &controller))?,
            load: integrals(Input::Load).filter(|_| self.structure.rejects_load()),
            setpoint: integrals(Input::Setpoint),
            starts: found.starts,
            agreeing: found.agreeing,
            swept: found.swept,
            least_swept: found.least_swept,
            warnings,
        };
        progress.finish();
        Ok(optimum)
    }
}
