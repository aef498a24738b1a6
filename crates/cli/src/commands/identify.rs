//! `holdup identify`: process, controller and load from a record, with a verdict.

use std::fmt::Write as _;

use holdup::model::quantity::{read_number, read_time};
use holdup::record::controller::{Estimate, RunningController};
use holdup::record::identify::{Hold, Kind, Load};
use holdup::record::{
    Identification, IdentifyOptions, LoadStep, Reading, Record, RetuneError, Survey, Verdict, identify,
    retune,
};
use holdup::study::record_report::record_report;
use serde_json::{Value, json};

use super::record_input;
use crate::args::IdentifyArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::table::{fold, number, table, title};

/// Values of the load in the JSON at most.
const LOAD_VALUES: usize = 2000;

/// Identifies a record.
pub(crate) fn run(args: &IdentifyArgs, console: Console) -> Result<Answer, Fault> {
    let options = options(args)?;
    let reading = record_input::reading(&args.record)?;
    reading.moves().map_err(|error| record_input::fault(&args.record.data, &error))?;
    let given = record_input::window(&args.record, &reading)?;
    let (rows, why) = if let Some(rows) = given {
        (rows, "--from and --to".to_owned())
    } else {
        let window = Survey::of(&reading.record).window;
        (window.from..window.to, window.reason)
    };
    let record = reading.record.rows(rows.start, rows.end).map_err(Fault::input)?;
    let answer = identify(&record, &options)
        .map_err(|error| Fault::input(format!("{}: {error}", args.record.data.display())))?;
    let window = json!({
        "from": rows.start, "to": rows.end, "from_s": record.time()[0],
        "to_s": record.time()[record.len() - 1], "reason": why,
    });
    let mut json = json_of(&answer, &reading, &window);
    let mut text =
        if console.json { String::new() } else { text(args, &answer, &reading, &record, &why, console) };
    let mut warnings = Vec::new();
    let mut retuning = None;
    if args.tune {
        json["tuning"] = Value::Null;
        match retune(&record, &answer, &args.rule) {
            Ok(found) => {
                json["tuning"] = super::retune::json_of(&found);
                if !console.json {
                    text = super::retune::text(&found, &answer, console) + "\n" + &text;
                }
                retuning = Some(found);
            }
            Err(RetuneError::Rule(error)) => return Err(Fault::option("--rule", error)),
            Err(error) => warnings.push(format!("--tune: {error}")),
        }
    }
    let mut files = Vec::new();
    if let Some(path) = &args.report {
        let name = args.record.data.display().to_string();
        let page = record_report(&name, &record, &answer, retuning.as_ref()).map_err(Fault::input)?;
        files.push((path.clone(), page.html().into_bytes()));
    }
    Ok(Answer { json, text, warnings, files })
}

fn options(args: &IdentifyArgs) -> Result<IdentifyOptions, Fault> {
    let unknown = |option: &str, given: &str, allowed: &str| {
        Fault::option(option, format!("'{given}' must be one of {allowed}"))
    };
    let kind = match args.model.as_deref() {
        None => None,
        Some(word) => {
            let words = Kind::ALL.map(Kind::word).join(", ");
            let kind = Kind::ALL.into_iter().find(|kind| kind.word() == word);
            Some(kind.ok_or_else(|| unknown("--model", word, &words))?)
        }
    };
    let hold = match args.hold.as_str() {
        "constant" => Hold::Constant,
        "linear" => Hold::Linear,
        given => return Err(unknown("--hold", given, "constant, linear")),
    };
    let load = match args.load.as_str() {
        "constant" => Load::Constant,
        "drifting" => Load::Drifting,
        given => return Err(unknown("--load", given, "constant, drifting")),
    };
    let positive = |option: &str, value: f64| {
        if value > 0.0 {
            Ok(value)
        } else {
            Err(Fault::input(format!("{option} is {value}: must be above 0")))
        }
    };
    let greatest_dead_time = match &args.max_dead_time {
        Some(text) => Some(read_time("--max-dead-time", text).map_err(Fault::input)?),
        None => None,
    };
    let excursion = match &args.excursion {
        Some(text) => Some(positive("--excursion", read_number("--excursion", text).map_err(Fault::input)?)?),
        None => None,
    };
    let load_steps = args.load_steps.map(usize::from);
    Ok(IdentifyOptions { greatest_dead_time, kind, hold, load, load_steps, excursion })
}

/// The answer as the contract has it.
fn json_of(answer: &Identification, reading: &Reading, window: &Value) -> Value {
    let mut json = serde_json::to_value(answer).unwrap_or_default();
    let controller = answer.controller.as_ref();
    let value = |estimate: Option<Estimate>| estimate.map(|estimate| estimate.value);
    json["controller"] = json!({
        "structure": controller.map(|controller| controller.structure),
        "proportional_gain": controller.map(|controller| controller.proportional_gain.value),
        "integral_time_s": value(controller.and_then(|controller| controller.integral_time)),
        "derivative_time_s": value(controller.and_then(|controller| controller.derivative_time)),
        "setpoint_weight": controller.and_then(|controller| controller.setpoint_weight),
    });
    let interval = |estimate: Option<Estimate>| estimate.map(|estimate| estimate.interval);
    json["controller_confidence"] = json!({
        "proportional_gain": controller.map(|controller| controller.proportional_gain.interval),
        "integral_time_s": interval(controller.and_then(|controller| controller.integral_time)),
        "derivative_time_s": interval(controller.and_then(|controller| controller.derivative_time)),
        "explained": controller.map(|controller| controller.explained),
    });
    if let Some(load) = &answer.load {
        let every = load.time.len().div_ceil(LOAD_VALUES).max(1);
        let thin = |values: &[f64]| values.iter().step_by(every).copied().collect::<Vec<f64>>();
        json["load"] = json!({
            "time_s": thin(&load.time),
            "load": thin(&load.load),
            "window_s": load.window,
            "standard_deviation": load.standard_deviation,
        });
    }
    json["window"] = window.clone();
    json["found"] = json!(reading.found);
    json["repairs"] = json!(reading.repairs);
    json
}

/// A list of sentences, folded.
pub(super) fn list(console: Console, sentences: &[String]) -> String {
    let mut text = String::new();
    for sentence in sentences {
        for (index, line) in fold(sentence, console.width.saturating_sub(2)).iter().enumerate() {
            let _ = writeln!(text, "{}{line}", if index == 0 { "- " } else { "  " });
        }
    }
    text
}

/// Results first, advice after.
fn text(
    args: &IdentifyArgs,
    answer: &Identification,
    reading: &Reading,
    record: &Record,
    why: &str,
    console: Console,
) -> String {
    let headline = match (answer.verdict, &answer.process) {
        (Verdict::Refused, _) | (_, None) => "Refused: this record does not identify the process".to_owned(),
        (verdict, Some(process)) => {
            let lag = process.lag.map_or_else(String::new, |lag| format!(", lag {} s", number(lag)));
            let unit = if process.kind == Kind::DoubleIntegrating { "/s²" } else { "/s" };
            format!(
                "{}: {}, process gain {} {unit}, dead time {} s{lag}",
                if verdict == Verdict::Identified { "Identified" } else { "Weak" },
                process.kind,
                number(process.process_gain),
                number(process.dead_time)
            )
        }
    };
    let mut text = title(console, &headline);
    text += &list(console, &answer.reasons);
    text.push('\n');
    if let (Some(process), Some(confidence)) = (&answer.process, &answer.confidence) {
        let row = |name: &str, value: f64, [low, high]: [f64; 2]| {
            vec![name.to_owned(), number(value), number(low), number(high)]
        };
        let mut rows = vec![
            row("process gain K", process.process_gain, confidence.process_gain),
            row("dead time d [s]", process.dead_time, confidence.dead_time),
        ];
        if let (Some(lag), Some(interval)) = (process.lag, confidence.lag) {
            rows.push(row("lag T [s]", lag, interval));
        }
        text += &table(console, &["", "best", "95 %: from", "to"], &rows);
        text.push('\n');
    }
    if !answer.candidates.is_empty() && answer.process.is_some() {
        text += &list(console, &[format!("Model: {}", answer.choice)]);
        let rows: Vec<Vec<String>> = answer
            .candidates
            .iter()
            .map(|candidate| {
                vec![
                    candidate.kind.to_string(),
                    number(candidate.process.process_gain),
                    number(candidate.process.dead_time),
                    number(candidate.process.lag),
                    number(candidate.criterion),
                ]
            })
            .collect();
        text += &table(console, &["compared", "K", "d [s]", "T [s]", "criterion"], &rows);
        text.push('\n');
    }
    text += &running(answer.controller.as_ref(), answer.excitation.closed_loop, console);
    if !answer.load_steps.is_empty() {
        text += &title(console, "Load steps");
        text += &list(console, &answer.load_steps.iter().map(LoadStep::text).collect::<Vec<_>>());
        text.push('\n');
    }
    if let Some(load) = &answer.load {
        let sentence = format!(
            "Load that explains the rest: standard deviation {} at the process input, seen over {} s.",
            number(load.standard_deviation),
            number(load.window)
        );
        text += &(fold(&sentence, console.width).join("\n") + "\n\n");
    }
    if !answer.diagnosis.findings.is_empty() {
        text += &title(console, "Diagnosis");
        text += &list(console, &answer.diagnosis.findings);
        text.push('\n');
    }
    if let Some(test) = &answer.test {
        text += &title(console, "A test that would help");
        text += &list(console, &[test.text()]);
        text.push('\n');
    }
    let span = record.time()[record.len() - 1] - record.time()[0];
    let window = format!("Window: {} rows, {} s ({why}).", record.len(), number(span));
    text += &(fold(&window, console.width).join("\n") + "\n");
    text += &record_input::text(&args.record, reading, console);
    text
}

/// The recovered controller.
fn running(controller: Option<&RunningController>, closed_loop: bool, console: Console) -> String {
    let Some(controller) = controller else {
        return if closed_loop {
            "Running controller: not recovered: no P, PI or PID law explains the manipulated variable.\n\n"
                .to_owned()
        } else {
            "No controller: the manipulated variable does not answer the controlled one.\n\n".to_owned()
        };
    };
    let row = |name: &str, estimate: Estimate| {
        vec![
            name.to_owned(),
            number(estimate.value),
            number(estimate.interval[0]),
            number(estimate.interval[1]),
        ]
    };
    let mut rows = vec![row("proportional gain Kc", controller.proportional_gain)];
    rows.extend(controller.integral_time.map(|time| row("integral time Ti [s]", time)));
    rows.extend(controller.derivative_time.map(|time| row("derivative time Td [s]", time)));
    let mut text = format!(
        "Running controller: {}, explains {:.2} % of the manipulated variable's moves\n",
        controller.structure,
        100.0 * controller.explained
    );
    if let Some(weight) = controller.setpoint_weight.filter(|weight| *weight != 1.0) {
        let _ = writeln!(text, "Its proportional action sees the setpoint by {}.", number(weight));
    }
    text += &table(console, &["", "best", "95 %: from", "to"], &rows);
    text.push('\n');
    text
}
