//! The response at requested times.

use crate::model::ClosedLoop;

use super::cell::{Cell, Watch};
use super::error::ResponseError;
use super::integrals::Integrals;
use super::layered::Segment;
use super::measure::Measure;
use super::sampler::Sampler;
use super::scenario::Scenario;
use super::{Response, beyond_proof, measure_of, response, run};

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
    let mut sampler = Sampler::new(closed_loop, scenario, times)?;
    let outcome = run(closed_loop, scenario, &mut sampler)?;
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
    let mut both = Both(measure_of(scenario), Sampler::new(closed_loop, scenario, times)?);
    let outcome = run(closed_loop, scenario, &mut both)?;
    let mut response = response(scenario, both.0, outcome);
    response.warnings.extend(beyond_proof(closed_loop, scenario));
    Ok((response, both.1.finish(outcome)))
}

/// The integrals, and the response at the times of `trajectory`, whose other values are overwritten in their memory: for
/// many runs at the same times, a fraction of the time of [`simulate_with_trajectory`].
///
/// Where an unstable loop overflows before the horizon, the trajectory ends there, its times too.
///
/// ```
/// use holdup::analysis::response::{Scenario, Trajectory, refill_trajectory};
/// use holdup::model::{ClosedLoop, Controller, Process, Seconds};
/// let process = Process::integrating(1.0, Seconds(1.0))?;
/// let step = Scenario::unit_setpoint_step(Seconds(20.0))?;
/// let mut trajectory = Trajectory { time: vec![0.0, 1.0, 1.5], ..Trajectory::default() };
/// for gain in [0.3, 0.5] {
///     let closed = ClosedLoop::new(&process, &Controller::proportional(gain)?);
///     let integrals = refill_trajectory(&closed, &step, &mut trajectory)?;
///     assert!((trajectory.controlled_variable[2] - 0.5 * gain).abs() < 1e-15);
///     assert!(integrals.iae.unwrap() > 1.0);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`trajectory`]; the trajectory is then empty.
pub fn refill_trajectory(
    closed_loop: &ClosedLoop,
    scenario: &Scenario,
    trajectory: &mut Trajectory,
) -> Result<Integrals, ResponseError> {
    let sampler = Sampler::reusing(closed_loop, scenario, std::mem::take(trajectory))?;
    let mut both = Both(Measure::integrals_only(), sampler);
    let outcome = run(closed_loop, scenario, &mut both)?;
    *trajectory = both.1.finish(outcome);
    Ok(Integrals::from(&response(scenario, both.0, outcome).metrics))
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

    fn segment(&mut self, segment: &Segment<'_>) {
        self.0.segment(segment);
        self.1.segment(segment);
    }

    fn restart(&mut self) {
        self.0.restart();
        self.1.restart();
    }
}
