//! One loop: its metrics, its trajectory, its margins, and how the time grows with the horizon.

use std::error::Error;
use std::hint::black_box;
use std::time::Duration;

use holdup::analysis::batch::margins_of;
use holdup::analysis::frequency::margins;
use holdup::analysis::response::{Integrals, Trajectory, integrals, refill_trajectory, simulate};
use holdup::model::{ClosedLoop, Controller, Process, Seconds};
use serde_json::json;

use crate::work::{controller, four, process, scenario};
use crate::{best, report};

const SPEND: Duration = Duration::from_secs(1);

pub(crate) fn run() -> Result<(), Box<dyn Error>> {
    let closed = ClosedLoop::new(&process()?, &controller()?);
    let scenario = scenario(200.0)?;

    let found = integrals(&closed, &scenario)?;
    let seconds = best(SPEND, || drop(black_box(integrals(black_box(&closed), black_box(&scenario)))));
    report("metrics", 1, seconds, json!(four(&found)));
    let seconds = best(SPEND, || drop(black_box(simulate(black_box(&closed), black_box(&scenario)))));
    report("all_metrics", 1, seconds, json!(four(&Integrals::from(&simulate(&closed, &scenario)?.metrics))));

    let time = (0..=20_000).map(|i| f64::from(i) * 0.01).collect();
    let mut trajectory = Trajectory { time, ..Trajectory::default() };
    let found = refill_trajectory(&closed, &scenario, &mut trajectory)?;
    let seconds = best(SPEND, || {
        drop(black_box(refill_trajectory(black_box(&closed), &scenario, black_box(&mut trajectory))));
    });
    report("points", 1, seconds, json!(four(&found)));

    let (process, controller) = (process()?, controller()?);
    let found = margins_of(&process, &controller)?;
    let seconds = best(SPEND, || {
        _ = black_box(margins_of(black_box(&process), black_box(&controller)));
    });
    let [phase, delay] = [found.phase_margin.map(|m| m.0), found.delay_margin.map(|m| m.0)];
    report("margins", 1, seconds, json!([found.gain_margin, phase, delay, found.sensitivity_peak]));
    let found = margins(&closed)?;
    let seconds = best(SPEND, || drop(black_box(margins(black_box(&closed)))));
    let [phase, delay] = [found.phase_margin.map(|m| m.0), found.delay_margin.map(|m| m.0)];
    report("margins-all", 1, seconds, json!([found.gain_margin, phase, delay, found.sensitivity_peak]));
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
            let found = integrals(closed, &scenario)?;
            let seconds = best(SPEND / 4, || drop(black_box(integrals(black_box(closed), &scenario))));
            report(what, u64::from(dead_times), seconds, json!(four(&found)));
        }
    }
    Ok(())
}
