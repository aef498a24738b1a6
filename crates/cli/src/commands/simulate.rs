//! `holdup simulate`: one loop on one scenario.

use std::fmt::Write as _;

use holdup::analysis::bounds::Bounds;
use holdup::analysis::metrics::Metrics;
use holdup::analysis::response::sampled::LoadRamp;
use holdup::analysis::response::{Scenario, Trajectory, plot_times, simulate, trajectory};
use holdup::model::quantity::{read_number, read_time};
use holdup::model::{ClosedLoop, Controller};
use holdup::study::PercentOfBest;
use holdup::study::figures::terminal;
use serde_json::json;

use super::simulate_sampled;
use super::view::{METRICS, check_kind, controller_line, figure_file, process_line, response_figure};
use crate::args::SimulateArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::input::{closed_loop, scenario, scenario_with};
use crate::table::{number, table};

/// Times in a file, where their number is not given.
const POINTS: usize = 2001;

/// The greatest number of times in a file.
const GREATEST: f64 = 10_000_000.0;

/// Simulates the loop.
pub(crate) fn run(args: &SimulateArgs, console: Console) -> Result<Answer, Fault> {
    let (process, controller) = closed_loop(&args.of)?;
    let equipment = args.sampled.equipment()?;
    let ramps = args.sampled.ramps()?;
    let scenario = match ramps.iter().map(LoadRamp::end).max_by(f64::total_cmp) {
        None => scenario(&args.scenario, &process)?,
        last_ramp => scenario_with(&args.scenario, &process, last_ramp)?,
    };
    args.plot.as_deref().map_or(Ok(()), check_kind)?;
    if let Some(equipment) = &equipment {
        return simulate_sampled::run(args, (process, controller), (scenario, ramps), equipment, console);
    }
    let times = times(args, scenario.horizon())?;
    let closed = ClosedLoop::new(&process, &controller);
    let response = simulate(&closed, &scenario).map_err(Fault::input)?;
    let bounds = Bounds::of(&process, &scenario);
    let percent_of_best = PercentOfBest::of(&response.metrics, &bounds);
    let mut warnings = response.warnings.clone();
    warnings.extend(bounds.reasons.iter().cloned());
    let json = json!({
        "metrics": response.metrics,
        "bounds": bounds,
        "percent_of_best": percent_of_best,
        "final": {
            "controlled_variable": response.final_controlled_variable,
            "manipulated_variable": response.final_manipulated_variable,
        },
        "overflow_at_s": response.overflow_at.map(|time| time.0),
        "horizon_s": scenario.horizon(),
        "warnings": warnings,
    });
    let draw = |times: &[f64]| trajectory(&closed, &scenario, times).map_err(Fault::input);
    let mut files = Vec::new();
    if args.csv.is_some() || args.plot.is_some() {
        if let Some(path) = &args.csv {
            files.push((path.clone(), csv(&draw(&times)?, None)));
        }
        if let Some(path) = &args.plot {
            let times = if args.points.is_some() || args.step.is_some() {
                times
            } else {
                plot_times(&closed, &scenario, POINTS)
            };
            let figure = figure(&controller, &scenario, draw(&times)?)?;
            files.push((path.clone(), figure_file(path, &figure)?));
        }
    }
    let mut text = String::new();
    if !console.json {
        text = format!(
            "{}\non {}, to {} s\n\n",
            controller_line(&controller),
            process_line(&process),
            number(scenario.horizon())
        );
        text += &table_of(&[("this loop", &response.metrics)], &bounds, console);
        let _ = write!(
            text,
            " at the end: y = {}, u = {}\n\n",
            number(response.final_controlled_variable),
            number(response.final_manipulated_variable)
        );
        let seen = plot_times(&closed, &scenario, 4 * console.width);
        text +=
            &terminal::chart(&figure(&controller, &scenario, draw(&seen)?)?, console.width, console.colour);
    }
    // Why a bound is absent is said in the JSON; on standard error only what concerns the run.
    Ok(Answer { json, text, warnings: response.warnings, files })
}

/// The metrics of one loop or more, the first one against the best possible.
pub(super) fn table_of(columns: &[(&str, &Metrics)], bounds: &Bounds, console: Console) -> String {
    let percent_of_best = columns.first().map(|(_, metrics)| PercentOfBest::of(metrics, bounds));
    let sampled = columns.iter().any(|(_, metrics)| metrics.valve_travel.is_some());
    let bounded = !sampled || [bounds.iae, bounds.ise, bounds.itae, bounds.peak].iter().any(Option::is_some);
    let rows = METRICS.iter().filter(|(name, _)| sampled || *name != "travel").map(|(name, pick)| {
        let percent = |of: fn(&PercentOfBest) -> Option<f64>| percent_of_best.as_ref().and_then(of);
        let (bound, percent) = match *name {
            "IAE" => (bounds.iae, percent(|best| best.iae)),
            "ISE" => (bounds.ise, percent(|best| best.ise)),
            "ITAE" => (bounds.itae, percent(|best| best.itae)),
            "peak" => (bounds.peak, percent(|best| best.peak)),
            _ => (None, None),
        };
        let name = match *name {
            "energy" => "energy of u",
            "variation" => "total variation of u",
            "over [%]" => "overshoot [%]",
            "rise [s]" => "rise time, 10 to 90 % [s]",
            "2 % [s]" => "settling time, 2 % [s]",
            "5 % [s]" => "settling time, 5 % [s]",
            "travel" => "valve travel",
            name => name,
        };
        let values = columns.iter().map(|(_, metrics)| pick(metrics));
        let best = [number(bound), number(percent)].into_iter().take(if bounded { 2 } else { 0 });
        std::iter::once(name.to_owned()).chain(values).chain(best).collect()
    });
    let rows: Vec<Vec<String>> = rows.collect();
    let mut heading = vec![""];
    heading.extend(columns.iter().map(|(name, _)| *name));
    heading.extend(["no controller beats", "% of best possible"].iter().take(if bounded { 2 } else { 0 }));
    table(console, &heading, &rows)
}

fn figure(
    controller: &Controller,
    scenario: &Scenario,
    run: Trajectory,
) -> Result<holdup::study::figures::Figure, Fault> {
    let runs = [(controller.structure().to_owned(), run)];
    response_figure(&controller_line(controller), scenario, &runs, true).map_err(Fault::input)
}

/// The times of `--points` or `--step`.
pub(super) fn times(args: &SimulateArgs, horizon: f64) -> Result<Vec<f64>, Fault> {
    if let Some(text) = &args.step {
        let step = read_time("--step", text).map_err(Fault::input)?;
        if !(step > 0.0 && step <= horizon && horizon / step < GREATEST) {
            let allowed = format!(
                "greater than 0, at most the horizon of {horizon} s, and give at most {GREATEST} times"
            );
            return Err(Fault::input(format!("--step is {text}: must be {allowed}")));
        }
        // The horizon itself is always the last time.
        let mut times: Vec<f64> =
            (0..=u32::MAX).map(|k| f64::from(k) * step).take_while(|time| *time < horizon).collect();
        times.push(horizon);
        return Ok(times);
    }
    let Some(text) = &args.points else { return Ok(evenly(0.0, horizon, POINTS)) };
    let count = read_number("--points", text).map_err(Fault::input)?;
    if !(2.0..=GREATEST).contains(&count) || count.fract() != 0.0 {
        return Err(Fault::input(format!("--points is {text}: must be a whole number from 2 to {GREATEST}")));
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number in range")]
    Ok(evenly(0.0, horizon, count as usize))
}

/// So many times from `start` to `end`, both included.
fn evenly(start: f64, end: f64, count: usize) -> Vec<f64> {
    let last = u32::try_from(count.max(2) - 1).unwrap_or(u32::MAX);
    let between = |k: u32| start + (end - start) * (f64::from(k) / f64::from(last));
    (0..=last).map(|k| if k == last { end } else { between(k) }).collect()
}

/// The trajectory as CSV, the position of a valve behind it; what is not a finite number is an empty cell.
pub(super) fn csv(run: &Trajectory, valve_position: Option<&[f64]>) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(run.time.len() * 96 + 96);
    bytes.extend_from_slice(b"t,setpoint,controlled_variable,manipulated_variable,load,load_estimate");
    bytes.extend_from_slice(if valve_position.is_some() { b",valve_position\n" } else { b"\n" });
    let mut buffer = zmij::Buffer::new();
    for (index, &time) in run.time.iter().enumerate() {
        let cells = [
            Some(time),
            run.setpoint.get(index).copied(),
            run.controlled_variable.get(index).copied(),
            run.manipulated_variable.get(index).copied(),
            run.load.get(index).copied(),
            run.load_estimate.as_ref().and_then(|estimate| estimate.get(index).copied()),
        ];
        let position = valve_position.map(|positions| positions.get(index).copied());
        for (column, cell) in cells.into_iter().chain(position).enumerate() {
            if column > 0 {
                bytes.push(b',');
            }
            if let Some(value) = cell.filter(|value| value.is_finite()) {
                bytes.extend_from_slice(buffer.format_finite(value).as_bytes());
            }
        }
        bytes.push(b'\n');
    }
    bytes
}
