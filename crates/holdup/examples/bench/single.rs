//! One loop: its metrics, its trajectory, its margins, and how the time grows with the horizon.

use std::error::Error;
use std::hint::black_box;
use std::time::Duration;

use holdup::analysis::frequency::margins;
use holdup::analysis::response::{simulate, simulate_with_trajectory};
use holdup::model::{ClosedLoop, Controller, Process, Seconds};
use serde_json::json;

use crate::work::{controller, integrals, process, scenario};
use crate::{best, report};

const SPEND: Duration = Duration::from_secs(1);

pub(crate) fn run() -> Result<(), Box<dyn Error>> {
    let closed = ClosedLoop::new(&process()?, &controller()?);
    let scenario = scenario(200.0)?;

    let metrics = simulate(&closed, &scenario)?.metrics;
    let seconds = best(SPEND, || drop(black_box(simulate(black_box(&closed), black_box(&scenario)))));
    report("metrics", 1, seconds, json!(integrals(&metrics)));

    let times: Vec<f64> = (0..=20_000).map(|i| f64::from(i) * 0.01).collect();
    let (response, _) = simulate_with_trajectory(&closed, &scenario, &times)?;
    let seconds = best(SPEND, || {
        drop(black_box(simulate_with_trajectory(black_box(&closed), &scenario, black_box(&times))));
    });
    report("points", 1, seconds, json!(integrals(&response.metrics)));

    let found = margins(&closed)?;
    let seconds = best(SPEND, || drop(black_box(margins(black_box(&closed)))));
    let values = [
        found.gain_margin,
        found.phase_margin.map(|m| m.0),
        found.delay_margin.map(|m| m.0),
        found.sensitivity_peak,
    ];
    report("margins", 1, seconds, json!(values));
    Ok(())
}

/// The paper's loop, which comes to rest, and one that hardly decays, over 10 to 10 000 dead times.
pub(crate) fn horizon() -> Result<(), Box<dyn Error>> {
    let slow = Process::integrating(1.0, Seconds(1.0))?;
    let oscillating = ClosedLoop::new(&slow, &Controller::proportional(1.57)?);
    let paper = ClosedLoop::new(&process()?, &controller()?);
    for dead_times in [10_u32, 30, 100, 300, 1000, 3000, 10_000] {
        for (what, closed, dead_time) in [("paper", &paper, 6.0), ("oscillating", &oscillating, 1.0)] {
            let scenario = scenario(f64::from(dead_times) * dead_time)?;
            let metrics = simulate(closed, &scenario)?.metrics;
            let seconds = best(SPEND / 4, || drop(black_box(simulate(black_box(closed), &scenario))));
            report(what, u64::from(dead_times), seconds, json!(integrals(&metrics)));
        }
    }
    Ok(())
}
