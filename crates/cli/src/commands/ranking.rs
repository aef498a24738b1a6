//! `holdup tune` without a rule: all that apply, ranked.

use holdup::analysis::infinite_horizon::InfiniteHorizon;
use holdup::model::quantity::read_number;
use holdup::model::text::{nearest, one_line};
use holdup::model::{Process, Radians};
use holdup::tuning::ranking::{ORDERS, Order, Ranked, Ranking, rank};
use holdup::tuning::{Status, rules};
use serde_json::{Value, json};

use super::tune::json_of;
use super::view::process_line;
use crate::args::TuneArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::table::{fold, number, table};

/// Ranks the rules that the options leave.
pub(crate) fn run(args: &TuneArgs, process: &Process, console: Console) -> Result<Answer, Fault> {
    let order = order(args.sort.as_deref())?;
    let structure = args.structure.as_deref().map(structure).transpose()?;
    let limit = args.max_sensitivity.as_deref().map(peak).transpose()?;
    let mut ranking = rank(process, order, |entry| {
        (args.all || entry.status == Status::Recommended)
            && structure.is_none_or(|structure| entry.structure == structure)
    });
    let found = ranking.rules.len();
    if let Some(limit) = limit {
        let within = |rule: &Ranked| rule.achieved.sensitivity_peak.is_some_and(|peak| peak <= limit);
        ranking.rules.retain(within);
    }
    let mut warnings: Vec<String> =
        ranking.left_out.iter().map(|(rule, why)| format!("{rule} is not ranked: {why}")).collect();
    if found == 0 {
        warnings.push("no rule applies to this process; see 'holdup rules'".to_owned());
    } else if ranking.rules.is_empty() {
        warnings.push(format!("--max-sensitivity leaves none of {found} rules"));
    }
    let json = Value::Array(ranking.rules.iter().map(ranked_json).collect());
    let text = if console.json { String::new() } else { text(process, order, &ranking, console) };
    Ok(Answer { json, text, warnings, ..Answer::default() })
}

fn order(given: Option<&str>) -> Result<&'static Order, Fault> {
    let Some(given) = given else { return Ok(&ORDERS[0]) };
    let wanted = given.replace('-', "_");
    let names = || ORDERS.iter().map(|order| order.name);
    ORDERS.iter().find(|order| order.name == wanted).ok_or_else(|| {
        Fault::option("--sort", choice(given, nearest(given, names()), &names().collect::<Vec<_>>()))
    })
}

/// The structure of this name, as the registry writes it.
pub(super) fn structure(given: &str) -> Result<&'static str, Fault> {
    let mut known: Vec<&'static str> = rules().iter().map(|entry| entry.structure).collect();
    known.sort_unstable();
    known.dedup();
    let wanted = given.to_uppercase().replace('-', "+");
    let found = known.iter().copied().find(|structure| *structure == wanted);
    found.ok_or_else(|| Fault::option("--structure", choice(given, None, &known)))
}

/// What is wrong with a word that is none of a few.
pub(super) fn choice(given: &str, near: Option<&str>, known: &[&str]) -> String {
    let near = near.map_or_else(String::new, |near| format!(": did you mean '{near}'?"));
    format!("'{}'{near} must be one of {}", one_line(given), known.join(", "))
}

fn peak(text: &str) -> Result<f64, Fault> {
    let peak = read_number("--max-sensitivity", text).map_err(Fault::input)?;
    if peak > 1.0 {
        return Ok(peak);
    }
    Err(Fault::option("--max-sensitivity", format!("{peak} must be greater than 1: no loop has less")))
}

/// One rule as `holdup tune --rule` gives it, and the fields of the ranking.
pub(super) fn ranked_json(rule: &Ranked) -> Value {
    let mut json = json_of(&rule.tuning, &rule.achieved, &rule.warnings);
    let of = |step: &Option<InfiniteHorizon>, get: fn(&InfiniteHorizon) -> Option<f64>| {
        step.as_ref().and_then(get)
    };
    json["load_iae"] = json!(rule.load_iae());
    json["setpoint_iae"] = json!(rule.setpoint_iae());
    json["percent_of_best"] =
        json!({"setpoint_iae": rule.setpoint_percent(), "load_iae": rule.load_percent()});
    json["tail"] =
        json!({"setpoint_iae": of(&rule.setpoint, |s| s.tail), "load_iae": of(&rule.load, |s| s.tail)});
    json["control_energy"] = json!(of(&rule.setpoint, |step| step.control_energy));
    json["total_variation"] = json!({
        "setpoint": of(&rule.setpoint, |step| step.total_variation),
        "load": of(&rule.load, |step| step.total_variation),
    });
    json["dominated"] = json!(rule.dominated_by.is_some());
    json["dominated_by"] = json!(rule.dominated_by);
    json
}

fn text(process: &Process, order: &Order, ranking: &Ranking, console: Console) -> String {
    let rules = &ranking.rules;
    let mut text = String::new();
    let unstable: Vec<&str> =
        rules.iter().filter(|rule| !rule.achieved.stable).map(|rule| rule.entry.id).collect();
    if !unstable.is_empty() {
        say(&mut text, console, &format!("UNSTABLE on this process: {}.", unstable.join(", ")));
    }
    say(&mut text, console, &format!("{} rules for {}.", rules.len(), process_line(process)));
    say(&mut text, console, &format!("Order: {}.", order.description));
    say(
        &mut text,
        console,
        "Unit steps, integrals over all time; 100 % is what no controller beats, – is infinite. A rule with * is \
         dominated: another one here is nowhere worse in both IAE, M_s and noise gain, and somewhere better.",
    );
    if rules.is_empty() {
        return text;
    }
    let names = |rule: &Ranked| {
        let mark = if rule.dominated_by.is_some() { " *" } else { "" };
        format!("{}{mark}", rule.entry.id)
    };
    let mut block = |heading: &[&str], cells: fn(&Ranked) -> Vec<String>| {
        let rows: Vec<Vec<String>> =
            rules.iter().map(|rule| [vec![names(rule)], cells(rule)].concat()).collect();
        text.push('\n');
        text += &table(console, heading, &rows);
    };
    block(&["rule", "load %", "step %", "M_s", "A_m", "φ_m °", "d_m s", "noise"], quality);
    block(&["rule", "Kc", "Ti [s]", "Td [s]", "IAE D", "IAE r", "TV D", "∫u² r"], settings);
    say(
        &mut text,
        console,
        "D: unit load step, r: unit setpoint step, TV: total variation of the controller output, \
         noise: gain from measurement to controller output at high frequency.",
    );
    text
}

fn quality(rule: &Ranked) -> Vec<String> {
    let achieved = &rule.achieved;
    let peak = if achieved.stable { short(achieved.sensitivity_peak) } else { "unst.".to_owned() };
    vec![
        short(rule.load_percent()),
        short(rule.setpoint_percent()),
        peak,
        short(achieved.gain_margin),
        short(achieved.phase_margin.map(Radians::degrees)),
        short(achieved.delay_margin.map(|time| time.0)),
        short(rule.noise_gain),
    ]
}

fn settings(rule: &Ranked) -> Vec<String> {
    let controller = &rule.tuning.controller;
    vec![
        number(controller.proportional_gain()),
        number(controller.integral_time()),
        number(controller.derivative_time()),
        number(rule.load_iae()),
        number(rule.setpoint_iae()),
        number(rule.load.as_ref().and_then(|step| step.total_variation)),
        number(rule.setpoint.as_ref().and_then(|step| step.control_energy)),
    ]
}

/// A sentence in the width of the console.
fn say(text: &mut String, console: Console, sentence: &str) {
    *text += &(fold(sentence, console.width).join("\n") + "\n");
}

/// A number to three digits.
fn short(value: Option<f64>) -> String {
    match value {
        None => "–".to_owned(),
        Some(value) if value.abs() >= 1000.0 || (value != 0.0 && value.abs() < 0.01) => number(value),
        Some(value) => {
            let decimals = if value.abs() >= 99.95 {
                0
            } else if value.abs() >= 9.995 {
                1
            } else {
                2
            };
            format!("{value:.decimals$}")
        }
    }
}
