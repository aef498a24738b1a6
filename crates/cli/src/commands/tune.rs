//! `holdup tune`: a controller by one rule, or by all that apply.

use std::fmt::Write as _;

use holdup::analysis::frequency::{Margins, margins};
use holdup::model::description::ControllerDescription;
use holdup::model::quantity::{read_angle, read_any, read_number, read_rate, read_time};
use holdup::model::{ClosedLoop, Process, Radians, TextError};
use holdup::tuning::{Entry, Infeasible, Parameters, RuleError, Specification, Tuning, Unit, rule};
use serde_json::{Value, json};

use super::view::{controller_line, margins_table, process_line};
use crate::args::TuneArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::input;
use crate::table::{number, table, title};

/// Tunes by the rule, or by all.
pub(crate) fn run(args: &TuneArgs, console: Console) -> Result<Answer, Fault> {
    let process = input::process(args.process.as_ref())?;
    match &args.rule {
        Some(id) => one(id, &args.set, &process, console),
        None => super::ranking::run(args, &process, console),
    }
}

fn one(id: &str, set: &[String], process: &Process, console: Console) -> Result<Answer, Fault> {
    let entry = rule(id).map_err(|error| Fault::option("--rule", error))?;
    let mut parameters = Parameters::new();
    for text in set {
        let (name, value) = assignment(entry, text)?;
        parameters = parameters.set(name, value);
    }
    match entry.tune(process, &parameters) {
        Ok(tuning) => {
            let tuned = Tuned::of(process, tuning)?;
            let text = if console.json { String::new() } else { tuned.text(process, entry, console) };
            Ok(Answer { json: tuned.json(), text, warnings: tuned.warnings, ..Answer::default() })
        }
        Err(RuleError::Infeasible(infeasible)) => Ok(refused(&infeasible)),
        Err(error @ RuleError::DoesNotApply { .. }) => Err(Fault::option("--rule", error)),
        Err(error) => Err(Fault::option("--set", error)),
    }
}

/// `NAME=VALUE`, the value in the unit of the parameter.
fn assignment(entry: &Entry, text: &str) -> Result<(String, f64), Fault> {
    let refused =
        || Fault::option("--set", format!("'{}' must be NAME=VALUE", holdup::model::text::one_line(text)));
    let (name, value) = text.split_once('=').ok_or_else(refused)?;
    let parameter = entry.parameters.iter().find(|parameter| parameter.name == name);
    let read: fn(&str, &str) -> Result<f64, TextError> = match parameter.map(|parameter| parameter.unit) {
        Some(Unit::Second) => read_time,
        Some(Unit::Radian) => read_angle,
        Some(Unit::Degree) => |key, text| match text.strip_suffix("deg") {
            Some(degrees) => read_number(key, degrees.trim_end_matches(' ')),
            None if text.ends_with("rad") => read_angle(key, text).map(f64::to_degrees),
            None => read_number(key, text),
        },
        Some(Unit::RadianPerSecond) => read_rate,
        Some(Unit::Percent) => |key, text| read_number(key, text.strip_suffix('%').unwrap_or(text)),
        Some(_) => read_number,
        // The rule says that there is no such parameter, and which one is near.
        None => |_, text| Ok(read_any("", text).unwrap_or_default()),
    };
    Ok((name.to_owned(), read(name, value).map_err(|error| Fault::option("--set", error))?))
}

/// A tuning with what it achieves.
struct Tuned {
    tuning: Tuning,
    achieved: Margins,
    warnings: Vec<String>,
}

impl Tuned {
    fn of(process: &Process, tuning: Tuning) -> Result<Self, Fault> {
        let closed = ClosedLoop::new(process, &tuning.controller);
        let achieved = margins(&closed).map_err(|error| Fault::input(format!("{}: {error}", tuning.rule)))?;
        let warnings = tuning.warnings.iter().chain(&achieved.warnings).cloned().collect();
        Ok(Self { tuning, achieved, warnings })
    }

    fn json(&self) -> Value {
        json_of(&self.tuning, &self.achieved, &self.warnings)
    }

    fn text(&self, process: &Process, entry: &Entry, console: Console) -> String {
        let verdict = if self.achieved.stable { "" } else { "UNSTABLE: " };
        let mut text = title(console, &format!("{verdict}{}", controller_line(&self.tuning.controller)));
        let from = format!("{} ({}, {})", entry.id, entry.authors, entry.year);
        let _ = writeln!(text, "by {from}\non {}", process_line(process));
        let published = &self.tuning.published;
        if !published.settings.is_empty() {
            let settings = published.settings.iter().map(|setting| {
                let unit = if setting.unit.is_empty() { String::new() } else { format!(" {}", setting.unit) };
                format!("{} = {}{unit}", setting.name, number(setting.value))
            });
            let settings: Vec<String> = settings.collect();
            let _ = writeln!(text, "as published: {} ({})", settings.join(", "), published.form);
        }
        text.push('\n');
        text += &asked_and_achieved(&self.tuning.specification, &self.achieved, console);
        text += &margins_table(console, &[("achieved", &self.achieved)]);
        for other in &self.tuning.alternatives {
            let _ = writeln!(text, "also: {}", controller_line(other));
        }
        if !self.tuning.trade_off.is_empty() {
            let row = |point: &holdup::tuning::TradeOff| {
                vec![
                    number(point.observer_gain),
                    number(point.sensitivity_peak),
                    number(point.load_integral_error),
                ]
            };
            let rows: Vec<_> = self.tuning.trade_off.iter().map(row).collect();
            text.push('\n');
            text += &table(
                console,
                &["observer gain Ko", "M_s of the whole loop", "IE after a unit load"],
                &rows,
            );
        }
        text
    }
}

/// A tuning as the contract has it.
pub(super) fn json_of(tuning: &Tuning, achieved: &Margins, warnings: &[String]) -> Value {
    let mut controller = ControllerDescription::from(&tuning.controller);
    controller.published = serde_json::to_value(&tuning.published).unwrap_or_default();
    let mut json = json!({
        "rule": tuning.rule,
        "controller": controller,
        "specification": tuning.specification,
        "achieved": achieved,
        "noise_gain": tuning.controller.noise_gain(),
        "warnings": warnings,
    });
    if !tuning.alternatives.is_empty() {
        let others: Vec<_> = tuning.alternatives.iter().map(ControllerDescription::from).collect();
        json["alternatives"] = json!(others);
    }
    if !tuning.trade_off.is_empty() {
        json["trade_off"] = json!(tuning.trade_off);
    }
    json
}

/// What was asked for beside what is achieved, where both can be compared.
fn asked_and_achieved(asked: &Specification, achieved: &Margins, console: Console) -> String {
    let phase = |angle: Option<f64>| angle.map(f64::to_degrees);
    let rows: Vec<Vec<String>> = [
        ("gain margin [–]", asked.gain_margin, achieved.gain_margin),
        ("phase margin [°]", phase(asked.phase_margin), achieved.phase_margin.map(Radians::degrees)),
        ("delay margin [s]", asked.delay_margin, achieved.delay_margin.map(|time| time.0)),
        ("sensitivity peak [–]", asked.sensitivity_peak, achieved.sensitivity_peak),
    ]
    .into_iter()
    .filter(|(_, asked, _)| asked.is_some())
    .map(|(name, asked, achieved)| vec![name.to_owned(), number(asked), number(achieved)])
    .collect();
    let others = Specification {
        gain_margin: None,
        phase_margin: None,
        delay_margin: None,
        sensitivity_peak: None,
        ..*asked
    };
    let mut text = String::new();
    if !rows.is_empty() {
        text += &table(console, &["", "specified", "achieved"], &rows);
    }
    if others != Specification::default() {
        let _ = writeln!(text, "specified besides: {others}");
    }
    if !text.is_empty() {
        text.push('\n');
    }
    text
}

/// A specification that no controller meets: an answer.
fn refused(infeasible: &Infeasible) -> Answer {
    let warnings = vec![infeasible.to_string()];
    Answer {
        json: json!({
            "rule": infeasible.rule,
            "controller": null,
            "specification": infeasible.asked,
            "achieved": null,
            "infeasible": {"reason": infeasible.reason, "nearest": infeasible.nearest},
            "warnings": warnings,
        }),
        text: format!("{infeasible}\n"),
        ..Answer::default()
    }
}
