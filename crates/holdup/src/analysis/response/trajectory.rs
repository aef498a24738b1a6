//! The response at requested times.

use crate::model::ClosedLoop;

use super::legendre::value;
use super::measure::Measure;
use super::scenario::Scenario;
use super::solver::{Cell, Outcome, ResponseError, Solver, Watch};
use super::system::System;
use super::{Response, measure_of, response};

/// Signals at requested times; at an event the value from the right.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Trajectory {
    /// Times [s], as requested.
    pub time: Vec<f64>,
    /// Setpoint r [output unit].
    pub setpoint: Vec<f64>,
    /// Controlled variable y [output unit].
    pub controlled_variable: Vec<f64>,
    /// Controller output u [input unit], without the load and without impulses.
    pub manipulated_variable: Vec<f64>,
    /// Load disturbance D at the process input [input unit].
    pub load: Vec<f64>,
    /// Load estimate D̂ of the observer [input unit], where there is one.
    pub load_estimate: Option<Vec<f64>>,
}

/// The response of a loop at these times [s] (in any order, within 0 … horizon), to 1e-9.
///
/// Where an unstable loop overflows before the horizon, the trajectory ends there.
///
/// ```
/// use holdup::analysis::response::{Scenario, trajectory};
/// use holdup::model::{ClosedLoop, Controller, Process, Seconds};
/// let closed = ClosedLoop::new(&Process::integrating(1.0, Seconds(1.0))?, &Controller::proportional(0.5)?);
/// let step = Scenario::unit_setpoint_step(Seconds(10.0))?;
/// let response = trajectory(&closed, &step, &[0.0, 1.0, 1.5])?;
/// assert_eq!(response.controlled_variable, [0.0, 0.0, 0.25]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ResponseError`] if a time is outside 0 … horizon, or the horizon is too long for a loop that does not settle.
pub fn trajectory(
    closed_loop: &ClosedLoop,
    scenario: &Scenario,
    times: &[f64],
) -> Result<Trajectory, ResponseError> {
    let system = System::new(closed_loop);
    let mut sampler = Sampler::new(&system, scenario, times)?;
    let outcome = Solver::new(&system).run(scenario, &mut sampler)?;
    Ok(sampler.finish(outcome))
}

/// Metrics and the response at these times, in one run; see [`simulate`](super::simulate) and [`trajectory`].
///
/// # Errors
/// As [`trajectory`].
pub fn simulate_with_trajectory(
    closed_loop: &ClosedLoop,
    scenario: &Scenario,
    times: &[f64],
) -> Result<(Response, Trajectory), ResponseError> {
    let system = System::new(closed_loop);
    let mut both = Both(measure_of(scenario), Sampler::new(&system, scenario, times)?);
    let outcome = Solver::new(&system).run(scenario, &mut both)?;
    Ok((response(scenario, &both.0, outcome), both.1.finish(outcome)))
}

/// Times for drawing [s]: `points` uniform ones, and every event and delayed image of it (of the first 200) twice, just
/// before and at it, so that a jump is drawn as a vertical line.
#[must_use]
pub fn plot_times(closed_loop: &ClosedLoop, scenario: &Scenario, points: usize) -> Vec<f64> {
    let horizon = scenario.horizon();
    let last = points.max(2) - 1;
    #[expect(clippy::cast_precision_loss, reason = "numbers of points are far below 2^52")]
    let mut times: Vec<f64> = (0..=last).map(|i| horizon * (i as f64 / last as f64)).collect();
    let events = scenario.setpoint().iter().chain(scenario.load()).map(|e| e.0);
    for event in events {
        for channel in closed_loop.channels() {
            for echo in 0..200 {
                let time = event + f64::from(echo) * channel.delay;
                if time > horizon {
                    break;
                }
                // One part in 1e12: far below what a pixel shows, far above rounding.
                times.push((time - 1e-12 * horizon).max(0.0));
                times.push(time);
            }
        }
    }
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

struct Both<'a>(Measure, Sampler<'a>);

impl Watch for Both<'_> {
    fn cell(&mut self, cell: &Cell<'_>) {
        self.0.cell(cell);
        self.1.cell(cell);
    }
}

/// Fills in the requested times, which it walks through in increasing order.
struct Sampler<'a> {
    scenario: &'a Scenario,
    /// Indices of the times in increasing order; `None` if they are in order already.
    order: Option<Vec<usize>>,
    next: usize,
    result: Trajectory,
    last: Option<[f64; 3]>,
}

impl<'a> Sampler<'a> {
    fn new(system: &System, scenario: &'a Scenario, times: &[f64]) -> Result<Self, ResponseError> {
        let horizon = scenario.horizon();
        if let Some(&value) = times.iter().find(|t| !(**t >= 0.0 && **t <= horizon)) {
            return Err(ResponseError::TimeOutside { value, horizon });
        }
        let order = (!times.is_sorted()).then(|| {
            let mut order: Vec<usize> = (0..times.len()).collect();
            order.sort_by(|&a, &b| times[a].total_cmp(&times[b]));
            order
        });
        let empty = || vec![0.0; times.len()];
        let result = Trajectory {
            time: times.to_vec(),
            setpoint: times.iter().map(|&t| scenario.setpoint_at(t)).collect(),
            controlled_variable: empty(),
            manipulated_variable: empty(),
            load: times.iter().map(|&t| scenario.load_at(t)).collect(),
            load_estimate: system.load_estimate.as_ref().map(|_| empty()),
        };
        Ok(Self { scenario, order, next: 0, result, last: None })
    }

    fn index(&self, position: usize) -> usize {
        self.order.as_ref().map_or(position, |order| order[position])
    }

    fn set(&mut self, index: usize, [y, u, estimate]: [f64; 3]) {
        self.result.controlled_variable[index] = y;
        self.result.manipulated_variable[index] = u;
        if let Some(estimates) = &mut self.result.load_estimate {
            estimates[index] = estimate;
        }
    }

    /// The times that no cell contains: the horizon itself, or everything after an overflow.
    fn finish(mut self, outcome: Outcome) -> Trajectory {
        if outcome.overflow_at.is_none() {
            for position in self.next..self.result.time.len() {
                let index = self.index(position);
                self.set(index, self.last.unwrap_or_default());
            }
            return self.result;
        }
        let mut kept: Vec<usize> = (0..self.next).map(|position| self.index(position)).collect();
        kept.sort_unstable();
        let pick = |values: &[f64]| kept.iter().map(|&i| values[i]).collect::<Vec<f64>>();
        Trajectory {
            time: pick(&self.result.time),
            setpoint: pick(&self.result.setpoint),
            controlled_variable: pick(&self.result.controlled_variable),
            manipulated_variable: pick(&self.result.manipulated_variable),
            load: pick(&self.result.load),
            load_estimate: self.result.load_estimate.as_deref().map(pick),
        }
    }
}

impl Watch for Sampler<'_> {
    fn cell(&mut self, cell: &Cell<'_>) {
        let level = self.scenario.initial() + cell.setpoint;
        let at = |s: f64| {
            [
                level - value(cell.error, s),
                value(cell.manipulated, s),
                cell.load_estimate.map_or(0.0, |p| value(p, s)),
            ]
        };
        let end = cell.start + cell.length;
        while self.next < self.result.time.len() {
            let index = self.index(self.next);
            let time = self.result.time[index];
            if time >= end {
                break;
            }
            let s = (2.0 * (time - cell.start) / cell.length - 1.0).clamp(-1.0, 1.0);
            self.set(index, at(s));
            self.next += 1;
        }
        self.last = Some(at(1.0));
    }
}
