//! The response of a loop to setpoint and load, exactly: no Padé approximation, no time step, no sampling.
//!
//! The dead time is handled by the method of steps. Time is cut into cells at every event and all its delayed
//! images; in a cell every signal is a polynomial, accepted by its last coefficients or cut in half. Metrics are
//! integrals, extrema and roots of those polynomials.

use crate::analysis::metrics::Metrics;
use crate::model::{ClosedLoop, Seconds};

mod cell;
mod delay_line;
mod error;
mod extent;
mod instant;
mod integrals;
mod lag;
mod layered;
mod legendre;
mod measure;
mod number;
mod roots;
pub mod sampled;
mod sampler;
mod scenario;
mod solver;
mod system;
mod trajectory;
mod values;

pub use error::ResponseError;
pub use extent::{Extreme, OutputExtent, output_extent};
pub(in crate::analysis) use integrals::integrals_of_many;
pub use integrals::{Integrals, integrals};
pub use scenario::{Scenario, ScenarioError};
pub use trajectory::{Trajectory, plot_times, refill_trajectory, simulate_with_trajectory, trajectory};

use cell::{Outcome, Watch};
use measure::{BANDS, Measure, Move};
use solver::Solver;
use system::System;

/// Dead times up to which loops with two different ones are held to 1e-9.
const PROVEN: f64 = 200.0;

/// The numbers of one simulated response.
#[derive(Debug, Clone, PartialEq)]
pub struct Response {
    /// The metrics over the horizon.
    pub metrics: Metrics,
    /// Controlled variable at the horizon [output unit], or where the response overflowed.
    pub final_controlled_variable: f64,
    /// Controller output at the horizon [input unit], or where the response overflowed.
    pub final_manipulated_variable: f64,
    /// Time at which the signals of an unstable loop left the range of numbers [s].
    pub overflow_at: Option<Seconds>,
    /// Why a metric is absent, and what else a reader must know.
    pub warnings: Vec<String>,
}

/// Simulates a loop over a scenario and returns its metrics; relative error of the integrals below 1e-9.
///
/// ```
/// use holdup::analysis::response::{Scenario, simulate};
/// use holdup::model::{ClosedLoop, Controller, Process, Seconds};
/// let process = Process::integrating(0.0506, Seconds(6.0))?;
/// let pid = Controller::proportional(2.95)?
///     .with_integral_time(Seconds(15.0))?
///     .with_derivative_time(Seconds(3.0))?
///     .with_filter_bandwidth(100.0)?;
/// let step = Scenario::unit_setpoint_step(Seconds(200.0))?;
/// let response = simulate(&ClosedLoop::new(&process, &pid), &step)?;
/// assert_eq!(format!("{:.3}", response.metrics.ise.unwrap()), "8.772");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ResponseError::HorizonTooLong`] if the loop neither settles nor reaches the horizon within the budget of cells.
pub fn simulate(closed_loop: &ClosedLoop, scenario: &Scenario) -> Result<Response, ResponseError> {
    let mut measure = measure_of(scenario);
    let outcome = run(closed_loop, scenario, &mut measure)?;
    let mut response = response(scenario, measure, outcome);
    response.warnings.extend(beyond_proof(closed_loop, scenario));
    Ok(response)
}

/// What to say where the error of 1e-9 is not established: with two different dead times its breakpoints are all sums of
/// them, and accuracy was held against independent integration up to [`PROVEN`] of them.
fn beyond_proof(closed_loop: &ClosedLoop, scenario: &Scenario) -> Option<String> {
    let mut delays = closed_loop.channels().iter().map(|channel| channel.delay);
    let longest = delays.clone().fold(0.0, f64::max);
    let other = delays.find(|delay| *delay != longest)?;
    (scenario.horizon() > PROVEN * longest).then(|| {
        format!(
            "two dead times, {longest} s and {other} s, over more than {PROVEN} of the longer one: the integrals are held to a \
             relative error of 1e-9 up to {} s only; a shorter horizon is certain",
            PROVEN * longest
        )
    })
}

/// Shows the response to `watch`: the fast way where the loop allows it, otherwise cell by cell.
fn run(
    closed_loop: &ClosedLoop,
    scenario: &Scenario,
    watch: &mut dyn Watch,
) -> Result<Outcome, ResponseError> {
    if let Some(outcome) = layered::run(closed_loop, scenario, watch) {
        return outcome;
    }
    watch.restart();
    Solver::new(&System::new(closed_loop)).run(scenario, watch)
}

fn measure_of(scenario: &Scenario) -> Measure {
    Measure::new(scenario.single_setpoint_move().map(|(time, size)| Move { time, size }))
}

fn response(scenario: &Scenario, mut measure: Measure, outcome: Outcome) -> Response {
    measure.settle();
    let mut warnings = Vec::new();
    let mut metrics = Metrics::default();
    if let Some(time) = outcome.overflow_at {
        warnings.push(format!(
            "the loop is unstable: its signals exceed the range of numbers at {time:.6} s, so there are no metrics \
             and the final values are the last ones before that"
        ));
    } else {
        let mut finite = |name: &str, value: f64| {
            if value.is_finite() {
                return Some(value);
            }
            warnings.push(format!("{name} exceeds the range of numbers: the loop is unstable"));
            None
        };
        metrics.iae = finite("iae", measure.iae);
        metrics.ise = finite("ise", measure.ise);
        metrics.itae = finite("itae", measure.itae);
        metrics.peak = finite("peak", measure.peak);
        if outcome.impulsive {
            warnings.push(
                "control_energy and total_variation are infinite: the setpoint step goes through an unfiltered \
                 derivative, so the controller output has impulses (filter the derivative, or set c = 0)"
                    .to_owned(),
            );
        } else {
            metrics.control_energy = finite("control_energy", measure.energy);
            metrics.total_variation = finite("total_variation", measure.variation);
        }
        tracking_metrics(&mut metrics, &measure, &mut warnings);
    }
    Response {
        metrics,
        final_controlled_variable: scenario.initial() + measure.last.0,
        final_manipulated_variable: measure.last.1,
        overflow_at: outcome.overflow_at.map(Seconds),
        warnings,
    }
}

fn tracking_metrics(metrics: &mut Metrics, measure: &Measure, warnings: &mut Vec<String>) {
    let Some(tracking) = &measure.tracking else { return };
    metrics.overshoot = Some(tracking.overshoot).filter(|o| o.is_finite());
    if let [Some(first), Some(last)] = tracking.first_at {
        metrics.rise_time = Some(Seconds(last - first));
    } else {
        warnings.push(
            "rise_time is absent: 90 % of the setpoint move is not reached within the horizon".to_owned(),
        );
    }
    let start = tracking.start();
    let mut settled = |index: usize| {
        if tracking.inside[index] {
            return Some(Seconds(tracking.last_outside[index] - start));
        }
        let band = 100.0 * BANDS[index];
        let name = if index == 0 { "settling_time" } else { "settling_time_5" };
        warnings.push(format!("{name} is absent: the error is outside ±{band:.0} % at the horizon"));
        None
    };
    metrics.settling_time = settled(0);
    metrics.settling_time_5 = settled(1);
}
