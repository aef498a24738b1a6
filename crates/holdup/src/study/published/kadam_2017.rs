//! S. D. Kadam, "Disturbance Observer based Control of Integrating Processes with Dead-Time using PD
//! controller", arXiv 1711.11250 (2017): its eight tables.
//!
//! Conventions tried. Derivative action on the control error, filtered at N = 100 rad/s; the load enters at the
//! process input, before the dead time; 200 s for the step and regulatory tables, 300 s for servo plus
//! regulatory; every setpoint move of the servo tables alone, from rest, for 200 s. Wang–Cluett with β = 3 (the
//! text) and β = 4 (the parameter table); the proposed PD in ideal form (the text) and in parallel form, where
//! 1.0343 is the derivative gain.

mod findings;

use serde::Deserialize;

use super::{Candidate, Floor, Printed, PublishedError, Reproduction, Summary, judge};
use crate::analysis::bounds::Bounds;
use crate::analysis::metrics::Metrics;
use crate::analysis::response::{Scenario, simulate};
use crate::model::{ClosedLoop, Controller, Observer, Process, Seconds};
use crate::tuning::{Parameters, rule};

/// Bandwidth of the derivative filter [rad/s] under which the tables reproduce.
const FILTER_BANDWIDTH: f64 = 100.0;

#[derive(Deserialize)]
struct Paper {
    process_gain: f64,
    dead_time_s: f64,
    table: Vec<Table>,
}

#[derive(Deserialize)]
struct Table {
    name: String,
    columns: Vec<String>,
    rows: toml::Table,
}

/// One reading of the controller of a row.
#[derive(Debug, Clone)]
struct Reading {
    convention: &'static str,
    stated: bool,
    controller: Controller,
}

/// Recomputes every printed cell of the paper.
///
/// # Errors
/// [`PublishedError`] if a loop of the paper cannot be built or simulated: a defect of this software.
///
/// ```
/// let reproduction = holdup::study::published::kadam_2017::reproduce()?;
/// assert_eq!(reproduction.cells.len(), 87);
/// assert_eq!(reproduction.summary.impossible, 5);
/// # Ok::<(), holdup::study::published::PublishedError>(())
/// ```
pub fn reproduce() -> Result<Reproduction, PublishedError> {
    let paper: Paper = toml::from_str(include_str!("kadam_2017.toml"))?;
    let process = Process::integrating(paper.process_gain, Seconds(paper.dead_time_s))?;
    let mut cells = Vec::new();
    for table in &paper.table {
        for (row, printed) in &table.rows {
            let printed = printed.as_array().map(Vec::as_slice).unwrap_or_default();
            let readings = readings(&process, row)?;
            for (column, text) in table.columns.iter().zip(printed) {
                let Some(printed) = text.as_str().and_then(Printed::parse) else { continue };
                let place = (table.name.as_str(), row.as_str(), column.as_str());
                let (candidates, floors) = compute(&process, place, &readings)?;
                cells.extend(judge(place, printed, candidates, &floors));
            }
        }
    }
    let summary = Summary::of(&cells);
    let findings = findings::of(&process, &cells)?;
    let paper = "S. D. Kadam, Disturbance Observer based Control of Integrating Processes with Dead-Time using PD controller, arXiv 1711.11250 (2017)";
    Ok(Reproduction { paper: paper.to_owned(), cells, summary, findings })
}

/// The controllers that a row may mean, without observer.
fn readings(process: &Process, row: &str) -> Result<Vec<Reading>, PublishedError> {
    let pid = |kc: f64, ti: f64, td: f64| {
        Controller::proportional(kc)?
            .with_integral_time(Seconds(ti))?
            .with_derivative_time(Seconds(td))?
            .with_filter_bandwidth(FILTER_BANDWIDTH)
    };
    let pd = |kc: f64, td: f64| {
        Controller::proportional(kc)?
            .with_derivative_time(Seconds(td))?
            .with_filter_bandwidth(FILTER_BANDWIDTH)
    };
    let reading = |convention, stated, controller| Reading { convention, stated, controller };
    let wang_cluett = |beta: f64| -> Result<Controller, PublishedError> {
        let tuning = rule("pid-wang-cluett-z1")?.tune(process, &Parameters::new().set("beta", beta))?;
        Ok(tuning.controller.with_filter_bandwidth(FILTER_BANDWIDTH)?)
    };
    Ok(match row {
        "wang_cluett" => vec![
            reading("β = 3, as in the text", true, wang_cluett(3.0)?),
            reading("β = 4, as in the parameter table", false, wang_cluett(4.0)?),
        ],
        "sree_chidambaram" => vec![reading("parameters as printed", true, pid(2.95, 15.0, 3.0)?)],
        "ali_majhi" => vec![reading("parameters as printed", true, pid(3.39, 19.02, 2.94)?)],
        _ => {
            let tuned = rule("pd-kadam")?.tune(process, &Parameters::new())?.controller;
            let (kc, td) = (tuned.proportional_gain(), tuned.derivative_time().unwrap_or_default());
            vec![
                reading("ideal form, derivative time 1.0343 s", true, pd(kc, td)?),
                reading("parallel form, derivative gain 1.0343", false, pd(kc, td / kc)?),
            ]
        }
    })
}

/// What each reading gives for a cell, and what no reading can go below.
fn compute(
    process: &Process,
    (table, row, column): (&str, &str, &str),
    readings: &[Reading],
) -> Result<(Vec<Candidate>, Vec<Floor>), PublishedError> {
    let mut candidates = Vec::new();
    let mut floors = Vec::new();
    for reading in readings {
        let candidate = |convention: &str, stated, computed: Option<f64>| {
            computed.map(|computed| Candidate { convention: convention.to_owned(), stated, computed })
        };
        if table == "controller_parameters" {
            if !reading.stated && row != "wang_cluett" {
                continue; // the two forms of the proposed PD share their parameters
            }
            let value = parameter(process, row, reading, column)?;
            candidates.extend(candidate(reading.convention, reading.stated, value));
            continue;
        }
        let step = move_of(column);
        let servo = scenario(&[(0.0, step)], &[], 200.0)?;
        let load = scenario(&[], &[(0.0, 1.0)], 200.0)?;
        let both = scenario(&[(0.0, 1.0)], &[(100.0, 1.0)], 300.0)?;
        let observed = with_observer(row, reading.controller)?;
        let value = |controller: &Controller, scenario: &Scenario| -> Result<Option<f64>, PublishedError> {
            let metrics = simulate(&ClosedLoop::new(process, controller), scenario)?.metrics;
            Ok(metric(&metrics, table, column))
        };
        match table {
            "regulatory" => {
                candidates.extend(candidate(reading.convention, reading.stated, value(&observed, &load)?));
            }
            "servo_and_regulatory" => {
                candidates.extend(candidate(reading.convention, reading.stated, value(&observed, &both)?));
                let sum = match (value(&reading.controller, &servo)?, value(&observed, &load)?) {
                    (Some(servo), Some(load)) => Some(servo + load),
                    _ => None,
                };
                let convention = format!("{}; two separate runs, summed", reading.convention);
                candidates.extend(candidate(&convention, false, sum));
            }
            _ => candidates.extend(candidate(
                reading.convention,
                reading.stated,
                value(&reading.controller, &servo)?,
            )),
        }
        if reading.stated {
            let scenario = match table {
                "regulatory" => load,
                "servo_and_regulatory" => both,
                _ => servo,
            };
            floors = limits(process, row, &observed, &scenario, (table, column), step);
        }
    }
    Ok((candidates, floors))
}

/// Bounds that hold for every controller, and the exact integral of the error of this loop.
fn limits(
    process: &Process,
    row: &str,
    controller: &Controller,
    scenario: &Scenario,
    (table, column): (&str, &str),
    step: f64,
) -> Vec<Floor> {
    let bounds = Bounds::of(process, scenario);
    let index = index_of(table, column);
    let bound = match index {
        "ise" => bounds.ise,
        "iae" => bounds.iae,
        "itae" => bounds.itae,
        _ => None,
    };
    let mut floors: Vec<Floor> = bound
        .map(|value| Floor {
            value,
            why: format!(
                "no controller can have {} below {value:.4} here: nothing that a controller does reaches the output before the dead time has passed",
                index.to_uppercase()
            ),
        })
        .into_iter()
        .collect();
    // |∫e dt| is a lower limit of the IAE. Of a PD loop it is 1/(K·Kc) for a unit setpoint step, and
    // 1/(K·Kc·Ko) for a unit load step with the observer: final-value theorem on e/s.
    if row == "proposed" && index == "iae" {
        let gain = process.process_gain() * controller.proportional_gain();
        let identity = match table {
            "regulatory" => controller.observer().map(|o| (1.0 / (gain * o.gain()), "1/(K·Kc·Ko)")),
            "servo_and_regulatory" => None,
            _ => Some((step.abs() / gain, "|Δr|/(K·Kc)")),
        };
        floors.extend(identity.map(|(value, formula)| Floor {
            value: value * 0.995, // the identity is for an infinite horizon; what 200 s leave out is less
            why: format!("|∫e dt| = {formula} = {value:.3} exactly for this loop, and IAE cannot be smaller"),
        }));
    }
    floors
}

/// A controller parameter of the parameter table: what the rule or the stated formula gives.
fn parameter(
    process: &Process,
    row: &str,
    reading: &Reading,
    column: &str,
) -> Result<Option<f64>, PublishedError> {
    let controller = match row {
        "sree_chidambaram" => rule("pid-sree-chidambaram")?.tune(process, &Parameters::new())?.controller,
        "ali_majhi" => rule("pid-ali-majhi")?.tune(process, &Parameters::new())?.controller,
        "proposed" => rule("pd-kadam")?.tune(process, &Parameters::new())?.controller,
        _ => reading.controller,
    };
    Ok(match column {
        "kc" => Some(controller.proportional_gain()),
        "ti_s" => controller.integral_time(),
        _ => controller.derivative_time(),
    })
}

/// The row's controller with the observer where the paper adds one: Ko = Kc for the proposed PD.
fn with_observer(row: &str, controller: Controller) -> Result<Controller, PublishedError> {
    Ok(match row {
        "proposed" => controller.with_observer(Observer::new(controller.proportional_gain())?),
        _ => controller,
    })
}

/// Height of the setpoint move of a column: the setpoint goes 0, 1, 3, 2 in the servo tables.
fn move_of(column: &str) -> f64 {
    match column {
        "sp_3" => 2.0,
        "sp_2" => -1.0,
        _ => 1.0,
    }
}

/// Name of the integral in a column of a table.
fn index_of<'a>(table: &str, column: &'a str) -> &'a str {
    match table {
        "servo_ise" => "ise",
        "servo_iae" => "iae",
        _ => column,
    }
}

fn metric(metrics: &Metrics, table: &str, column: &str) -> Option<f64> {
    match index_of(table, column) {
        "ise" => metrics.ise,
        "iae" => metrics.iae,
        "itae" => metrics.itae,
        "energy" => metrics.control_energy,
        "rise_s" => metrics.rise_time.map(|Seconds(t)| t),
        "settling_s" => metrics.settling_time.map(|Seconds(t)| t),
        "overshoot_pct" => metrics.overshoot.map(|ratio| 100.0 * ratio),
        _ => None,
    }
}

fn scenario(setpoint: &[(f64, f64)], load: &[(f64, f64)], horizon: f64) -> Result<Scenario, PublishedError> {
    Ok(Scenario::new(setpoint.to_vec(), load.to_vec(), Seconds(horizon), 0.0)?)
}
