//! `holdup optimise`: the best controller of a structure under limits; averaging level control.

mod asked;
mod frontier;
mod level;
mod tabulated;

use std::path::PathBuf;

use clap::Args;
use holdup::model::Process;
use holdup::model::description::ControllerDescription;
use holdup::study::read_rules;
use holdup::tuning::optimise::{Filter, Limits, Objective, Optimum, Quantity, Task, WHOLE};
use serde_json::{Value, json};

use super::view::{check_kind, controller_line, figure_file, margins_table, process_line};
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::input::{process, text_of};
use crate::progress::Progress;
use crate::table::number;

/// The sensitivity peaks of the frontier.
const PEAKS: [f64; 9] = [1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 2.0, 2.3];

/// `holdup optimise`.
#[derive(Debug, Args)]
pub(crate) struct OptimiseArgs {
    /// The process: K=…,d=…[,T=…][,integrators=2]
    #[arg(short, long, value_name = "K=…,d=…")]
    pub(crate) process: Option<String>,
    /// The structure: pi where nothing is said; p, pi, pi-b, pd, pid, pid-b, p+dob, pd+dob (-b: with setpoint weight)
    #[arg(long, value_name = "STRUCTURE")]
    pub(crate) structure: Option<String>,
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
    /// Filter of the derivative: free (a part of the design), none, or the ratio Tf/Td that is held; where nothing is said,
    /// free if a limit on noise needs a filter, else none
    #[arg(long, value_name = "FILTER", allow_hyphen_values = true)]
    pub(crate) filter: Option<String>,
    /// Greatest gain from measurement to controller output at high frequency
    #[arg(long, value_name = "GAIN", allow_hyphen_values = true)]
    pub(crate) max_noise_gain: Option<String>,
    /// Greatest IAE after a unit load step
    #[arg(long, value_name = "IAE", allow_hyphen_values = true)]
    pub(crate) max_load_iae: Option<String>,
    /// Greatest IAE after a unit setpoint step
    #[arg(long, value_name = "IAE", allow_hyphen_values = true)]
    pub(crate) max_setpoint_iae: Option<String>,
    /// Greatest settling time: last time the error is more than 2 % of a setpoint step
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) max_settling_time: Option<String>,
    /// Greatest variance of the controller output, as a multiple of that of the measurement's noise
    #[arg(long, value_name = "RATIO", allow_hyphen_values = true)]
    pub(crate) max_variance_gain: Option<String>,
    /// With --max-variance-gain: the noise is white, a new value every TIME that is held
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) noise_sample_time: Option<String>,
    /// With --max-variance-gain: the noise is white up to this frequency, and there is none above
    #[arg(long, value_name = "RATE", allow_hyphen_values = true)]
    pub(crate) noise_bandwidth: Option<String>,
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
    /// Draw these rules of your own on the frontier, too: a file with tables [[rule]] (formulas) or [[controller]], or a study
    #[arg(long, value_name = "FILE.toml")]
    pub(crate) rules: Option<PathBuf>,
    /// Take the optimum from the table instead of a search: plain integrator, --max-sensitivity alone
    #[arg(long)]
    pub(crate) table: bool,
    /// Print the tables in normalised form (K·Kc·d, Ti/d, …), of --structure where it is given
    #[arg(long)]
    pub(crate) tables: bool,
    /// Write a picture of that frontier, with the rules on it: .svg, .png or .html
    #[arg(long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
}

impl OptimiseArgs {
    /// The structure, PI where none is given.
    fn structure(&self) -> &str {
        self.structure.as_deref().unwrap_or("pi")
    }
}

/// Searches.
pub(crate) fn run(args: &OptimiseArgs, console: Console) -> Result<Answer, Fault> {
    args.plot.as_deref().map_or(Ok(()), check_kind)?;
    if args.tables {
        asked::only(args, "--tables", &["--process", "--structure"])?;
        return tabulated::all(args, console);
    }
    let process = process(args.process.as_ref())?;
    if args.objective == "averaging" {
        let used = ["--process", "--max-sensitivity", "--load-step", "--excursion"];
        asked::only(args, "--objective averaging", &used)?;
        return level::level(args, &process, console);
    }
    for (option, given) in [("--load-step", &args.load_step), ("--excursion", &args.excursion)] {
        if given.is_some() {
            return Err(Fault::option(option, "must stand with --objective averaging"));
        }
    }
    if args.table {
        asked::only(
            args,
            "--table, which is for --max-sensitivity and no other limit",
            &["--table", "--process", "--structure", "--filter", "--max-sensitivity"],
        )?;
    }
    let structure = asked::structure(args.structure())?;
    let filter = asked::filter(args, structure)?;
    let limits = asked::limits(args, &process)?;
    let objective = asked::objective(args, &limits)?;
    if args.table {
        return tabulated::one(&process, (structure, filter, objective), &limits, console);
    }
    let with_frontier = args.trade_off || args.plot.is_some();
    let own = match &args.rules {
        Some(_) if !with_frontier => {
            return Err(Fault::option("--rules", "must stand with --trade-off or --plot, which draw them"));
        }
        Some(path) => {
            let rules = read_rules(&text_of(path)?, &process).map_err(|error| Fault::text(path, &error))?;
            frontier::achieved(&process, objective, rules)
                .map_err(|error| Fault::input(format!("{}: {error}", path.display())))?
        }
        None => Vec::new(),
    };
    // What is spent on the box is not a limit on the nominal loop.
    let limits = match objective {
        Objective::RobustBox { .. } => limits.without(Quantity::SensitivityPeak),
        _ => limits,
    };
    let mut task = Task::new(&process, structure, objective, &limits);
    if let Some(filter) = filter {
        task = task.with_filter(filter);
    }
    let optima = 1 + if with_frontier { PEAKS.len() as u64 } else { 0 };
    let progress = Progress::without_end("thousandths of an optimum", WHOLE * optima);
    let tell = |thousandths: u64| progress.add(thousandths);
    let best = task.optimise(&tell).map_err(|error| refused(&error))?;
    let points = if with_frontier {
        Some(task.trade_off(&PEAKS, &tell).map_err(|error| refused(&error))?)
    } else {
        None
    };
    progress.end();
    let mut files = Vec::new();
    if let (Some(path), Some(points)) = (&args.plot, &points) {
        let figure = frontier::figure(&process, structure, objective, points, &own).map_err(Fault::input)?;
        files.push((path.clone(), figure_file(path, &figure)?));
    }
    let filter_is_a_choice = filter.is_none() && structure.differentiates() && task.filter() == Filter::Free;
    let warnings = warnings(&best, filter_is_a_choice);
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
        "trade_off": points.as_ref().map(|points| points.iter().map(frontier::point_json).collect::<Vec<_>>()),
        "rules": args.rules.as_ref().map(|_| own.iter().map(frontier::own_json).collect::<Vec<_>>()),
        "warnings": warnings,
    });
    let mut text = String::new();
    if !console.json {
        text = told(&process, &best, objective, &limits, console);
        if let Some(points) = &points {
            text += &format!("\n{}", frontier::text(points, &own, objective, console));
        }
    }
    Ok(Answer { json, text, warnings, files })
}

/// A refusal in the words of the command line.
fn refused(error: &holdup::tuning::optimise::OptimiseError) -> Fault {
    let text = error.to_string();
    Fault::input(text.replace(
        "the filter must be free or a ratio that is held",
        "--filter must be free or the ratio Tf/Td that is held, such as 0.1",
    ))
}

/// The limits by name.
fn specification(limits: &Limits) -> Value {
    let map = limits
        .list()
        .iter()
        .map(|limit| (limit.quantity.name().to_owned(), json!(limit.quantity.shown(limit.value))));
    Value::Object(map.collect())
}

/// What a reader must know.
fn warnings(best: &Optimum, filter_is_a_choice: bool) -> Vec<String> {
    let mut sentences = best.warnings.clone();
    if filter_is_a_choice {
        sentences.push(
            "A limit on noise needs a filter of the derivative: its time is a part of the design (--filter free)."
                .to_owned(),
        );
    }
    if best.starts > 1 && best.agreeing < 2 {
        sentences
            .push(format!("Only one of {} starts found this optimum: a better one may exist.", best.starts));
    }
    for integrals in best.load.iter().chain(&best.setpoint) {
        sentences.extend(integrals.warnings.iter().cloned());
    }
    if best.controller.derivative_time().is_some() && best.controller.derivative_filter().is_none() {
        sentences.push(
            "The derivative action is unfiltered: --filter free or a limit on noise makes the filter a part of the design."
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
        " load IAE               {}\n setpoint IAE           {}\n settling time [s]      {}\n",
        iae(best.load.as_ref().and_then(|load| load.iae)),
        iae(best.setpoint.as_ref().and_then(|setpoint| setpoint.iae)),
        iae(best.setpoint.as_ref().and_then(|setpoint| setpoint.settling_time))
    );
    text
}
