//! `holdup rules`: the list of the rules with its filters, and the atlas.

use holdup::model::text::nearest;
use holdup::study::atlas::Atlas;
use holdup::study::atlas::page::page as page_of;
use holdup::tuning::{Applies, Default, Entry, Status, rule, rules};
use serde_json::{Value, json};

use super::ranking::{choice, structure};
use crate::args::RulesArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::table::table;

/// Lists all rules, or shows one.
pub(crate) fn run(args: &RulesArgs, console: Console) -> Result<Answer, Fault> {
    if let Some(id) = &args.id {
        let entry = rule(id).map_err(|error| Fault::option("ID", error))?;
        return Ok(super::rule_page::run(entry, json_of(entry), console));
    }
    let chosen = chosen(args)?;
    let mut files = Vec::new();
    if let Some(path) = &args.report {
        let atlas = Atlas::of(|entry| chosen.iter().any(|rule| rule.id == entry.id));
        let page = page_of(&atlas).map_err(Fault::input)?;
        files.push((path.clone(), page.html().into_bytes()));
    }
    let json = Value::Array(chosen.iter().map(|entry| json_of(entry)).collect());
    let text = if console.json { String::new() } else { list(&chosen, console) };
    Ok(Answer { json, text, files, ..Answer::default() })
}

/// The rules that the options leave.
fn chosen(args: &RulesArgs) -> Result<Vec<&'static Entry>, Fault> {
    let structure = args.structure.as_deref().map(structure).transpose()?;
    let one_of = |option: &str, given: &Option<String>, known: &[&'static str]| {
        let Some(given) = given else { return Ok(None) };
        let plain = given.to_lowercase().replace(['-', '_'], " ");
        let found = known.iter().copied().find(|name| *name == plain).map(Some);
        let near = nearest(given, known.iter().copied());
        found.ok_or_else(|| Fault::option(option, choice(given, near, known)))
    };
    let process = one_of("--process", &args.process, &Applies::ALL.map(Applies::name))?;
    let status = one_of("--status", &args.status, &["recommended", "history", "wrong"])?;
    Ok(rules()
        .iter()
        .copied()
        .filter(|entry| structure.is_none_or(|structure| entry.structure == structure))
        .filter(|entry| process.is_none_or(|process| entry.process.name() == process))
        .filter(|entry| status.is_none_or(|status| entry.status.word() == status))
        .collect())
}

fn list(chosen: &[&'static Entry], console: Console) -> String {
    let row = |entry: &&Entry| {
        let (structure, process) = (entry.structure.to_owned(), entry.process.name().to_owned());
        let mark = match entry.status {
            Status::Recommended => "",
            Status::History(_) => " (history)",
            Status::Wrong(_) => " (wrong)",
        };
        let id = format!("{}{mark}", entry.id);
        vec![id, structure, process, format!("{} {}", entry.authors, entry.year)]
    };
    let rows: Vec<Vec<String>> = chosen.iter().map(row).collect();
    let mut text = table(console, &["rule", "structure", "process", "authors"], &rows);
    text += &format!("{} of {} rules; 'holdup rules ID' shows the page of one\n", rows.len(), rules().len());
    text
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
        "status": entry.status.word(),
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
