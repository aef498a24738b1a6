//! `holdup optimise`: the best controller of a structure under limits; averaging level control.

use std::path::PathBuf;

use clap::Args;
use holdup::analysis::frequency::family::Family;
use holdup::model::description::ControllerDescription;
use holdup::model::quantity::{read_angle, read_number, read_time};
use holdup::model::{Controller, Process};
use holdup::study::figures::{Axis, Figure, FigureError, Mark, Panel, Series, Tone};
use holdup::tuning::optimise::level::{Averaging, Demand, averaging};
use holdup::tuning::optimise::{
    Limits, Objective, Optimum, Point, Quantity, Structure, optimise, trade_off_with,
};
use holdup::tuning::ranking::{ORDERS, rank};
use serde_json::{Value, json};

use super::view::{check_kind, controller_line, figure_file, margins_table, process_line};
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::input::process;
use crate::progress::Progress;
use crate::table::{number, table, title};

/// The sensitivity peaks of the frontier.
const PEAKS: [f64; 9] = [1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 2.0, 2.3];

/// The objectives by name.
const OBJECTIVES: &str = "load_iae, setpoint_iae, weighted_iae, load_ise, setpoint_ise, control_energy, total_variation, robust_box, averaging";

/// `holdup optimise`.
#[derive(Debug, Args)]
pub(crate) struct OptimiseArgs {
    /// The process: K=…,d=…[,T=…][,integrators=2]
    #[arg(short, long, value_name = "K=…,d=…")]
    pub(crate) process: Option<String>,
    /// The structure: p, pi, pi-b, pd, pid, pid-b, p+dob, pd+dob (-b: with setpoint weight)
    #[arg(long, value_name = "STRUCTURE", default_value = "pi")]
    pub(crate) structure: String,
    /// What is to be least: load_iae, setpoint_iae, weighted_iae, load_ise, setpoint_ise, control_energy,
    /// total_variation, robust_box, or averaging (the gentlest valve of a level)
    #[arg(long, value_name = "OBJECTIVE", default_value = "load_iae")]
    pub(crate) objective: String,
    /// Weight of the load in weighted_iae, 0 to 1; the setpoint has the rest
    #[arg(long, value_name = "WEIGHT", default_value = "0.5", allow_hyphen_values = true)]
    pub(crate) load_weight: String,
    /// Greatest sensitivity peak
    #[arg(long, value_name = "M_s", allow_hyphen_values = true)]
    pub(crate) max_sensitivity: Option<String>,
    /// Greatest complementary sensitivity peak
    #[arg(long, value_name = "M_t", allow_hyphen_values = true)]
    pub(crate) max_complementary: Option<String>,
    /// Least gain margin
    #[arg(long, value_name = "A_m", allow_hyphen_values = true)]
    pub(crate) min_gain_margin: Option<String>,
    /// Least phase margin, in degrees or with its unit
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub(crate) min_phase_margin: Option<String>,
    /// Least delay margin
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) min_delay_margin: Option<String>,
    /// Greatest gain from measurement to controller output at high frequency; makes the filter time a free setting
    #[arg(long, value_name = "GAIN", allow_hyphen_values = true)]
    pub(crate) max_noise_gain: Option<String>,
    /// Greatest IAE after a unit load step
    #[arg(long, value_name = "IAE", allow_hyphen_values = true)]
    pub(crate) max_load_iae: Option<String>,
    /// Greatest IAE after a unit setpoint step
    #[arg(long, value_name = "IAE", allow_hyphen_values = true)]
    pub(crate) max_setpoint_iae: Option<String>,
    /// With robust_box: the shape of the box, half its width in gain and in dead time; the largest multiple that keeps
    /// --max-sensitivity is looked for
    #[arg(long, value_name = "GAIN:DEAD_TIME", default_value = "0.2:0.2", allow_hyphen_values = true)]
    pub(crate) robust_box: String,
    /// With averaging: the largest step of the load, in input units
    #[arg(long, value_name = "STEP", allow_hyphen_values = true)]
    pub(crate) load_step: Option<String>,
    /// With averaging: how far the level may move
    #[arg(long, value_name = "EXCURSION", allow_hyphen_values = true)]
    pub(crate) excursion: Option<String>,
    /// Give also the best value for other sensitivity peaks
    #[arg(long)]
    pub(crate) trade_off: bool,
    /// Write a picture of that frontier, with the rules on it: .svg, .png or .html
    #[arg(long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
}

/// Searches.
pub(crate) fn run(args: &OptimiseArgs, console: Console) -> Result<Answer, Fault> {
    args.plot.as_deref().map_or(Ok(()), check_kind)?;
    let process = process(args.process.as_ref())?;
    if args.objective == "averaging" {
        return level(args, &process, console);
    }
    for (option, given) in [("--load-step", &args.load_step), ("--excursion", &args.excursion)] {
        if given.is_some() {
            return Err(Fault::option(option, "must stand with --objective averaging"));
        }
    }
    let structure = Structure::named(&args.structure).ok_or_else(|| {
        let known: Vec<&str> = Structure::names().collect();
        Fault::option("--structure", format!("'{}' must be one of {}", args.structure, known.join(", ")))
    })?;
    let limits = limits(args)?;
    let objective = objective(args, &limits)?;
    // What is spent on the box is not a limit on the nominal loop.
    let limits = match objective {
        Objective::RobustBox { .. } => limits.without(Quantity::SensitivityPeak),
        _ => limits,
    };
    let with_frontier = args.trade_off || args.plot.is_some();
    let progress = Progress::without_end("optima", 1 + if with_frontier { PEAKS.len() as u64 } else { 0 });
    let best = optimise(&process, structure, objective, &limits).map_err(Fault::input)?;
    progress.add(1);
    let frontier = if with_frontier {
        let limits = limits.clone().without(Quantity::SensitivityPeak);
        let mut each = || progress.add(1);
        let points = trade_off_with(&process, structure, objective, &limits, &PEAKS, &mut each);
        Some(points.map_err(Fault::input)?)
    } else {
        None
    };
    progress.end();
    let mut files = Vec::new();
    if let (Some(path), Some(points)) = (&args.plot, &frontier) {
        let figure = figure(&process, structure, objective, points).map_err(Fault::input)?;
        files.push((path.clone(), figure_file(path, &figure)?));
    }
    let warnings = warnings(&best);
    let json = json!({
        "rule": null,
        "controller": ControllerDescription::from(&best.controller),
        "specification": specification(&limits),
        "achieved": &best.achieved,
        "objective": {"name": objective.name(), "value": best.value},
        "constraint": limits.list().iter().map(ToString::to_string).collect::<Vec<_>>(),
        "load": best.load,
        "setpoint": best.setpoint,
        "noise_gain": best.controller.noise_gain(),
        "search": {
            "starts": best.starts, "agreeing": best.agreeing,
            "swept": best.swept, "least_swept": best.least_swept,
        },
        "trade_off": frontier.as_ref().map(|points| points.iter().map(point_json).collect::<Vec<_>>()),
        "warnings": warnings,
    });
    let mut text = String::new();
    if !console.json {
        text = told(&process, &best, objective, &limits, console);
        if let Some(points) = &frontier {
            text += &format!("\n{}", frontier_table(points, objective, console));
        }
    }
    Ok(Answer { json, text, warnings, files })
}

fn limits(args: &OptimiseArgs) -> Result<Limits, Fault> {
    let degrees = |option: &str, text: &str| match text.parse::<f64>() {
        Ok(_) => read_number(option, text).map(f64::to_radians),
        Err(_) => read_angle(option, text),
    };
    let mut limits = Limits::default();
    let options: [(&str, &Option<String>, Quantity, f64); 8] = [
        ("--max-sensitivity", &args.max_sensitivity, Quantity::SensitivityPeak, 1.0),
        ("--max-complementary", &args.max_complementary, Quantity::ComplementarySensitivityPeak, 1.0),
        ("--min-gain-margin", &args.min_gain_margin, Quantity::GainMargin, 1.0),
        ("--min-phase-margin", &args.min_phase_margin, Quantity::PhaseMargin, 0.0),
        ("--min-delay-margin", &args.min_delay_margin, Quantity::DelayMargin, 0.0),
        ("--max-noise-gain", &args.max_noise_gain, Quantity::NoiseGain, 0.0),
        ("--max-load-iae", &args.max_load_iae, Quantity::LoadIae, 0.0),
        ("--max-setpoint-iae", &args.max_setpoint_iae, Quantity::SetpointIae, 0.0),
    ];
    for (option, given, quantity, above) in options {
        let Some(text) = given else { continue };
        let value = match quantity {
            Quantity::PhaseMargin => degrees(option, text),
            Quantity::DelayMargin => read_time(option, text),
            _ => read_number(option, text),
        };
        let value = value.map_err(Fault::input)?;
        if value <= above {
            return Err(Fault::option(option, format!("{text} must be greater than {above}")));
        }
        limits = limits.with(quantity, value);
    }
    Ok(limits)
}

fn objective(args: &OptimiseArgs, limits: &Limits) -> Result<Objective, Fault> {
    Ok(match args.objective.replace('-', "_").as_str() {
        "load_iae" => Objective::LoadIae,
        "setpoint_iae" => Objective::SetpointIae,
        "load_ise" => Objective::LoadIse,
        "setpoint_ise" => Objective::SetpointIse,
        "control_energy" => Objective::ControlEnergy,
        "total_variation" => Objective::TotalVariation,
        "weighted_iae" => {
            let load = read_number("--load-weight", &args.load_weight).map_err(Fault::input)?;
            if !(0.0..=1.0).contains(&load) {
                let message = format!("{} must be from 0 to 1", args.load_weight);
                return Err(Fault::option("--load-weight", message));
            }
            Objective::Weighted { load }
        }
        "robust_box" => {
            let wrong = || {
                let message =
                    format!("'{}' must be two half widths such as 0.2:0.2, each 0 to 1", args.robust_box);
                Fault::option("--robust-box", message)
            };
            let (gain, dead_time) = args.robust_box.split_once(':').ok_or_else(wrong)?;
            let half = |text: &str| read_number("--robust-box", text).map_err(Fault::input);
            let (gain, dead_time) = (half(gain)?, half(dead_time)?);
            let family = Family::ranges([1.0 - gain, 1.0 + gain], [1.0 - dead_time, 1.0 + dead_time]);
            let family = family.map_err(|_| wrong())?;
            let sensitivity_peak = limits.of(Quantity::SensitivityPeak).ok_or_else(|| {
                Fault::option("--objective", "robust_box needs --max-sensitivity, which the box is to keep")
            })?;
            Objective::RobustBox { family, sensitivity_peak }
        }
        _ => {
            let message = format!("'{}' must be one of {OBJECTIVES}", args.objective);
            return Err(Fault::option("--objective", message));
        }
    })
}

fn specification(limits: &Limits) -> Value {
    let map = limits
        .list()
        .iter()
        .map(|limit| (limit.quantity.name().to_owned(), json!(limit.quantity.shown(limit.value))));
    Value::Object(map.collect())
}

fn warnings(best: &Optimum) -> Vec<String> {
    let mut sentences = Vec::new();
    if best.starts > 1 && best.agreeing < 2 {
        sentences
            .push(format!("Only one of {} starts found this optimum: a better one may exist.", best.starts));
    }
    for integrals in best.load.iter().chain(&best.setpoint) {
        sentences.extend(integrals.warnings.iter().cloned());
    }
    if best.controller.derivative_time().is_some() && best.controller.derivative_filter().is_none() {
        sentences.push(
            "The derivative action is unfiltered: --max-noise-gain makes the filter a part of the design."
                .to_owned(),
        );
    }
    sentences
}

fn told(
    process: &Process,
    best: &Optimum,
    objective: Objective,
    limits: &Limits,
    console: Console,
) -> String {
    let constraint: Vec<String> = limits.list().iter().map(ToString::to_string).collect();
    let mut text = format!("{}\non {}\n\n", controller_line(&best.controller), process_line(process));
    let under = if constraint.is_empty() { "no limit".to_owned() } else { constraint.join(", ") };
    text += &format!("Least {} = {} under {under}\n", objective.name(), number(best.value));
    if let Objective::RobustBox { .. } = objective {
        text += &format!("        the box is {} times the shape\n", number(1.0 / best.value));
    }
    text += &format!(
        "Shown:  {} of {} starts agree; a sweep of {} designs, each with its best gain,\n        met {}\n\n",
        best.agreeing,
        best.starts,
        best.swept,
        number(best.least_swept)
    );
    text += &margins_table(console, &[("achieved", &best.achieved)]);
    let iae = |integrals: Option<f64>| number(integrals);
    text += &format!(
        " load IAE               {}\n setpoint IAE           {}\n",
        iae(best.load.as_ref().and_then(|load| load.iae)),
        iae(best.setpoint.as_ref().and_then(|setpoint| setpoint.iae))
    );
    text
}

fn point_json(point: &Point) -> Value {
    json!({
        "sensitivity_peak": point.sensitivity_peak,
        "value": point.value,
        "controller": ControllerDescription::from(&point.controller),
    })
}

fn frontier_table(points: &[Point], objective: Objective, console: Console) -> String {
    let rows: Vec<Vec<String>> = points
        .iter()
        .map(|point| {
            let setting = |value: Option<f64>| number(value);
            vec![
                number(point.sensitivity_peak),
                number(point.value),
                number(point.controller.proportional_gain()),
                setting(point.controller.integral_time()),
                setting(point.controller.derivative_time()),
                setting(point.controller.observer().map(|observer| observer.gain())),
            ]
        })
        .collect();
    title(console, "What robustness costs")
        + &table(console, &["M_s", objective.name(), "Kc", "Ti [s]", "Td [s]", "Ko"], &rows)
}

/// The frontier, and on it the rules of the same structure where the objective is one of the two IAE.
fn figure(
    process: &Process,
    structure: Structure,
    objective: Objective,
    points: &[Point],
) -> Result<Figure, FigureError> {
    let (x, y) = points.iter().map(|point| (point.sensitivity_peak, point.value)).unzip();
    let mut panel = Panel::new(Axis::linear("sensitivity peak M_s"), Axis::logarithmic(in_words(objective)));
    let name = format!("best {}", structure.name().to_uppercase());
    panel = panel.with_series(Series::new(name, x, y)?.with_tone(Tone::Slot(0)));
    let ranked = rank(process, &ORDERS[0], |entry| entry.structure.eq_ignore_ascii_case(structure.name()));
    let (mut peaks, mut values, mut names) = (Vec::new(), Vec::new(), Vec::new());
    let greatest = PEAKS[PEAKS.len() - 1];
    for rule in &ranked.rules {
        // The rules are drawn where the ranking has the value of the objective.
        let value = match objective {
            Objective::LoadIae => rule.load_iae(),
            Objective::SetpointIae => rule.setpoint_iae(),
            _ => None,
        };
        let (Some(value), Some(peak)) = (value, rule.achieved.sensitivity_peak) else { continue };
        if peak <= greatest {
            peaks.push(peak);
            values.push(value);
            names.push(rule.entry.id.to_owned());
        }
    }
    if !peaks.is_empty() {
        let rules = Series::new("published rules", peaks, values)?.with_labels(&names)?;
        panel = panel.with_series(rules.as_marks(Mark::Disc).with_tone(Tone::Slot(1)));
    }
    Figure::new("What robustness costs", vec![panel])
}

/// The objective as the label of an axis.
fn in_words(objective: Objective) -> String {
    let name = objective.name().replace('_', " ").replace("iae", "IAE").replace("ise", "ISE");
    let unit = match objective {
        Objective::LoadIse | Objective::SetpointIse => " [output unit² · s]",
        Objective::ControlEnergy => " [input unit² · s]",
        Objective::TotalVariation => " [input unit]",
        Objective::LoadIae | Objective::SetpointIae | Objective::Weighted { .. } => " [output unit · s]",
        _ => "",
    };
    name + unit
}

fn level(args: &OptimiseArgs, process: &Process, console: Console) -> Result<Answer, Fault> {
    let needed = |option: &str, given: &Option<String>| match given {
        Some(text) => read_number(option, text).map_err(Fault::input),
        None => Err(Fault::option("--objective", format!("averaging needs {option}"))),
    };
    let demand = Demand {
        load_step: needed("--load-step", &args.load_step)?,
        excursion: needed("--excursion", &args.excursion)?,
        sensitivity_peak: match &args.max_sensitivity {
            Some(text) => read_number("--max-sensitivity", text).map_err(Fault::input)?,
            None => 2.0,
        },
    };
    let found = averaging(process, &demand).map_err(Fault::input)?;
    let json = json!({
        "rule": null,
        "controller": ControllerDescription::from(&found.controller),
        "specification": {
            "load_step": demand.load_step, "excursion": demand.excursion, "sensitivity_peak": demand.sensitivity_peak,
        },
        "achieved": &found.achieved,
        "objective": {"name": "valve_rate", "value": found.rate},
        "constraint": [format!("excursion <= {}", demand.excursion)],
        "excursion": found.excursion,
        "bounds": {"valve_rate": found.least_rate},
        "percent_of_best": {"valve_rate": 100.0 * found.rate / found.least_rate},
        "proportional": found.proportional.as_ref().map(|(controller, rate)| json!({
            "controller": ControllerDescription::from(controller), "valve_rate": rate,
        })),
        "warnings": [],
    });
    let text = if console.json { String::new() } else { told_level(process, &demand, &found, console) };
    Ok(Answer { json, text, ..Answer::default() })
}

fn told_level(process: &Process, demand: &Demand, found: &Averaging, console: Console) -> String {
    let mut text = format!("{}\non {}\n\n", controller_line(&found.controller), process_line(process));
    text += &format!(
        "After a load step of {} the level moves by {}, {} allowed\n\n",
        number(demand.load_step),
        number(found.excursion),
        number(demand.excursion)
    );
    let row = |name: &str, controller: Option<&Controller>, rate: f64| {
        vec![
            name.to_owned(),
            number(rate),
            number(100.0 * rate / found.least_rate),
            number(controller.map(Controller::proportional_gain)),
            number(controller.and_then(Controller::integral_time)),
        ]
    };
    let mut rows = vec![row("PI", Some(&found.controller), found.rate)];
    if let Some((controller, rate)) = &found.proportional {
        rows.push(row("P alone, leaves an error", Some(controller), *rate));
    }
    rows.push(row("best possible", None, found.least_rate));
    text += &table(console, &["", "greatest rate [1/s]", "% of best", "Kc", "Ti [s]"], &rows);
    text + "\n" + &margins_table(console, &[("PI", &found.achieved)])
}
