//! `holdup rules`: the list of the rules, and the page of one.

use std::fmt::Write as _;

use holdup::tuning::{Default, Entry, Status, rule, rules};
use serde_json::{Value, json};

use crate::args::RulesArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::table::{fold, number, table, title};

/// Lists all rules, or shows one.
pub(crate) fn run(args: &RulesArgs, console: Console) -> Result<Answer, Fault> {
    if let Some(id) = &args.id {
        let entry = rule(id).map_err(|error| Fault::option("ID", error))?;
        let text = if console.json { String::new() } else { page(console, entry) };
        return Ok(Answer { json: json_of(entry), text, ..Answer::default() });
    }
    let json = Value::Array(rules().iter().map(|entry| json_of(entry)).collect());
    let mut text = String::new();
    if !console.json {
        let row = |entry: &&Entry| {
            let (structure, process) = (entry.structure.to_owned(), entry.process.name().to_owned());
            vec![entry.id.to_owned(), structure, process, format!("{} {}", entry.authors, entry.year)]
        };
        let rows: Vec<Vec<String>> = rules().iter().map(row).collect();
        text = table(console, &["rule", "structure", "process", "authors"], &rows);
        let _ = writeln!(text, "{} rules; 'holdup rules ID' shows the page of one", rows.len());
    }
    Ok(Answer { json, text, ..Answer::default() })
}

fn json_of(entry: &'static Entry) -> Value {
    let parameters: Vec<Value> = entry
        .parameters
        .iter()
        .map(|parameter| {
            let default = match parameter.default {
                Default::Number(number) => json!(number),
                Default::Formula(formula) => json!(formula),
                Default::Absent => Value::Null,
            };
            json!({
                "name": parameter.name,
                "default": default,
                "unit": parameter.unit.symbol(),
                "description": parameter.description,
                "range": parameter.range,
            })
        })
        .collect();
    json!({
        "id": entry.id,
        "name": entry.name,
        "authors": entry.authors,
        "year": entry.year,
        "citation": entry.citation,
        "structure": entry.structure,
        "process": entry.process.name(),
        "parameters": parameters,
        "reproduced": reproduced(entry),
        "form": entry.form.text(),
        "formula": entry.formula.iter().map(|(name, text)| ((*name).to_owned(), json!(text))).collect::<serde_json::Map<_, _>>(),
        "provenance": entry.provenance.text(),
        "recommended": entry.status == Status::Recommended,
    })
}

/// Whether every published value is reproduced; null where its source prints none.
fn reproduced(entry: &'static Entry) -> Value {
    match entry.judge() {
        Ok(values) if values.is_empty() => Value::Null,
        Ok(values) => json!(values.iter().all(|value| value.reproduced)),
        Err(_) => json!(false),
    }
}

fn page(console: Console, entry: &'static Entry) -> String {
    let mut text = title(console, &format!("{}: {}", entry.id, entry.name));
    let source = format!("{} ({}): {}", entry.authors, entry.year, entry.citation);
    text += &(fold(&source, console.width).join("\n") + "\n\n");
    let mut line = |name: &str, value: &str| {
        if !value.is_empty() {
            text += &folded(name, value, console.width);
        }
    };
    line("Structure", entry.structure);
    line("Process", entry.process.name());
    line("Form", entry.form.text());
    line("When", entry.when);
    line("Limits", entry.limits);
    line("Provenance", &format!("{}; {}", entry.provenance.text(), entry.source));
    match entry.status {
        Status::Recommended => {}
        Status::History(why) => line("Status", &format!("kept as history, not recommended: {why}")),
        Status::Wrong(why) => line("Status", &format!("not to be used: {why}")),
    }
    for (name, formula) in entry.formula {
        line("Formula", &format!("{name} = {formula}"));
    }
    if !entry.parameters.is_empty() {
        let rows: Vec<Vec<String>> = entry
            .parameters
            .iter()
            .map(|parameter| {
                let default = match parameter.default {
                    Default::Number(value) => number(value),
                    Default::Formula(formula) => formula.to_owned(),
                    Default::Absent => "–".to_owned(),
                };
                let name = match parameter.unit.symbol() {
                    "" => parameter.name.to_owned(),
                    unit => format!("{} [{unit}]", parameter.name),
                };
                vec![name, parameter.description.to_owned(), default, parameter.range.to_owned()]
            })
            .collect();
        text.push('\n');
        text += &table(console, &["parameter", "meaning", "default", "allowed"], &rows);
    }
    text
}

/// A name and a text broken into lines behind it.
fn folded(name: &str, value: &str, width: usize) -> String {
    const INDENT: usize = 12;
    let lines = fold(value, width - INDENT);
    let heads = std::iter::once(name).chain(std::iter::repeat(""));
    heads.zip(&lines).fold(String::new(), |text, (head, line)| text + &format!("{head:<INDENT$}{line}\n"))
}
