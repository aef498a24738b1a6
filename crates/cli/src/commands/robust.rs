//! `holdup robust`: what a loop keeps over a family of processes, proven, and Monte Carlo beside it.

use std::ops::ControlFlow;
use std::path::PathBuf;

use clap::Args;
use holdup::analysis::frequency::family::{Family, Goal, Member, WorstCase, worst_case};
use holdup::analysis::response::plot_times;
use holdup::model::quantity::read_number;
use holdup::model::{ClosedLoop, Process};
use holdup::study::figures::{Axis, Figure, FigureError, Line, Panel, Series, Tone};
use holdup::study::runs::RunsFile;
use holdup::tuning::robust::{
    Distribution, Draws, Largest, MonteCarlo, Percentiles, Summary, largest_family,
};
use serde_json::{Map, Value, json};

use super::view::{check_kind, controller_line, figure_file, process_line};
use crate::args::{LoopArgs, ScenarioArgs};
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::input::{closed_loop, scenario};
use crate::progress::Progress;
use crate::table::{number, table, title};

/// Times of a response band.
const BAND_POINTS: usize = 401;
/// The greatest number of samples.
const MOST: f64 = 1e9;

/// `holdup robust`.
#[derive(Debug, Args)]
pub(crate) struct RobustArgs {
    /// The loop.
    #[command(flatten)]
    pub(crate) of: LoopArgs,
    /// Range of the factor on the process gain
    #[arg(long, value_name = "LOW:HIGH", default_value = "0.8:1.2", allow_hyphen_values = true)]
    pub(crate) gain: String,
    /// Range of the factor on the dead time
    #[arg(long, value_name = "LOW:HIGH", default_value = "0.8:1.2", allow_hyphen_values = true)]
    pub(crate) dead_time: String,
    /// The family is the ellipse within these ranges, which must lie symmetrically about 1, with this correlation
    /// of gain and dead time: the confidence region of an identified model
    #[arg(long, value_name = "CORRELATION", allow_hyphen_values = true)]
    pub(crate) ellipse: Option<String>,
    /// Give also the largest family of this shape that is proven to keep this sensitivity peak
    #[arg(long, value_name = "M_s", allow_hyphen_values = true)]
    pub(crate) max_sensitivity: Option<String>,
    /// Number of random processes
    #[arg(long, value_name = "NUMBER", default_value = "10000", allow_hyphen_values = true)]
    pub(crate) samples: String,
    /// Seed of the random processes
    #[arg(long, value_name = "NUMBER", default_value = "1")]
    pub(crate) seed: u64,
    /// How the factors are distributed: uniform, log-uniform, triangular or normal (range = ±2 deviations)
    #[arg(long, value_name = "NAME", default_value = "uniform")]
    pub(crate) distribution: String,
    /// Write every run to this file: .csv or .parquet; it is complete also where a --require is not met
    #[arg(long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Give percentiles of the response over time
    #[arg(long)]
    pub(crate) bands: bool,
    /// Write a picture of these bands: .svg, .png or .html
    #[arg(long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
    /// What happens to each loop; without it only margins are sampled.
    #[command(flatten)]
    pub(crate) scenario: ScenarioArgs,
}

/// Proves, then samples.
pub(crate) fn run(args: &RobustArgs, console: Console) -> Result<Answer, Fault> {
    let (process, controller) = closed_loop(&args.of)?;
    let family = family(args)?;
    args.plot.as_deref().map_or(Ok(()), check_kind)?;
    let samples = samples(&args.samples)?;
    let distribution =
        Distribution::named(&args.distribution).map_err(|error| Fault::option("--distribution", error))?;
    let limit = match &args.max_sensitivity {
        Some(text) => Some(peak(text)?),
        None => None,
    };
    let bands = args.bands || args.plot.is_some();
    let given =
        [&args.scenario.setpoint, &args.scenario.load, &args.scenario.horizon, &args.scenario.initial];
    let scenario = (bands || given.iter().any(|option| option.is_some()))
        .then(|| scenario(&args.scenario, &process))
        .transpose()?;
    let times = match (&scenario, bands) {
        (Some(scenario), true) => plot_times(&ClosedLoop::new(&process, &controller), scenario, BAND_POINTS),
        _ => Vec::new(),
    };
    let worst = worst_case(&process, &controller, &family, Goal::Worst).map_err(Fault::input)?;
    let largest = match limit {
        Some(limit) => largest_family(&process, &controller, &family, limit).map_err(Fault::input)?,
        None => None,
    };
    let mut warnings = Vec::new();
    let draws = Draws::new(family, distribution, args.seed);
    let carlo =
        MonteCarlo { process, controller, draws, samples, scenario: scenario.as_ref(), times: &times };
    let summary = sample(&carlo, args, &mut warnings)?;
    warnings.extend(sentences(&worst, limit, largest.as_ref()));
    let mut files = Vec::new();
    if let Some(path) = &args.plot {
        let figure = figure(&times, &summary).map_err(Fault::input)?;
        files.push((path.clone(), figure_file(path, &figure)?));
    }
    let json = json!({
        "guaranteed": guaranteed(&process, &worst),
        "largest_family": largest.map(|largest| json!({
            "sensitivity_peak": limit,
            "size": largest.size,
            "gain": largest.family.gain(),
            "dead_time": largest.family.dead_time(),
        })),
        "monte_carlo": monte_carlo(args, &summary, &times),
        "warnings": warnings,
    });
    let mut text = String::new();
    if !console.json {
        text = format!("{}\non {}\n\n", controller_line(&controller), process_line(&process));
        text += &proof(&process, &family, args.ellipse.is_some(), &worst);
        if let (Some(limit), Some(largest)) = (limit, largest) {
            text += &format!(
                "Largest family with M_s <= {}: gain {}, dead time {}\n",
                number(limit),
                range(largest.family.gain()),
                range(largest.family.dead_time())
            );
        }
        text += &format!("\n{}", sampled(console, &summary));
    }
    Ok(Answer { json, text, warnings, files })
}

fn family(args: &RobustArgs) -> Result<Family, Fault> {
    let gain = two("--gain", &args.gain)?;
    let dead_time = two("--dead-time", &args.dead_time)?;
    let Some(correlation) = &args.ellipse else {
        return Family::ranges(gain, dead_time).map_err(Fault::input);
    };
    let correlation = read_number("--ellipse", correlation).map_err(Fault::input)?;
    let half = |option: &str, [low, high]: [f64; 2]| {
        // Half a unit of the ninth digit: what someone writes for symmetric ranges.
        if (low + high - 2.0).abs() > 1e-9 {
            let message = format!("{low}:{high} must lie symmetrically about 1 with --ellipse, as 0.8:1.2");
            return Err(Fault::option(option, message));
        }
        Ok(0.5 * (high - low))
    };
    Family::ellipse(half("--gain", gain)?, half("--dead-time", dead_time)?, correlation)
        .map_err(|error| Fault::option("--ellipse", error))
}

fn two(option: &str, text: &str) -> Result<[f64; 2], Fault> {
    let (low, high) = text.split_once(':').ok_or_else(|| {
        Fault::option(option, format!("'{text}' must be a range of factors such as 0.8:1.2"))
    })?;
    let read = |text: &str| read_number(option, text).map_err(Fault::input);
    let range = [read(low)?, read(high)?];
    if range[0] > 0.0 && range[0] <= range[1] {
        return Ok(range);
    }
    Err(Fault::option(option, format!("{text} must be two factors LOW:HIGH with 0 < LOW <= HIGH")))
}

fn samples(text: &str) -> Result<u64, Fault> {
    let value = read_number("--samples", text).map_err(Fault::input)?;
    if !(1.0..=MOST).contains(&value) || value.fract() != 0.0 {
        return Err(Fault::option("--samples", format!("{text} must be a whole number from 1 to 1e9")));
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked above")]
    Ok(value as u64)
}

fn peak(text: &str) -> Result<f64, Fault> {
    let value = read_number("--max-sensitivity", text).map_err(Fault::input)?;
    if value > 1.0 {
        return Ok(value);
    }
    Err(Fault::option("--max-sensitivity", format!("{text} must be greater than 1")))
}

/// Samples with progress; Ctrl-C ends it and keeps what is done.
fn sample(carlo: &MonteCarlo<'_>, args: &RobustArgs, warnings: &mut Vec<String>) -> Result<Summary, Fault> {
    let progress = Progress::start("processes", carlo.samples);
    let (mut file, mut failed) = (None, None);
    if let Some(path) = &args.output {
        file = Some(RunsFile::create(path).map_err(|error| Fault::file(path, "write", &error))?);
    }
    let summary = carlo.run(|runs| {
        if let Some(error) = file.as_mut().and_then(|file| file.append(runs).err()) {
            failed = Some(error);
            return ControlFlow::Break(());
        }
        progress.add(runs.len() as u64);
        if progress.interrupted() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    progress.end();
    let summary = summary.map_err(Fault::input)?;
    if let Some(path) = &args.output {
        let finished = failed.map_or_else(|| file.map_or(Ok(()), RunsFile::finish), Err);
        finished.map_err(|error| Fault::file(path, "write", &error))?;
    }
    if summary.samples < carlo.samples {
        warnings.push(format!(
            "Interrupted: {} of {} processes are computed, and all that is given here is of those.",
            summary.samples, carlo.samples
        ));
    }
    if summary.without_response > 0 {
        let of = summary.without_response;
        warnings.push(format!("The response of {of} stable loops is out of reach: they have margins alone."));
    }
    Ok(summary)
}

fn sentences(worst: &WorstCase, limit: Option<f64>, largest: Option<&Largest>) -> Vec<String> {
    let mut sentences = Vec::new();
    if worst.given_up {
        sentences.push("The proof was given up: the family is not proven stable, nor unstable.".to_owned());
    } else if !worst.stable {
        sentences.push("Not every process of the family is stable.".to_owned());
    }
    match (limit, largest) {
        (Some(limit), None) => sentences
            .push(format!("There is no family with M_s <= {limit}: the nominal loop itself exceeds it.")),
        (Some(limit), Some(largest)) if largest.limited_by_zero => {
            sentences.push(format!("M_s <= {limit} does not limit the family: it ends where a factor is 0."));
        }
        _ => {}
    }
    sentences
}

fn member(process: &Process, member: &Member) -> Value {
    json!({
        "gain_factor": member.gain,
        "dead_time_factor": member.dead_time,
        "process_gain": process.process_gain() * member.gain,
        "dead_time_s": process.dead_time() * member.dead_time,
        "frequency_rad_s": member.frequency,
        "sensitivity": Some(member.sensitivity).filter(|value| value.is_finite()),
    })
}

fn guaranteed(process: &Process, worst: &WorstCase) -> Value {
    json!({
        "stable": worst.stable,
        "sensitivity_peak": worst.sensitivity_peak,
        "worst": worst.worst.map(|worst| member(process, &worst)),
        "bands_examined": worst.bands,
        "given_up": worst.given_up,
    })
}

fn monte_carlo(args: &RobustArgs, summary: &Summary, times: &[f64]) -> Value {
    let values = |list: &Percentiles| -> Value {
        let mut map = Map::new();
        map.insert("count".to_owned(), json!(list.count));
        map.extend(list.values.iter().map(|(name, value)| ((*name).to_owned(), json!(value))));
        Value::Object(map)
    };
    let percentiles: Map<String, Value> =
        summary.percentiles.iter().map(|list| (list.name.to_owned(), values(list))).collect();
    let band = |index: usize| summary.bands.iter().map(|band| band[index]).collect::<Vec<_>>();
    json!({
        "samples": summary.samples,
        "seed": args.seed,
        "distribution": args.distribution,
        "stable_fraction": summary.stable_fraction,
        "stable_fraction_interval": summary.stable_fraction_interval,
        "percentiles": percentiles,
        "bands": (!summary.bands.is_empty()).then(|| json!({
            "time_s": times,
            "p5": band(0), "p25": band(1), "p50": band(2), "p75": band(3), "p95": band(4),
        })),
    })
}

/// A proven upper bound for reading: four significant digits, never below the bound.
fn bound(value: f64) -> String {
    let unit = 10.0_f64.powf(value.log10().floor() - 3.0);
    number((value / unit).ceil() * unit)
}

fn range([low, high]: [f64; 2]) -> String {
    format!("{} to {}", number(low), number(high))
}

fn proof(process: &Process, family: &Family, ellipse: bool, worst: &WorstCase) -> String {
    let shape = if ellipse { "ellipse within" } else { "all of" };
    let over = format!("gain x {}, dead time x {}", range(family.gain()), range(family.dead_time()));
    let mut text = match worst.sensitivity_peak {
        Some(peak) => format!("Proven: stable, and M_s <= {} over {shape}\n        {over}\n", bound(peak)),
        None if worst.given_up => format!("Not proven, over {shape}\n        {over}\n"),
        None => format!("Not stable over {shape}\n        {over}\n"),
    };
    if let Some(worst) = &worst.worst {
        let at = worst.frequency.map_or_else(
            || "at infinite frequency".to_owned(),
            |frequency| format!("at {} rad/s", number(frequency)),
        );
        text += &format!(
            "Worst:  K = {}, d = {} s (x {} and x {}), |S| = {} {at}\n",
            number(process.process_gain() * worst.gain),
            number(process.dead_time() * worst.dead_time),
            number(worst.gain),
            number(worst.dead_time),
            number(Some(worst.sensitivity).filter(|value| value.is_finite()))
        );
    }
    text
}

fn sampled(console: Console, summary: &Summary) -> String {
    let [low, high] = summary.stable_fraction_interval;
    let mut text = title(
        console,
        &format!(
            "{} random processes, {} % stable (95 %: {} to {} %)",
            summary.samples,
            number(100.0 * summary.stable_fraction),
            number(100.0 * low),
            number(100.0 * high)
        ),
    );
    let shown = ["least", "p5", "p50", "p95", "greatest"];
    let heading: Vec<&str> = std::iter::once("").chain(shown).collect();
    let rows = summary.percentiles.iter().filter(|list| list.count > 0).map(|list| {
        let value =
            |name: &str| list.values.iter().find(|(known, _)| *known == name).map(|(_, value)| *value);
        let unit = [("_deg", " [°]"), ("_s", " [s]")];
        let named = unit.iter().find_map(|(ending, unit)| Some((list.name.strip_suffix(ending)?, *unit)));
        let (name, unit) = named.unwrap_or((list.name, ""));
        let name = name.replace('_', " ") + unit;
        std::iter::once(name).chain(shown.map(|name| number(value(name)))).collect()
    });
    text += &table(console, &heading, &rows.collect::<Vec<_>>());
    text
}

fn figure(times: &[f64], summary: &Summary) -> Result<Figure, FigureError> {
    let mut panel = Panel::new(Axis::linear("time [s]"), Axis::linear("controlled variable"));
    let curves = [
        ("median", 2, Line::Solid, 2.5),
        ("middle half", 1, Line::Dashed, 1.5),
        ("", 3, Line::Dashed, 1.5),
        ("middle 90 %", 0, Line::Dotted, 1.5),
        ("", 4, Line::Dotted, 1.5),
    ];
    for (name, index, line, width) in curves {
        let values = summary.bands.iter().map(|band| band[index]).collect();
        let series = Series::new(name, times[..summary.bands.len()].to_vec(), values)?;
        panel = panel.with_series(series.with_tone(Tone::Slot(0)).with_line(line).with_width(width)?);
    }
    Figure::new("Response over the family of processes", vec![panel])
}
