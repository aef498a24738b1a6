//! `holdup reproduce`: every printed number of a paper against the computed one.

use std::fmt::Write as _;

use holdup::study::published::{Cell, Reproduction, Verdict, reproduce};

use crate::args::ReproduceArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::table::{number, table, title};

/// Recomputes the paper.
pub(crate) fn run(args: &ReproduceArgs, console: Console) -> Result<Answer, Fault> {
    let reproduction = reproduce(&args.paper).map_err(|error| Fault::input(format!("PAPER is {error}")))?;
    let json = serde_json::to_value(&reproduction).map_err(Fault::input)?;
    let text = if console.json { String::new() } else { text(&reproduction, console) };
    Ok(Answer { json, text, ..Answer::default() })
}

fn text(reproduction: &Reproduction, console: Console) -> String {
    let summary = &reproduction.summary;
    let mut text = title(console, &reproduction.paper);
    let _ = writeln!(
        text,
        "{} printed cells: {} reproduced, {} close, {} not reproduced, {} impossible",
        summary.cells, summary.reproduced, summary.close, summary.not_reproduced, summary.impossible
    );
    let mut names: Vec<&str> = reproduction.cells.iter().map(|cell| cell.table.as_str()).collect();
    names.dedup();
    for name in names {
        text.push('\n');
        text += &title(console, name);
        let rows: Vec<Vec<String>> =
            reproduction.cells.iter().filter(|cell| cell.table == name).map(row).collect();
        text += &table(console, &["", "printed", "computed", "verdict", "convention"], &rows);
    }
    let reasons: Vec<&Cell> =
        reproduction.cells.iter().filter(|cell| cell.verdict != Verdict::Reproduced).collect();
    text.push('\n');
    text += &title(console, "Why");
    for cell in reasons {
        let reason = cell.reason.as_deref().unwrap_or_default();
        text += &wrapped(&format!("{} {} {}: {reason}", cell.table, cell.row, cell.column), console.width);
    }
    text.push('\n');
    text += &title(console, "Findings");
    for (index, finding) in reproduction.findings.iter().enumerate() {
        text += &wrapped(&format!("{}. {}. {}", index + 1, finding.title, finding.text), console.width);
        for point in &finding.points {
            text += &wrapped(&format!("  - {point}"), console.width);
        }
    }
    text
}

fn row(cell: &Cell) -> Vec<String> {
    vec![
        format!("{} {}", cell.row, cell.column),
        cell.printed.to_string(),
        number(Some(cell.computed)),
        cell.verdict.word().to_owned(),
        cell.convention.clone(),
    ]
}

/// The text in lines of at most `width` characters, the following ones indented.
fn wrapped(text: &str, width: usize) -> String {
    let (mut lines, mut line) = (String::new(), String::new());
    for word in text.split(' ') {
        if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > width {
            lines += &line;
            lines.push('\n');
            "  ".clone_into(&mut line);
        } else if !line.is_empty() {
            line.push(' ');
        }
        line += word;
    }
    lines + &line + "\n"
}
