//! The integrals of many loops.

use super::super::response::{Integrals, ResponseError, Scenario, integrals_of_many};
use crate::model::{ClosedLoop, Controller, Process};

/// The integrals of one controller on each of these processes, in their order, on all cores.
///
/// Relative error below 1e-9, as [`integrals`](super::super::response::integrals) gives them, in a fraction of its time: up to eight
/// loops are computed together where the same happens to them in the same order. Results do not depend on the number of
/// threads; which loops go together, and with that the last digits, does depend on the slice.
///
/// ```
/// use holdup::analysis::batch::integrals_over_processes;
/// use holdup::analysis::response::Scenario;
/// use holdup::model::{Controller, Process, Seconds};
/// let pi = Controller::proportional(1.6)?.with_integral_time(Seconds(48.0))?;
/// let nominal = Process::integrating(0.0506, Seconds(6.0))?;
/// let slower = Process::integrating(0.0506, Seconds(7.0))?;
/// let load = Scenario::unit_load_step(Seconds(600.0))?;
/// let results = integrals_over_processes(&[nominal, slower], &pi, &load);
/// let ise: Vec<f64> = results.iter().map(|r| r.as_ref().unwrap().ise.unwrap()).collect();
/// assert!(ise[0] < ise[1]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// In each place [`ResponseError`], as [`simulate`](super::super::response::simulate) gives it for that loop.
#[must_use]
pub fn integrals_over_processes(
    processes: &[Process],
    controller: &Controller,
    scenario: &Scenario,
) -> Vec<Result<Integrals, ResponseError>> {
    let closed = |index: usize| ClosedLoop::new(&processes[index], controller);
    integrals_of_many(processes.len(), |index| processes[index].dead_time(), closed, scenario)
}

/// The integrals of each of these controllers on one process, in their order; see [`integrals_over_processes`].
///
/// # Errors
/// In each place [`ResponseError`], as [`simulate`](super::super::response::simulate) gives it for that loop.
#[must_use]
pub fn integrals_over_controllers(
    process: &Process,
    controllers: &[Controller],
    scenario: &Scenario,
) -> Vec<Result<Integrals, ResponseError>> {
    let closed = |index: usize| ClosedLoop::new(process, &controllers[index]);
    integrals_of_many(controllers.len(), |_| process.dead_time(), closed, scenario)
}
