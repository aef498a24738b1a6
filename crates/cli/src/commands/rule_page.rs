//! `holdup rules ID`: the page of one rule.

use holdup::model::Radians;
use holdup::tuning::ranking::{Ranked, normalised};
use holdup::tuning::{Default, Entry, Judgement, Status};
use serde_json::{Value, json};

use super::ranking::ranked_json;
use super::view::controller_line;
use crate::console::{Answer, Console};
use crate::table::{fold, number, table, title};

/// The page, and as JSON the entry of the list with published values and exact figures.
pub(crate) fn run(entry: &'static Entry, mut json: Value, console: Console) -> Answer {
    let published = entry.judge().unwrap_or_default();
    let figures = Ranked::of(entry, &normalised(entry.process));
    json["when"] = json!(entry.when);
    json["limits"] = json!(entry.limits);
    json["source"] = json!(entry.source);
    json["published"] = json!(published);
    json["figures"] = figures.as_ref().map_or(Value::Null, ranked_json);
    let mut text = String::new();
    if !console.json {
        text = head(console, entry);
        text += &parameters(console, entry);
        text += &published_values(console, &published);
        text += &exact_figures(console, entry, &figures);
    }
    Answer { json, text, ..Answer::default() }
}

fn head(console: Console, entry: &Entry) -> String {
    let mut text = title(console, &format!("{}: {}", entry.id, entry.name));
    let source = format!("{} ({}): {}", entry.authors, entry.year, entry.citation);
    text += &(fold(&source, console.width).join("\n") + "\n\n");
    let mut line = |name: &str, value: &str| {
        if !value.is_empty() {
            text += &folded(name, value, console.width);
        }
    };
    match entry.status {
        Status::Recommended => {}
        Status::History(why) => line("Status", &format!("kept as history, not recommended: {why}")),
        Status::Wrong(why) => line("Status", &format!("not to be used: {why}")),
    }
    line("Structure", entry.structure);
    line("Process", entry.process.name());
    line("Form", entry.form.text());
    for (index, (name, formula)) in entry.formula.iter().enumerate() {
        line(if index == 0 { "Formula" } else { "" }, &format!("{name} = {formula}"));
    }
    line("When", entry.when);
    line("Limits", entry.limits);
    for (what, allowed) in entry.validity {
        line("Valid for", &format!("{what} {allowed}"));
    }
    line("Provenance", &format!("{}; {}", entry.provenance.text(), entry.source));
    text
}

fn parameters(console: Console, entry: &Entry) -> String {
    if entry.parameters.is_empty() {
        return String::new();
    }
    let row = |parameter: &holdup::tuning::Parameter| {
        let default = match parameter.default {
            Default::Number(value) => number(value),
            Default::Formula(formula) => formula.to_owned(),
            Default::Absent => "–".to_owned(),
        };
        let name = match parameter.unit.symbol() {
            "" => parameter.name.to_owned(),
            unit => format!("{} [{unit}]", parameter.name),
        };
        let advised = parameter.advised.map_or_else(String::new, |range| format!(", advised {range}"));
        let range = format!("{}{advised}", parameter.range);
        vec![name, parameter.description.to_owned(), default, range]
    };
    let rows: Vec<Vec<String>> = entry.parameters.iter().map(row).collect();
    format!("\n{}", table(console, &["parameter", "meaning", "default", "allowed"], &rows))
}

fn published_values(console: Console, published: &[Judgement]) -> String {
    if published.is_empty() {
        return "\nIts source prints no value to compare with.\n".to_owned();
    }
    let row = |value: &Judgement| {
        let verdict = match (value.reproduced, &value.reason) {
            (true, None) => "reproduced",
            (true, Some(_)) => "close",
            (false, _) => "differs",
        };
        vec![value.what.clone(), value.printed.clone(), number(value.computed), verdict.to_owned()]
    };
    let rows: Vec<Vec<String>> = published.iter().map(row).collect();
    let mut text = format!("\n{}", table(console, &["published", "printed", "computed", "verdict"], &rows));
    for value in published {
        if let Some(reason) = &value.reason {
            text += &(fold(&format!("{}: {reason}", value.what), console.width).join("\n") + "\n");
        }
    }
    text
}

fn exact_figures(console: Console, entry: &Entry, figures: &Result<Ranked, String>) -> String {
    let process = match entry.process.name() {
        "integrating with lag" => "K = 1, d = 1 s, T = 1 s",
        _ => "K = 1, d = 1 s",
    };
    let mut text = format!("\nExact figures on the {} process with {process}:\n", entry.process.name());
    let rule = match figures {
        Ok(rule) => rule,
        Err(why) => return text + &(fold(&format!("none: {why}"), console.width).join("\n") + "\n"),
    };
    let mut line = |name: &str, value: &str| text += &folded(name, value, console.width);
    if !rule.achieved.stable {
        line("UNSTABLE", "the loop of this rule is unstable here");
    }
    line("Controller", &controller_line(&rule.tuning.controller));
    let achieved = &rule.achieved;
    let of_best = |iae: Option<f64>, percent: Option<f64>| match (iae, percent) {
        (Some(iae), Some(percent)) => format!("{} ({} % of the best possible)", number(iae), number(percent)),
        (Some(iae), None) => number(iae),
        (None, _) if achieved.stable => "infinite".to_owned(),
        (None, _) => "–".to_owned(),
    };
    line("Load IAE", &of_best(rule.load_iae(), rule.load_percent()));
    line("Step IAE", &of_best(rule.setpoint_iae(), rule.setpoint_percent()));
    line("M_s", &number(achieved.sensitivity_peak));
    line("M_t", &number(achieved.complementary_sensitivity_peak));
    line(
        "Margins",
        &format!(
            "gain {}, phase {}°, delay {} s",
            number(achieved.gain_margin),
            number(achieved.phase_margin.map(Radians::degrees)),
            number(achieved.delay_margin.map(|time| time.0))
        ),
    );
    line("Noise gain", &rule.noise_gain.map_or_else(|| "infinite".to_owned(), number));
    text
}

/// A name and a text broken into lines behind it.
fn folded(name: &str, value: &str, width: usize) -> String {
    const INDENT: usize = 12;
    let lines = fold(value, width - INDENT);
    let heads = std::iter::once(name).chain(std::iter::repeat(""));
    heads.zip(&lines).fold(String::new(), |text, (head, line)| text + &format!("{head:<INDENT$}{line}\n"))
}
