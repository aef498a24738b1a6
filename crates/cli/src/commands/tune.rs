//! `holdup tune`: a controller by one rule, or by all that apply.

use std::fmt::Write as _;

use holdup::analysis::frequency::{Margins, margins};
use holdup::analysis::response::{Scenario, simulate};
use holdup::model::description::ControllerDescription;
use holdup::model::quantity::{read_angle, read_any, read_number, read_rate, read_time};
use holdup::model::{ClosedLoop, Controller, Process, Radians, Seconds, TextError};
use holdup::study::PercentOfBest;
use holdup::tuning::{
    Entry, Infeasible, Parameters, RuleError, Specification, Status, Tuning, Unit, rule, rules,
};
use serde_json::{Value, json};

use super::view::{controller_line, margins_table, process_line};
use crate::args::TuneArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::input;
use crate::table::{number, table, title};

/// Rules whose loop has a greater sensitivity peak are ranked behind those that have not.
const ROBUST: f64 = 2.0;

/// Dead times over which a rule is ranked.
const HORIZON: f64 = 100.0;

/// Tunes by the rule, or by all.
pub(crate) fn run(args: &TuneArgs, console: Console) -> Result<Answer, Fault> {
    let process = input::process(args.process.as_ref())?;
    match &args.rule {
        Some(id) => one(id, &args.set, &process, console),
        None => all(&process, console),
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
        let mut controller = ControllerDescription::from(&self.tuning.controller);
        controller.published = serde_json::to_value(&self.tuning.published).unwrap_or_default();
        let mut json = json!({
            "rule": self.tuning.rule,
            "controller": controller,
            "specification": self.tuning.specification,
            "achieved": self.achieved,
            "noise_gain": self.tuning.controller.noise_gain(),
            "warnings": self.warnings,
        });
        if !self.tuning.alternatives.is_empty() {
            let others: Vec<_> = self.tuning.alternatives.iter().map(ControllerDescription::from).collect();
            json["alternatives"] = json!(others);
        }
        if !self.tuning.trade_off.is_empty() {
            json["trade_off"] = json!(self.tuning.trade_off);
        }
        json
    }

    fn text(&self, process: &Process, entry: &Entry, console: Console) -> String {
        let mut text = title(console, &controller_line(&self.tuning.controller));
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

/// A rule with its place among the others.
struct Ranked {
    entry: &'static Entry,
    tuned: Tuned,
    setpoint: PercentOfBest,
    load: PercentOfBest,
}

impl Ranked {
    fn of(entry: &'static Entry, process: &Process) -> Option<Self> {
        let tuned = Tuned::of(process, entry.tune(process, &Parameters::new()).ok()?).ok()?;
        let horizon = Seconds(HORIZON * process.dead_time());
        let run = |setpoint: Vec<(f64, f64)>, load: Vec<(f64, f64)>| {
            let scenario = Scenario::new(setpoint, load, horizon, 0.0).ok()?;
            percent_of_best(process, &tuned.tuning.controller, &scenario)
        };
        let nothing = PercentOfBest { iae: None, ise: None, itae: None, peak: None };
        let setpoint = run(vec![(0.0, 1.0)], Vec::new()).unwrap_or(nothing);
        let load = run(Vec::new(), vec![(0.0, 1.0)]).unwrap_or(nothing);
        Some(Self { entry, tuned, setpoint, load })
    }

    /// Lower is better: robust and recommended before fragile or historical before unstable.
    fn class(&self) -> u8 {
        let achieved = &self.tuned.achieved;
        let robust = achieved.sensitivity_peak.is_some_and(|peak| peak <= ROBUST * (1.0 + 1e-9));
        match (achieved.stable, robust, self.entry.status) {
            (false, _, _) => 3,
            (_, _, Status::Wrong(_)) => 2,
            (true, true, Status::Recommended) => 0,
            (true, _, _) => 1,
        }
    }

    fn score(&self) -> f64 {
        let share = |percent: Option<f64>| percent.unwrap_or(0.0);
        (share(self.setpoint.iae) * share(self.load.iae)).sqrt()
    }
}

fn percent_of_best(process: &Process, controller: &Controller, scenario: &Scenario) -> Option<PercentOfBest> {
    let response = simulate(&ClosedLoop::new(process, controller), scenario).ok()?;
    let bounds = holdup::analysis::bounds::Bounds::of(process, scenario);
    Some(PercentOfBest::of(&response.metrics, &bounds))
}

fn all(process: &Process, console: Console) -> Result<Answer, Fault> {
    let applicable = rules().iter().copied().filter(|entry| entry.applies(process));
    let mut ranked: Vec<Ranked> = applicable.filter_map(|entry| Ranked::of(entry, process)).collect();
    if ranked.is_empty() {
        return Err(Fault::option(
            "--process",
            "no rule gives a controller for this process; see 'holdup rules'",
        ));
    }
    ranked.sort_by(|a, b| a.class().cmp(&b.class()).then(b.score().total_cmp(&a.score())));
    let json = ranked.iter().map(|ranked| {
        let mut json = ranked.tuned.json();
        json["percent_of_best"] = json!({"setpoint_iae": ranked.setpoint.iae, "load_iae": ranked.load.iae});
        json
    });
    let json = Value::Array(json.collect());
    let mut text = String::new();
    if !console.json {
        text = format!(
            "Rules for {}.\nStable with M_s ≤ {ROBUST} first, then by the geometric mean of the two IAE in\npercent of the best possible: 100 % is what no controller beats.\n\n",
            process_line(process)
        );
        let rows: Vec<Vec<String>> = ranked.iter().map(row).collect();
        let heading = ["rule", "Kc", "Ti [s]", "Td [s]", "A_m", "φ_m [°]", "M_s", "step [%]", "load [%]"];
        text += &table(console, &heading, &rows);
    }
    Ok(Answer { json, text, ..Answer::default() })
}

fn row(ranked: &Ranked) -> Vec<String> {
    let (controller, achieved) = (&ranked.tuned.tuning.controller, &ranked.tuned.achieved);
    let verdict = |value: Option<f64>| if achieved.stable { number(value) } else { "unstable".to_owned() };
    vec![
        ranked.entry.id.to_owned(),
        number(controller.proportional_gain()),
        number(controller.integral_time()),
        number(controller.derivative_time()),
        number(achieved.gain_margin),
        number(achieved.phase_margin.map(Radians::degrees)),
        verdict(achieved.sensitivity_peak),
        number(ranked.setpoint.iae),
        number(ranked.load.iae),
    ]
}
