//! The four integrals alone, of one loop or of many: everything else that [`simulate`] finds costs more than they do.

use rayon::prelude::*;

use super::error::ResponseError;
use super::layered;
use super::scenario::Scenario;
use super::simulate;
use crate::analysis::metrics::Metrics;
use crate::model::ClosedLoop;

/// Fewer loops are as fast one by one.
const WORTHWHILE: usize = 4;

/// Most breakpoints between which dead times are counted, to find loops to which the same happens in the same order.
const COUNTED: usize = 12;

/// The integrals of one response, as in [`Metrics`]; one that is infinite or exceeds the range of numbers is absent.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Integrals {
    /// Integral of the absolute error [output unit · s].
    pub iae: Option<f64>,
    /// Integral of the squared error [output unit² · s].
    pub ise: Option<f64>,
    /// Integral of time times the absolute error [output unit · s²], time counted from 0.
    pub itae: Option<f64>,
    /// Integral of the squared controller output [input unit² · s], the load not included.
    pub control_energy: Option<f64>,
}

impl From<&Metrics> for Integrals {
    fn from(metrics: &Metrics) -> Self {
        Self {
            iae: metrics.iae,
            ise: metrics.ise,
            itae: metrics.itae,
            control_energy: metrics.control_energy,
        }
    }
}

impl Integrals {
    fn new([iae, ise, itae, energy]: [f64; 4]) -> Self {
        let finite = |value: f64| Some(value).filter(|value| value.is_finite());
        Self { iae: finite(iae), ise: finite(ise), itae: finite(itae), control_energy: finite(energy) }
    }
}

/// The integrals of a loop over a scenario, relative error below 1e-9: those of [`simulate`], in a fraction of its time.
///
/// ```
/// use holdup::analysis::response::{Scenario, integrals};
/// use holdup::model::{ClosedLoop, Controller, Process, Seconds};
/// let process = Process::integrating(0.0506, Seconds(6.0))?;
/// let pi = Controller::proportional(1.6)?.with_integral_time(Seconds(48.0))?;
/// let load = Scenario::unit_load_step(Seconds(2000.0))?;
/// let found = integrals(&ClosedLoop::new(&process, &pi), &load)?;
/// // Without a change of sign the integral of the error is Ti/Kc, and so is that of its magnitude.
/// assert!((found.iae.unwrap() / (48.0 / 1.6) - 1.0).abs() < 0.02);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`simulate`].
pub fn integrals(closed_loop: &ClosedLoop, scenario: &Scenario) -> Result<Integrals, ResponseError> {
    if let Some(sums) = layered::integrals(closed_loop, scenario) {
        return Ok(Integrals::new(sums));
    }
    simulate(closed_loop, scenario).map(|response| Integrals::from(&response.metrics))
}

/// The integrals of the loops 0 … `count`, in their order, on all cores.
///
/// Loops are computed together where the same happens to them in the same order, which is decided by their dead times [s].
pub(in crate::analysis) fn integrals_of_many(
    count: usize,
    dead_time: impl Fn(usize) -> f64 + Sync,
    closed_loop: impl Fn(usize) -> ClosedLoop + Sync,
    scenario: &Scenario,
) -> Vec<Result<Integrals, ResponseError>> {
    let breakpoints = breakpoints(scenario);
    let mut order: Vec<(u64, f64, usize)> = (0..count)
        .into_par_iter()
        .map(|index| {
            let dead_time = dead_time(index);
            (course(&breakpoints, dead_time), dead_time, index)
        })
        .collect();
    order.par_sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
    let bundles: Vec<&[(u64, f64, usize)]> =
        order.chunk_by(|a, b| a.0 == b.0).flat_map(|alike| alike.chunks(layered::MOST)).collect();
    let found: Vec<(usize, Result<Integrals, ResponseError>)> = bundles
        .into_par_iter()
        .flat_map_iter(|bundle| {
            let loops: Vec<ClosedLoop> = bundle.iter().map(|(_, _, index)| closed_loop(*index)).collect();
            let results = of_bundle(&loops, scenario);
            bundle.iter().map(|(_, _, index)| *index).zip(results)
        })
        .collect();
    let mut results = vec![Ok(Integrals::default()); count];
    for (index, result) in found {
        results[index] = result;
    }
    results
}

fn of_bundle(loops: &[ClosedLoop], scenario: &Scenario) -> Vec<Result<Integrals, ResponseError>> {
    if loops.len() >= WORTHWHILE
        && let Some(sums) = layered::integrals_together(loops, scenario)
    {
        return sums.into_iter().map(|sums| Ok(Integrals::new(sums))).collect();
    }
    loops.iter().map(|one| integrals(one, scenario)).collect()
}

/// The first times at which something happens that all loops share, the horizon among them.
fn breakpoints(scenario: &Scenario) -> Vec<f64> {
    let moves = scenario.setpoint_moves().into_iter().chain(scenario.load_moves());
    let mut times: Vec<f64> = moves.map(|(time, _)| time).chain([scenario.horizon()]).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times.truncate(COUNTED);
    times
}

/// A number that loops have in common whose events and their delayed images come in the same order: the whole dead times
/// between any two breakpoints, mixed. Those that have it in common by chance part ways on the run, and are then run alone.
fn course(breakpoints: &[f64], dead_time: f64) -> u64 {
    let mut mixed = 0xcbf2_9ce4_8422_2325_u64;
    for (i, from) in breakpoints.iter().enumerate() {
        for to in &breakpoints[i + 1..] {
            let whole = ((to - from) / dead_time).floor();
            mixed = (mixed ^ whole.to_bits()).wrapping_mul(0x0000_0100_0000_01b3).rotate_left(23);
        }
    }
    mixed
}
