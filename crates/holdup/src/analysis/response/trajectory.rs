//! The response at requested times.

use crate::model::ClosedLoop;

use super::cell::{Cell, Outcome, Watch};
use super::error::ResponseError;
use super::legendre::{Poly, ends, evaluate, powers};
use super::measure::Measure;
use super::scenario::Scenario;
use super::solver::Solver;
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

/// Value at each time of what starts at `rest` and is held from event to event.
fn held(times: &[f64], sorted: bool, rest: f64, events: &[(f64, f64)]) -> Vec<f64> {
    let mut values = vec![rest; times.len()];
    for &(at, value) in events {
        if sorted {
            let from = times.partition_point(|&t| t < at);
            values[from..].fill(value);
        } else {
            for (held, _) in values.iter_mut().zip(times).filter(|(_, t)| **t >= at) {
                *held = value;
            }
        }
    }
    values
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
            setpoint: held(times, order.is_none(), scenario.initial(), scenario.setpoint()),
            controlled_variable: empty(),
            manipulated_variable: empty(),
            load: held(times, order.is_none(), 0.0, scenario.load()),
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
        let end = cell.start + cell.length;
        let level = self.scenario.initial() + cell.setpoint;
        let at_end = |p: &Poly| ends(p).1;
        self.last = Some([
            level - at_end(cell.error),
            at_end(cell.manipulated),
            cell.load_estimate.map_or(0.0, at_end),
        ]);
        let from = self.next;
        let to = match &self.order {
            None => from + self.result.time[from..].partition_point(|&t| t < end),
            Some(order) => from + order[from..].partition_point(|&i| self.result.time[i] < end),
        };
        self.next = to;
        if from == to {
            return;
        }
        let place = (cell.start, 2.0 / cell.length);
        let mut error = powers(cell.error);
        for c in &mut error.0 {
            *c = -*c;
        }
        error.0[0] += level;
        error.1 = error.1.max(1);
        let manipulated = powers(cell.manipulated);
        let Trajectory { time, controlled_variable, manipulated_variable, load_estimate, .. } =
            &mut self.result;
        let order = self.order.as_deref().map(|order| &order[from..to]);
        let fill = |powers: &(Poly, usize), values: &mut [f64]| {
            let powers = &powers.0[..powers.1];
            match order {
                None => evaluate(powers, place, &time[from..to], &mut values[from..to]),
                Some(order) => {
                    for &i in order {
                        evaluate(powers, place, &time[i..=i], &mut values[i..=i]);
                    }
                }
            }
        };
        fill(&error, controlled_variable);
        fill(&manipulated, manipulated_variable);
        if let Some((polynomial, values)) = cell.load_estimate.zip(load_estimate.as_mut()) {
            fill(&powers(polynomial), values);
        }
    }
}
