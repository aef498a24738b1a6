//! `holdup compare`: a study, as tables, report, figure or data.

use std::fmt::Write as _;

use holdup::analysis::metrics::{METRICS as COLUMNS, Metrics};
use holdup::analysis::response::{plot_times, trajectory};
use holdup::model::{ClosedLoop, Process, Radians};
use holdup::study::figures::{Figure, terminal};
use holdup::study::published::reproduce;
use holdup::study::report::report as page_of;
use holdup::study::{
    ControllerResult, FamilyResult, Row, ScenarioResult, Study, StudyResult, read_study, run_study,
};

use super::view::{METRICS, check_kind, figure_file, process_line, response_figure};
use crate::args::CompareArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::input::text_of;
use crate::table::{number, table, title};

/// Points of a curve in a figure.
const POINTS: usize = 1501;

/// Runs the study.
pub(crate) fn run(args: &CompareArgs, console: Console) -> Result<Answer, Fault> {
    args.plot.as_deref().map_or(Ok(()), check_kind)?;
    let study = read_study(&text_of(&args.study)?).map_err(|error| Fault::text(&args.study, &error))?;
    let result = run_study(&study)
        .map_err(|error| Fault::input(format!("{}:{}: {error}", args.study.display(), error.line)))?;
    let mut files = Vec::new();
    if let Some(path) = &args.csv {
        files.push((path.clone(), csv(&result)));
    }
    if let Some(path) = &args.plot {
        let scenario = chosen(&result, args.scenario.as_deref())?;
        let figure = figure(&study.process, &result, scenario, POINTS)?;
        files.push((path.clone(), figure_file(path, &figure)?));
    }
    if let Some(path) = &args.report {
        files.push((path.clone(), report(&study, &result)?));
    }
    let text = if console.json { String::new() } else { text(&study.process, &result, console)? };
    let json = serde_json::to_value(&result).map_err(Fault::input)?;
    Ok(Answer { json, text, warnings: result.warnings, files })
}

/// The scenario of this name, or the first.
fn chosen<'r>(result: &'r StudyResult, name: Option<&str>) -> Result<&'r ScenarioResult, Fault> {
    let found = match name {
        Some(name) => result.scenarios.iter().find(|scenario| scenario.name == name),
        None => result.scenarios.first(),
    };
    found.ok_or_else(|| {
        let names: Vec<String> =
            result.scenarios.iter().map(|scenario| format!("'{}'", scenario.name)).collect();
        Fault::option(
            "--scenario",
            format!("'{}' must be one of {}", name.unwrap_or_default(), names.join(", ")),
        )
    })
}

fn text(process: &Process, result: &StudyResult, console: Console) -> Result<String, Fault> {
    let mut text = title(console, &result.title);
    let _ = writeln!(text, "{}", process_line(process));
    for scenario in &result.scenarios {
        text.push('\n');
        text += &title(console, &scenario_line(scenario));
        text += &scenario_tables(scenario, console);
    }
    text.push('\n');
    text += &title(console, "Controllers and what they achieve");
    text += &controllers(result, console);
    for family in &result.families {
        text.push('\n');
        text += &title(console, &format!("{}: {} varied", family.name, family.vary));
        text += &members(family, console);
    }
    if let Some(scenario) = result.scenarios.first().filter(|scenario| !scenario.rows.is_empty()) {
        text.push('\n');
        let figure = figure(process, result, scenario, 4 * console.width)?;
        text += &terminal::chart(&figure, console.width, console.colour);
    }
    Ok(text)
}

fn scenario_line(scenario: &ScenarioResult) -> String {
    let events = |name: &str, events: &[(f64, f64)]| {
        let pairs: Vec<String> = events.iter().map(|(time, value)| format!("{time}:{value}")).collect();
        if pairs.is_empty() { String::new() } else { format!(", {name} {}", pairs.join(",")) }
    };
    let mut ramps = String::new();
    for (start, end, change) in &scenario.load_ramp {
        let _ = write!(ramps, ", load ramp {start}:{end}:{change}");
    }
    format!(
        "{}{}{}{ramps}, to {} s",
        scenario.name,
        events("setpoint", &scenario.setpoint),
        events("load", &scenario.load),
        scenario.horizon_s
    )
}

/// Two tables: the metrics, and how near they come to the best possible. Columns without a value are left out.
fn scenario_tables(scenario: &ScenarioResult, console: Console) -> String {
    let lines: Vec<(String, &Metrics)> = scenario.rows.iter().flat_map(Row::lines).collect();
    let used: Vec<usize> = (0..METRICS.len())
        .filter(|&index| lines.iter().any(|(_, metrics)| (COLUMNS[index].value)(metrics).is_some()))
        .collect();
    let heading: Vec<&str> = std::iter::once("").chain(used.iter().map(|&index| METRICS[index].0)).collect();
    let rows = lines.into_iter().map(|(name, metrics)| {
        let cells = used.iter().map(|&index| METRICS[index].1(metrics));
        std::iter::once(name).chain(cells).collect()
    });
    let mut text = table(console, &heading, &rows.collect::<Vec<Vec<String>>>());
    let best = |row: &Row| {
        [row.percent_of_best.iae, row.percent_of_best.ise, row.percent_of_best.itae, row.percent_of_best.peak]
    };
    if scenario.rows.iter().any(|row| best(row).iter().any(Option::is_some)) {
        text.push('\n');
        let bounds = &scenario.rows[0].bounds;
        let least = [bounds.iae, bounds.ise, bounds.itae, bounds.peak];
        let names = ["IAE", "ISE", "ITAE", "peak"];
        let heading: Vec<String> =
            names.iter().zip(least).map(|(name, least)| format!("{name} ≥ {}", number(least))).collect();
        let heading: Vec<&str> =
            std::iter::once("% of best possible").chain(heading.iter().map(String::as_str)).collect();
        let rows = scenario.rows.iter().map(|row| {
            std::iter::once(row.controller.clone()).chain(best(row).into_iter().map(number)).collect()
        });
        text += &table(console, &heading, &rows.collect::<Vec<Vec<String>>>());
    }
    text
}

const ACHIEVED: [&str; 9] = ["", "Kc", "Ti [s]", "Td [s]", "Ko", "A_m", "φ_m [°]", "M_s", "delay m. [s]"];

fn achieved(name: &str, result: &ControllerResult) -> Vec<String> {
    let (controller, margins) = (result.controller.as_ref(), result.achieved.as_ref());
    let peak = match margins {
        Some(margins) if !margins.stable => "unstable".to_owned(),
        margins => number(margins.and_then(|margins| margins.sensitivity_peak)),
    };
    vec![
        name.to_owned(),
        number(controller.map(|controller| controller.proportional_gain)),
        number(controller.and_then(|controller| controller.integral_time_s)),
        number(controller.and_then(|controller| controller.derivative_time_s)),
        number(controller.and_then(|controller| controller.observer_gain)),
        number(margins.and_then(|margins| margins.gain_margin)),
        number(margins.and_then(|margins| margins.phase_margin.map(Radians::degrees))),
        peak,
        number(margins.and_then(|margins| margins.delay_margin.map(|time| time.0))),
    ]
}

fn controllers(result: &StudyResult, console: Console) -> String {
    let mut rows = Vec::new();
    for controller in &result.controllers {
        rows.push(achieved(&controller.name, controller));
        if let Some(margins) = &controller.achieved_sampled {
            let sampled = ControllerResult { achieved: Some(margins.clone()), ..controller.clone() };
            rows.push(achieved(&format!("{}, sampled", controller.name), &sampled));
        }
    }
    table(console, &ACHIEVED, &rows)
}

fn members(family: &FamilyResult, console: Console) -> String {
    let heading =
        [family.vary.as_str(), "Kc", "Td [s]", "A_m", "φ_m [°]", "M_s", "2 % [s]", "over [%]", "IAE"];
    let rows = family.members.iter().map(|member| {
        let all = achieved(&number(member.value), &member.controller);
        let of_run = |index: usize| {
            member.run.as_ref().map_or_else(|| "–".to_owned(), |run| METRICS[index].1(&run.metrics))
        };
        let picked = [0, 1, 3, 5, 6, 7].map(|index| all[index].clone());
        picked.into_iter().chain([of_run(7), of_run(5), of_run(0)]).collect()
    });
    table(console, &heading, &rows.collect::<Vec<Vec<String>>>())
}

/// The responses of all controllers in one scenario, continuous and, where it was run so, sampled.
fn figure(
    process: &Process,
    result: &StudyResult,
    scenario: &ScenarioResult,
    points: usize,
) -> Result<Figure, Fault> {
    let mut runs = Vec::new();
    for row in scenario.rows.iter().filter(|_| !scenario.sampled.alone()) {
        let controller = result.controllers.iter().find(|controller| controller.name == row.controller);
        let Some(controller) = controller.and_then(|controller| controller.chosen.as_ref()) else { continue };
        let closed = ClosedLoop::new(process, controller);
        let times = plot_times(&closed, &scenario.scenario, points);
        let run = trajectory(&closed, &scenario.scenario, &times).map_err(Fault::input)?;
        runs.push((row.controller.clone(), run));
    }
    runs.extend(scenario.sampled.trajectories(&scenario.scenario, points).map_err(Fault::input)?);
    response_figure(&scenario.name, &scenario.scenario, &runs, false).map_err(Fault::input)
}

/// One line per scenario and controller, one column per metric.
fn csv(result: &StudyResult) -> Vec<u8> {
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let mut text = String::from("scenario,controller");
    for column in COLUMNS {
        text.push(',');
        text.push_str(column.name);
    }
    text.push('\n');
    for scenario in &result.scenarios {
        for (name, metrics) in scenario.rows.iter().flat_map(Row::lines) {
            let _ = write!(text, "{},{}", quoted(&scenario.name), quoted(&name));
            for column in COLUMNS {
                text.push(',');
                if let Some(value) = (column.value)(metrics) {
                    text.push_str(zmij::Buffer::new().format(value));
                }
            }
            text.push('\n');
        }
    }
    text.into_bytes()
}

/// The report page, with the judgement of the paper that the study recomputes.
fn report(study: &Study, result: &StudyResult) -> Result<Vec<u8>, Fault> {
    let reproduction = study.recomputes.as_deref().map(reproduce).transpose().map_err(Fault::input)?;
    let page = page_of(&study.process, result, reproduction.as_ref()).map_err(Fault::input)?;
    Ok(page.html().into_bytes())
}
