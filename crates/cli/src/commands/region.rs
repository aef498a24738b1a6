//! `holdup region`: where a loop is stable in a plane of two settings, and where its robustness is constant.

use holdup::analysis::frequency::region::{Constant, Plane, Region, Vertex, Window, region};
use holdup::model::notation::read_controller;
use holdup::model::quantity::read_number;
use holdup::model::{Controller, Process};
use holdup::study::figures::{Axis, Figure, FigureError, Line, Panel, Series, Tone, terminal};

use super::view::{check_kind, figure_file, process_line};
use crate::args::RegionArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::input::process;
use crate::table::{number, table, title};

/// The planes by name, with the heading of their second setting.
const PLANES: [(&str, Plane, &str); 3] = [
    ("kc-ti", Plane::KcTi, "integral time Ti [s]"),
    ("kc-td", Plane::KcTd, "derivative time Td [s]"),
    ("kc-ko", Plane::KcKo, "observer gain Ko"),
];

/// Computes the region.
pub(crate) fn run(args: &RegionArgs, console: Console) -> Result<Answer, Fault> {
    args.plot.as_deref().map_or(Ok(()), check_kind)?;
    let process = process(args.process.as_ref())?;
    let controller = match &args.controller {
        Some(text) => read_controller(text).map_err(|error| Fault::option("--controller", error))?,
        None => Controller::proportional(process.process_gain().signum()).map_err(Fault::input)?,
    };
    let (_, plane, heading) = *PLANES.iter().find(|(name, ..)| *name == args.plane).ok_or_else(|| {
        let known = PLANES.map(|(name, ..)| name).join(", ");
        Fault::option("--plane", format!("'{}' must be one of {known}", args.plane))
    })?;
    let window = window(args, &process, plane)?;
    let levels = levels(args)?;
    let found = region(&process, &controller, plane, window, &levels).map_err(Fault::input)?;
    let figure = figure(&found, heading).map_err(Fault::input)?;
    let mut files = Vec::new();
    if let Some(path) = &args.plot {
        files.push((path.clone(), figure_file(path, &figure)?));
    }
    let json = serde_json::to_value(&found).map_err(Fault::input)?;
    let text = if console.json { String::new() } else { text(&process, &found, &figure, console) };
    Ok(Answer { json, text, files, ..Answer::default() })
}

/// The window of the options; without them one that holds the region of the plain integrator.
fn window(args: &RegionArgs, process: &Process, plane: Plane) -> Result<Window, Fault> {
    let dead_time = process.dead_time();
    let integrators = i32::from(process.integrators());
    let gain = 1.8 / (process.process_gain().abs() * dead_time.powi(integrators));
    let other = match plane {
        Plane::KcTi => 20.0 * dead_time,
        Plane::KcTd => 1.5 * dead_time,
        Plane::KcKo => gain,
    };
    let of = |option: &str, given: &Option<String>, default: f64| match given {
        Some(text) => read_number(option, text).map_err(Fault::input),
        None => Ok(default),
    };
    let proportional_gain = of("--max-gain", &args.max_gain, gain)?;
    Ok(Window { proportional_gain, other: of("--max-other", &args.max_other, other)? })
}

fn levels(args: &RegionArgs) -> Result<Vec<Constant>, Fault> {
    let mut levels = Vec::new();
    let mut read = |option: &str, given: &Option<String>, constant: fn(f64) -> Constant| {
        for text in given.iter().flat_map(|list| list.split(',')) {
            levels.push(constant(read_number(option, text).map_err(Fault::input)?));
        }
        Ok(())
    };
    read("--sensitivity", &args.sensitivity, Constant::SensitivityPeak)?;
    read("--gain-margin", &args.gain_margin, Constant::GainMargin)?;
    read("--phase-margin", &args.phase_margin, |degrees| Constant::PhaseMargin(degrees.to_radians()))?;
    Ok(levels)
}

fn name(constant: Constant) -> String {
    match constant {
        Constant::SensitivityPeak(value) => format!("M_s = {}", number(value)),
        Constant::GainMargin(value) => format!("gain margin {}", number(value)),
        Constant::PhaseMargin(value) => format!("phase margin {}°", number(value.to_degrees())),
    }
}

fn figure(region: &Region, heading: &str) -> Result<Figure, FigureError> {
    let mut panel = Panel::new(Axis::linear("proportional gain Kc"), Axis::linear(heading));
    let series = |label: &str, vertices: &[Vertex]| {
        let (x, y) = vertices.iter().map(|vertex| (vertex.x, vertex.y)).unzip();
        Series::new(label, x, y)
    };
    for curve in &region.boundary {
        let boundary = series("limit of stability", &curve.vertices)?;
        panel = panel.with_series(boundary.with_tone(Tone::Neutral).with_line(Line::Solid).with_width(2.5)?);
    }
    for (slot, level) in region.levels.iter().enumerate() {
        for curve in &level.curves {
            panel = panel.with_series(series(&name(level.constant), curve)?.with_tone(Tone::Slot(slot)));
        }
    }
    Figure::new("Stability region and curves of constant robustness", vec![panel])
}

fn text(process: &Process, region: &Region, figure: &Figure, console: Console) -> String {
    let mut text = title(console, &format!("Stability region of {}", process_line(process)));
    let row =
        |name: String, curves: usize, vertices: usize| vec![name, curves.to_string(), vertices.to_string()];
    let boundary = region.boundary.iter().map(|curve| curve.vertices.len()).sum();
    let mut rows = vec![row("limit of stability".to_owned(), region.boundary.len(), boundary)];
    for level in &region.levels {
        let vertices = level.curves.iter().map(Vec::len).sum();
        rows.push(row(name(level.constant), level.curves.len(), vertices));
    }
    text += &table(console, &["", "curves", "vertices"], &rows);
    text += "\nThe vertices are in --json, the picture in --plot.\n\n";
    text + &terminal::chart(figure, console.width, console.colour)
}
