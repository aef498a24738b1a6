//! What is to be optimised, of what, and within which limits.

use super::design::{Design, Structure};
use super::filter::Filter;
use super::gain::Candidate;
use super::infeasible::conflict;
use super::limits::{Limits, Quantity};
use super::objective::Objective;
use super::progress::Progress;
use super::search::{OptimiseError, Optimum, find};
use crate::analysis::frequency::margins;
use crate::analysis::infinite_horizon::{Input, to_infinity};
use crate::model::{ClosedLoop, Process};

/// By how much the proven value may differ from that of the search, relative.
const PROVEN: f64 = 2e-6;

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

    /// The limits, and what the objective asks of the nominal process beside them.
    fn limits_in_all(&self) -> Limits {
        let Objective::RobustBox { sensitivity_peak, .. } = self.objective else {
            return self.limits.clone();
        };
        let known = self.limits.of(Quantity::SensitivityPeak).unwrap_or(f64::INFINITY);
        self.limits.clone().with(Quantity::SensitivityPeak, sensitivity_peak.min(known))
    }

    /// The value of what was found, with the proof that the search does without.
    pub(super) fn proven(&self, found: &Candidate) -> f64 {
        match self.objective {
            Objective::RobustBox { .. } => {
                self.objective.of(&self.process, &found.controller).unwrap_or(f64::INFINITY)
            }
            _ => found.value,
        }
    }

    /// The best controller. `tell` is called with thousandths of the work as they are done, a thousand in all
    /// ([`WHOLE`](super::WHOLE)), from any thread.
    ///
    /// # Errors
    /// As [`optimise`](super::optimise).
    pub fn optimise(&self, tell: &(dyn Fn(u64) + Sync)) -> Result<Optimum, OptimiseError> {
        let (mut design, process) = (self.design()?, &self.process);
        let progress = Progress::new(tell);
        let search = |design: &Design| {
            let found = find(design, self.objective, &self.limits, &progress);
            found.map_err(|nothing| {
                OptimiseError::Infeasible(conflict(design, &self.limits_in_all(), nothing))
            })
        };
        let mut found = search(&design)?;
        let mut value = self.proven(&found.best);
        if (value / found.best.value - 1.0).abs() > PROVEN {
            // What the search took for the size of a box was not: once more, with every one proven.
            design.proving = true;
            found = search(&design)?;
            value = self.proven(&found.best);
        }
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
            value,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::frequency::family::Family;
    use crate::model::Seconds;

    #[test]
    fn a_limit_that_leaves_no_box_is_told_with_the_peak_of_the_box() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let family = Family::ranges([0.8, 1.2], [0.8, 1.2]).unwrap();
        let objective = Objective::RobustBox { family, sensitivity_peak: 1.2 };
        let limits = Limits::default().with(Quantity::LoadIae, 10.0);
        let Err(refused) = Task::new(&process, Structure::Pi, objective, &limits).optimise(&|_| {}) else {
            panic!("feasible");
        };
        let message = refused.to_string();
        // Load IAE 10 takes a peak above 1.2, and the peak 1.2 a load IAE above 10.
        let OptimiseError::Infeasible(conflict) = refused else { panic!("{message}") };
        for (limit, nearest) in conflict.limits {
            assert!(nearest.unwrap() > limit.value, "{message}");
        }
        assert!(message.contains("sensitivity_peak <= 1.2"), "{message}");
    }

    #[test]
    fn a_search_with_every_box_proven_finds_the_same() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let family = Family::ranges([0.8, 1.2], [0.9, 1.1]).unwrap();
        let objective = Objective::RobustBox { family, sensitivity_peak: 1.7 };
        let limits = Limits::default().with(Quantity::SetpointIae, 4.0);
        let task = Task::new(&process, Structure::P, objective, &limits);
        let quick = task.optimise(&|_| {}).unwrap();
        let design = Design { proving: true, ..task.design().unwrap() };
        let Ok(proven) = find(&design, objective, &limits, &Progress::silent()) else { panic!("infeasible") };
        // The proof lies 1e-7 inside of what touches.
        assert!(
            (proven.best.value / quick.value - 1.0).abs() < 3e-7,
            "{} {}",
            proven.best.value,
            quick.value
        );
    }
}
