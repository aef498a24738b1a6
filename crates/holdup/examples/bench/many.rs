//! Many loops: perturbed processes under one controller, many controllers on one process.

use std::error::Error;
use std::fs::read_to_string;
use std::time::Instant;

use holdup::analysis::batch::integrals_over_processes;
use holdup::analysis::frequency::margins;
use holdup::analysis::response::Scenario;
use holdup::model::{ClosedLoop, Controller, Process};
use rayon::prelude::*;
use serde_json::json;

use crate::report;
use crate::work::{controller, four, perturbed, pid, process, scenario, settings};

/// Loops whose numbers are listed, for comparison with the peers.
const LISTED: usize = 20;

/// Four numbers of a loop: integrals, or gain margin, phase margin [rad], delay margin [s] and M_s.
type Four = [Option<f64>; 4];

/// Integrals of the loops 0…count.
fn integrals_of(count: u64, controller: &Controller, scenario: &Scenario) -> Vec<Four> {
    let processes: Vec<Process> = (0..count).filter_map(|index| perturbed(index).ok()).collect();
    let results = integrals_over_processes(&processes, controller, scenario);
    results.iter().map(|result| result.as_ref().map(four).unwrap_or_default()).collect()
}

/// Margins of the controllers 0…count, one by one: there is no batch interface for them.
fn margins_of(count: u64) -> Vec<Four> {
    let one = |index| -> Result<Four, Box<dyn Error>> {
        let [kc, ti, td] = settings(index);
        let found = margins(&ClosedLoop::new(&process()?, &pid(kc, ti, td)?))?;
        Ok([
            found.gain_margin,
            found.phase_margin.map(|m| m.0),
            found.delay_margin.map(|m| m.0),
            found.sensitivity_peak,
        ])
    };
    (0..count).into_par_iter().map(|index| one(index).unwrap_or_default()).collect()
}

pub(crate) fn processes(count: u64, threads: usize) -> Result<(), Box<dyn Error>> {
    let (controller, scenario) = (controller()?, scenario(200.0)?);
    timed("processes", count, threads, || integrals_of(count, &controller, &scenario))
}

pub(crate) fn controllers(count: u64, threads: usize) -> Result<(), Box<dyn Error>> {
    timed("controllers", count, threads, || margins_of(count))
}

/// Processor time of this program so far, all threads [s], in hundredths; `None` where the system does not tell.
fn processor_time() -> Option<f64> {
    let stat = read_to_string("/proc/self/stat").ok()?;
    let after_name = stat.rsplit_once(')')?.1;
    let mut ticks = after_name.split_whitespace().skip(11).map_while(|word| word.parse::<f64>().ok());
    Some((ticks.next()? + ticks.next()?) / 100.0)
}

/// Runs the work once on so many threads and reports the time of one loop: processor time, which other programs on the
/// machine do not lengthen, and time on the wall.
fn timed(
    what: &str,
    count: u64,
    threads: usize,
    work: impl Fn() -> Vec<Four> + Send + Sync,
) -> Result<(), Box<dyn Error>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let (from, before) = (Instant::now(), processor_time());
    let results = pool.install(&work);
    let wall = from.elapsed().as_secs_f64();
    let spent = before.and_then(|before| Some(processor_time()? - before)).unwrap_or(wall);
    let stable = results.iter().filter(|four| four[3].is_some()).count();
    let listed = &results[..results.len().min(LISTED)];
    #[expect(clippy::cast_precision_loss, reason = "a count is below 2^52")]
    let [each, wall] = [spent, wall].map(|seconds| seconds / count as f64);
    let values = json!({ "threads": threads, "wall": wall, "with_result": stable, "listed": listed });
    report(what, count, each, values);
    Ok(())
}
