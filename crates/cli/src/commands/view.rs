//! What several commands show alike: a controller, its margins, its metrics, its response.

use std::path::Path;

use holdup::analysis::frequency::Margins;
use holdup::analysis::metrics::Metrics;
use holdup::analysis::response::{Scenario, Trajectory};
use holdup::model::{Controller, DerivativeFilter, Process, Radians};
use holdup::study::figures::{Axis, Figure, FigureError, Panel, Series, Tone, page, png, svg};

use crate::console::Console;
use crate::fault::Fault;
use crate::table::{number, percent, table};

/// The process in one line.
pub(crate) fn process_line(process: &Process) -> String {
    let lag = process.lag().map_or_else(String::new, |lag| format!(", lag {} s", number(lag)));
    let power = if process.integrators() == 1 { "/s" } else { "/s²" };
    format!(
        "process gain {} {power}, dead time {} s{lag}",
        number(process.process_gain()),
        number(process.dead_time())
    )
}

/// The controller in one line.
pub(crate) fn controller_line(controller: &Controller) -> String {
    if let Some(compensator) = controller.compensator() {
        let parameters = compensator.parameters().into_iter();
        let parts: Vec<String> =
            parameters.map(|(name, value)| format!("{name} = {}", number(value))).collect();
        return format!("{}: {}", compensator.structure(), parts.join(", "));
    }
    let mut parts =
        vec![format!("{}: Kc = {}", controller.structure(), number(controller.proportional_gain()))];
    let mut add = |name: &str, value: Option<f64>, unit: &str| {
        parts.extend(value.map(|value| format!("{name} = {}{unit}", number(value))));
    };
    add("Ti", controller.integral_time(), " s");
    add("Td", controller.derivative_time(), " s");
    match controller.derivative_filter() {
        Some(DerivativeFilter::Bandwidth(n)) => add("N", Some(n), " rad/s"),
        Some(DerivativeFilter::Time(tf)) => add("Tf", Some(tf), " s"),
        None => {}
    }
    if let Some(observer) = controller.observer() {
        add("Ko", Some(observer.gain()), "");
        add("Km", observer.model_gain(), " /s");
        add("dm", observer.model_dead_time(), " s");
    }
    let weight = |weight: f64| (weight != 1.0).then_some(weight);
    add("b", weight(controller.setpoint_weight()), "");
    add("c", weight(controller.derivative_setpoint_weight()), "");
    if let Some(filter) = controller.output_filter() {
        add("a1", Some(filter.a1), " s");
        add("a2", (filter.a2 != 0.0).then_some(filter.a2), " s²");
    }
    parts.join(", ")
}

/// Margins of several loops side by side.
pub(crate) fn margins_table(console: Console, columns: &[(&str, &Margins)]) -> String {
    type Pick = fn(&Margins) -> String;
    let rows: [(&str, Pick); 10] = [
        ("stable", |m| if m.stable { "yes" } else { "no" }.to_owned()),
        ("gain margin [–]", |m| number(m.gain_margin)),
        ("lower gain margin [–]", |m| number(m.gain_margin_low)),
        ("phase margin [°]", |m| number(m.phase_margin.map(Radians::degrees))),
        ("delay margin [s]", |m| number(m.delay_margin.map(|t| t.0))),
        ("sensitivity peak M_s [–]", |m| number(m.sensitivity_peak)),
        ("  at [rad/s]", |m| number(m.sensitivity_peak_frequency)),
        ("complementary peak M_t [–]", |m| number(m.complementary_sensitivity_peak)),
        ("gain crossovers [rad/s]", |m| several(&m.gain_crossovers)),
        ("phase crossovers [rad/s]", |m| several(&m.phase_crossovers)),
    ];
    let heading: Vec<&str> = std::iter::once("").chain(columns.iter().map(|(name, _)| *name)).collect();
    let rows: Vec<Vec<String>> = rows
        .iter()
        .map(|(name, pick)| {
            std::iter::once((*name).to_owned()).chain(columns.iter().map(|(_, m)| pick(m))).collect()
        })
        .collect();
    table(console, &heading, &rows)
}

/// The first three of a list.
fn several(values: &[f64]) -> String {
    let shown: Vec<String> = values.iter().take(3).map(|value| number(*value)).collect();
    match (shown.is_empty(), values.len() > 3) {
        (true, _) => "–".to_owned(),
        (false, true) => format!("{} …", shown.join(", ")),
        (false, false) => shown.join(", "),
    }
}

/// A metric for reading.
type Shown = fn(&Metrics) -> String;

/// Headings and cells of the time-domain metrics.
pub(crate) const METRICS: [(&str, Shown); 11] = [
    ("IAE", |m| number(m.iae)),
    ("ISE", |m| number(m.ise)),
    ("ITAE", |m| number(m.itae)),
    ("energy", |m| number(m.control_energy)),
    ("variation", |m| number(m.total_variation)),
    ("over [%]", |m| percent(m.overshoot)),
    ("rise [s]", |m| number(m.rise_time.map(|t| t.0))),
    ("2 % [s]", |m| number(m.settling_time.map(|t| t.0))),
    ("5 % [s]", |m| number(m.settling_time_5.map(|t| t.0))),
    ("peak", |m| number(m.peak)),
    ("travel", |m| number(m.valve_travel)),
];

/// The controlled and the manipulated variable of several runs of one scenario over time.
pub(crate) fn response_figure(
    title: &str,
    scenario: &Scenario,
    runs: &[(String, Trajectory)],
    with_input: bool,
) -> Result<Figure, FigureError> {
    let time = || Axis::linear("time [s]");
    let (times, setpoint) = staircase(scenario.setpoint(), scenario.initial(), scenario.horizon());
    let setpoint = Series::new("setpoint", times, setpoint)?.with_tone(Tone::Neutral).with_width(1.5)?;
    let mut output = Panel::new(time(), Axis::linear("controlled variable")).with_series(setpoint);
    let mut input = Panel::new(time(), Axis::linear("manipulated variable"));
    for (name, run) in runs {
        output = output.with_series(Series::new(name, run.time.clone(), run.controlled_variable.clone())?);
        input = input.with_series(Series::new(name, run.time.clone(), run.manipulated_variable.clone())?);
    }
    if !scenario.load().is_empty() {
        let (times, load) = staircase(scenario.load(), 0.0, scenario.horizon());
        input =
            input.with_series(Series::new("load", times, load)?.with_tone(Tone::Neutral).with_width(1.5)?);
    }
    Figure::new(title, if with_input { vec![output, input] } else { vec![output] })
}

/// The corners of a signal that is constant between its events.
pub(crate) fn staircase(events: &[(f64, f64)], before: f64, horizon: f64) -> (Vec<f64>, Vec<f64>) {
    let (mut times, mut values, mut value) = (vec![0.0], vec![before], before);
    for &(time, next) in events {
        times.extend([time, time]);
        values.extend([value, next]);
        value = next;
    }
    times.push(horizon);
    values.push(value);
    (times, values)
}

/// A figure as the bytes of the file that its name asks for.
pub(crate) fn figure_file(path: &Path, figure: &Figure) -> Result<Vec<u8>, Fault> {
    let kind = path.extension().and_then(|kind| kind.to_str()).unwrap_or_default().to_ascii_lowercase();
    match kind.as_str() {
        "svg" => Ok(svg::document(figure).into_bytes()),
        "png" => png::bytes(figure, 2.0).map_err(|error| Fault::option("--plot", error)),
        "html" => {
            let section = page::Section::new("Response").with_figure(figure.clone());
            Ok(page::Page::new(figure.title()).with_section(section).html().into_bytes())
        }
        _ => Err(unknown_kind(path)),
    }
}

/// Refuses a plot file of unknown kind before anything is computed.
pub(crate) fn check_kind(path: &Path) -> Result<(), Fault> {
    let kind = path.extension().and_then(|kind| kind.to_str()).unwrap_or_default().to_ascii_lowercase();
    if ["svg", "png", "html"].contains(&kind.as_str()) { Ok(()) } else { Err(unknown_kind(path)) }
}

fn unknown_kind(path: &Path) -> Fault {
    Fault::option(
        "--plot",
        format!("{} is no known kind of file: must end in .svg, .png or .html", path.display()),
    )
}
