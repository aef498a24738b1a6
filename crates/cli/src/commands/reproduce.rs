//! `holdup reproduce`: every printed number of a paper against the computed one.

use holdup::study::published::{Cell, Reproduction, Verdict, reproduce};

use crate::args::ReproduceArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::table::{fold, number, table, title};

/// Reproduces the paper.
pub(crate) fn run(args: &ReproduceArgs, console: Console) -> Result<Answer, Fault> {
    let result = reproduce(&args.paper).map_err(|error| Fault::option("PAPER", error))?;
    let text = if console.json { String::new() } else { text(&result, console) };
    Ok(Answer { json: serde_json::to_value(&result).map_err(Fault::input)?, text, ..Answer::default() })
}

fn text(result: &Reproduction, console: Console) -> String {
    let summary = result.summary;
    let mut text = title(
        console,
        &format!(
            "{} printed numbers: {} reproduced, {} close, {} not reproduced, {} impossible",
            summary.cells, summary.reproduced, summary.close, summary.not_reproduced, summary.impossible
        ),
    );
    let mut tables: Vec<&str> = result.cells.iter().map(|cell| cell.table).collect();
    tables.dedup();
    let mut reasons: Vec<String> = Vec::new();
    for name in tables {
        text += &format!("\n{}\n", title(console, name).trim_end());
        let rows = result.cells.iter().filter(|cell| cell.table == name).map(|cell| row(cell, &mut reasons));
        text += &table(
            console,
            &["row", "column", "printed", "computed", "verdict", "why"],
            &rows.collect::<Vec<_>>(),
        );
    }
    text += &format!("\n{}", title(console, "Why"));
    for (index, reason) in reasons.iter().enumerate() {
        let mark = format!("[{}] ", index + 1);
        let lines = fold(reason, console.width.saturating_sub(5));
        let heads = std::iter::once(mark.as_str()).chain(std::iter::repeat(""));
        text.extend(heads.zip(lines).map(|(head, line)| format!("{head:<5}{line}\n")));
    }
    text + "\n'--json' has the convention, the reason and every reading of each cell.\n"
}

/// A row; its reason is listed once below the tables, the numbers in it left to the columns.
fn row(cell: &Cell, reasons: &mut Vec<String>) -> Vec<String> {
    let reason = cell.reason.as_ref().map(|reason| match cell.verdict {
        Verdict::Reproduced => {
            reason.split("; the stated convention gives").next().unwrap_or(reason).to_owned()
        }
        Verdict::Impossible => reason.clone(),
        _ => reason
            .split_once(" from the computed ")
            .map_or(reason.as_str(), |(_, rest)| rest)
            .split_once([',', ':'])
            .map_or_else(
                || reason.clone(),
                |(_, rest)| {
                    let rest = rest.split("; the stated convention gives").next().unwrap_or(rest);
                    format!(
                        "the closest convention: {}",
                        rest.trim()
                            .replace("under the stated convention, which comes closest", "the stated one")
                    )
                },
            ),
    });
    let mark = reason.map_or_else(String::new, |reason| {
        let index = reasons.iter().position(|known| *known == reason).unwrap_or_else(|| {
            reasons.push(reason);
            reasons.len() - 1
        });
        format!("[{}]", index + 1)
    });
    vec![
        cell.row.to_owned(),
        cell.column.to_owned(),
        cell.printed.to_string(),
        number(cell.computed),
        cell.verdict.name().to_owned(),
        mark,
    ]
}
