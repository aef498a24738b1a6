//! Many loops: perturbed processes under one controller, many controllers on one process.

use std::error::Error;
use std::fs::read_to_string;
use std::time::Instant;

use holdup::analysis::batch::{Robustness, integrals_over_processes, margins_of_controllers};
use holdup::analysis::response::Scenario;
use holdup::model::{Controller, Process};
use serde_json::json;

use crate::report;
use crate::work::{controller, four, perturbed, pid, process, scenario, settings};

/// Loops whose numbers are listed, for comparison with the peers.
const LISTED: usize = 20;

/// Four numbers of a loop: integrals, or gain margin, phase margin [rad], delay margin [s] and M_s.
type Four = [Option<f64>; 4];

/// Integrals of the loops 0…count.
fn integrals_of(count: u64, controller: &Controller, scenario: &Scenario) -> Outcome {
    let processes: Vec<Process> = (0..count).filter_map(|index| perturbed(index).ok()).collect();
    let results = integrals_over_processes(&processes, controller, scenario);
    let mut outcome = Outcome::default();
    for result in &results {
        outcome.add(result.as_ref().map(four).unwrap_or_default());
    }
    outcome
}

/// Loops in one slice: what is read and written stays in the cache of the machine.
const SLICE: usize = 16_384;

/// What came out of many loops: how many have an M_s or its like, and the numbers of the first.
#[derive(Default)]
struct Outcome {
    with_result: usize,
    listed: Vec<Four>,
}

impl Outcome {
    fn add(&mut self, four: Four) {
        self.with_result += usize::from(four[3].is_some());
        if self.listed.len() < LISTED {
            self.listed.push(four);
        }
    }
}

/// Margins of these controllers, slice by slice.
fn margins_of(process: &Process, controllers: &[Controller]) -> Outcome {
    let four = |found: &Robustness| {
        [
            found.gain_margin,
            found.phase_margin.map(|m| m.0),
            found.delay_margin.map(|m| m.0),
            found.sensitivity_peak,
        ]
    };
    let mut outcome = Outcome::default();
    for slice in controllers.chunks(SLICE) {
        for found in &margins_of_controllers(process, slice).loops {
            outcome.add(found.as_ref().map(four).unwrap_or_default());
        }
    }
    outcome
}

pub(crate) fn processes(count: u64, threads: usize) -> Result<(), Box<dyn Error>> {
    let (controller, scenario) = (controller()?, scenario(200.0)?);
    timed("processes", count, threads, || integrals_of(count, &controller, &scenario))
}

pub(crate) fn controllers(count: u64, threads: usize) -> Result<(), Box<dyn Error>> {
    let process = process()?;
    // The slice is made beforehand: what is timed is what the library does with it.
    let one = |index| {
        let [kc, ti, td] = settings(index);
        pid(kc, ti, td)
    };
    let slice = (0..count).map(one).collect::<Result<Vec<Controller>, _>>()?;
    timed("controllers", count, threads, || margins_of(&process, &slice))
}

/// Processor time of this program so far, all threads [s], in hundredths; `None` where the system does not tell.
fn processor_time() -> Option<f64> {
    let stat = read_to_string("/proc/self/stat").ok()?;
    let after_name = stat.rsplit_once(')')?.1;
    let mut ticks = after_name.split_whitespace().skip(11).map_while(|word| word.parse::<f64>().ok());
    Some((ticks.next()? + ticks.next()?) / 100.0)
}

/// Runs the work on so many threads, again until a second has passed, and reports the time of one loop: processor time, which
/// other programs on the machine do not lengthen, and time on the wall.
fn timed(
    what: &str,
    count: u64,
    threads: usize,
    work: impl Fn() -> Outcome + Send + Sync,
) -> Result<(), Box<dyn Error>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let (from, before) = (Instant::now(), processor_time());
    let mut outcome = pool.install(&work);
    let mut runs = 1.0;
    while from.elapsed().as_secs_f64() < 1.0 {
        outcome = pool.install(&work);
        runs += 1.0;
    }
    let wall = from.elapsed().as_secs_f64();
    let spent = before.and_then(|before| Some(processor_time()? - before)).unwrap_or(wall);
    #[expect(clippy::cast_precision_loss, reason = "a count is below 2^52")]
    let [each, wall] = [spent, wall].map(|seconds| seconds / (runs * count as f64));
    let Outcome { with_result, listed } = outcome;
    let values = json!({ "threads": threads, "wall": wall, "with_result": with_result, "listed": listed });
    report(what, count, each, values);
    Ok(())
}
