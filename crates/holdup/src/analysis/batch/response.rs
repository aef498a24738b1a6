//! Metrics of many loops: each is simulated as [`simulate`] does it.

use rayon::prelude::*;

use super::super::metrics::Metrics;
use super::super::response::{ResponseError, Scenario, simulate};
use crate::model::{ClosedLoop, Controller, Process};

/// Loops that one thread takes at a time: a few milliseconds of work.
const SHARE: usize = 32;

/// The metrics of one controller on each of these processes, in their order.
///
/// Each result is what [`simulate`] gives, absent metrics included.
///
/// ```
/// use holdup::analysis::batch::over_processes;
/// use holdup::analysis::response::Scenario;
/// use holdup::model::{Controller, Process, Seconds};
/// let pi = Controller::proportional(1.6)?.with_integral_time(Seconds(48.0))?;
/// let nominal = Process::integrating(0.0506, Seconds(6.0))?;
/// let slower = Process::integrating(0.0506, Seconds(7.0))?;
/// let load = Scenario::unit_load_step(Seconds(600.0))?;
/// let results = over_processes(&[nominal, slower], &pi, &load);
/// let peak: Vec<f64> = results.iter().map(|r| r.as_ref().unwrap().peak.unwrap()).collect();
/// assert!(peak[0] < peak[1]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// In each place [`ResponseError`], as [`simulate`] gives it for that loop.
#[must_use]
pub fn over_processes(
    processes: &[Process],
    controller: &Controller,
    scenario: &Scenario,
) -> Vec<Result<Metrics, ResponseError>> {
    let one = |process: &Process| metrics(process, controller, scenario);
    processes.par_iter().with_min_len(SHARE).map(one).collect()
}

/// The metrics of each of these controllers on one process, in their order; see [`over_processes`].
///
/// # Errors
/// In each place [`ResponseError`], as [`simulate`] gives it for that loop.
#[must_use]
pub fn over_controllers(
    process: &Process,
    controllers: &[Controller],
    scenario: &Scenario,
) -> Vec<Result<Metrics, ResponseError>> {
    let one = |controller: &Controller| metrics(process, controller, scenario);
    controllers.par_iter().with_min_len(SHARE).map(one).collect()
}

fn metrics(
    process: &Process,
    controller: &Controller,
    scenario: &Scenario,
) -> Result<Metrics, ResponseError> {
    simulate(&ClosedLoop::new(process, controller), scenario).map(|response| response.metrics)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Seconds;

    #[test]
    fn results_are_those_of_single_loops_whatever_the_number_of_threads() {
        let controller = Controller::proportional(1.6).unwrap().with_integral_time(Seconds(48.0)).unwrap();
        let process = |i: i32| Process::integrating(0.04 + 2e-4 * f64::from(i), Seconds(6.0)).unwrap();
        let processes: Vec<Process> = (0..100).map(process).collect();
        let scenario = Scenario::unit_load_step(Seconds(200.0)).unwrap();
        let single: Vec<_> = processes.iter().map(|p| metrics(p, &controller, &scenario)).collect();
        for threads in [1, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            assert_eq!(pool.install(|| over_processes(&processes, &controller, &scenario)), single);
        }
        let controllers = [controller, Controller::proportional(1.0).unwrap()];
        let both = over_controllers(&processes[0], &controllers, &scenario);
        assert_eq!(both[0], single[0]);
        assert_ne!(both[1], single[0]);
    }
}
