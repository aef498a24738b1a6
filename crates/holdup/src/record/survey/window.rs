//! The part of a record to use.

use serde::Serialize;

use super::Survey;
use super::statistics::{mean, real};
use crate::record::{Operation, Record};

/// Fewer rows are no stretch to identify from.
const LEAST_ROWS: usize = 30;

/// A part of a record and why.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Window {
    /// First row, from 0.
    pub from: usize,
    /// The row behind the last.
    pub to: usize,
    /// Time of the first row [s].
    pub from_s: f64,
    /// Time of the last row [s].
    pub to_s: f64,
    /// Why, in words.
    pub reason: String,
}

/// Cuts the record at gaps, and where the controlled variable is dead or at its limit, and takes the stretch in which
/// the manipulated variable moves most: the sum of its squared distances from its mean there, so that length counts,
/// too.
pub(super) fn proposed(record: &Record, survey: &Survey) -> Window {
    let rows = record.len();
    let mut bad = vec![false; rows];
    let signal = &survey.controlled_variable;
    let spans = signal.flat.iter().chain(signal.limits.iter().flat_map(|limit| &limit.spans));
    for span in spans.clone() {
        bad[span.from..=span.to].fill(true);
    }
    let mut stretches: Vec<(usize, usize)> = Vec::new();
    let mut from = 0;
    let after_gap: Vec<usize> = survey.sampling.gaps.iter().map(|gap| gap.after + 1).collect();
    for row in 0..=rows {
        let cut = row == rows || bad[row] || after_gap.binary_search(&row).is_ok();
        if cut {
            if row > from {
                stretches.push((from, row));
            }
            from = if row < rows && bad[row] { row + 1 } else { row };
        }
    }
    let excitation = |&(from, to): &(usize, usize)| -> f64 {
        let part = &record.manipulated_variable()[from..to];
        let centre = mean(part);
        part.iter().map(|value| (value - centre).powi(2)).sum()
    };
    let long = stretches.iter().filter(|(from, to)| to - from >= LEAST_ROWS);
    let best = long.max_by(|a, b| excitation(a).total_cmp(&excitation(b)));
    let (from, to) = best.copied().unwrap_or((0, rows));
    let cuts =
        Cuts { gaps: after_gap.len(), dead: signal.flat.len(), limits: spans.count() - signal.flat.len() };
    let reason = reason(record, survey, from, to, cuts, best.is_some());
    Window { from, to, from_s: record.time()[from], to_s: record.time()[to - 1], reason }
}

/// Why a record is cut, by number.
#[derive(Clone, Copy)]
struct Cuts {
    gaps: usize,
    dead: usize,
    limits: usize,
}

fn reason(record: &Record, survey: &Survey, from: usize, to: usize, cuts: Cuts, found: bool) -> String {
    let mut parts = Vec::new();
    let named = [
        (cuts.gaps, "gap", "gaps"),
        (cuts.dead, "dead stretch", "dead stretches"),
        (cuts.limits, "stretch at a limit", "stretches at a limit"),
    ];
    let why: Vec<String> = named
        .into_iter()
        .filter(|(count, ..)| *count > 0)
        .map(|(count, one, many)| if count == 1 { format!("one {one}") } else { format!("{count} {many}") })
        .collect();
    if why.is_empty() {
        parts.push(
            "the whole record: it has no gap, and the controlled variable is neither dead nor at a limit"
                .to_owned(),
        );
    } else if found {
        parts.push(format!(
            "the stretch between {} in which the manipulated variable moves most",
            why.join(", ")
        ));
    } else {
        parts.push(format!("the whole record: {} leave no stretch of {LEAST_ROWS} rows", why.join(", ")));
    }
    parts.push(excitation(record, survey, from, to));
    parts.join("; ")
}

/// What moves the process in the window.
fn excitation(record: &Record, survey: &Survey, from: usize, to: usize) -> String {
    let inside = |row: usize| row > from && row < to;
    let moves = survey.setpoint_moves.iter().filter(|step| inside(step.row)).count();
    let switches =
        survey.operation.as_ref().map_or(0, |own| own.switches.iter().filter(|one| inside(one.row)).count());
    let by_hand =
        |row: usize| record.operation().is_none_or(|operation| operation[row] != Operation::Automatic);
    let steps = survey.output_steps.iter().filter(|step| inside(step.row) && by_hand(step.row)).count();
    let count = |count: usize, one: &str, many: &str| match count {
        0 => None,
        1 => Some(format!("one {one}")),
        _ => Some(format!("{count} {many}")),
    };
    let found: Vec<String> = [
        count(moves, "setpoint move", "setpoint moves"),
        count(steps, "output step", "output steps"),
        count(switches, "switch of mode", "switches of mode"),
    ]
    .into_iter()
    .flatten()
    .collect();
    let manipulated = &record.manipulated_variable()[from..to];
    let still = manipulated.windows(2).filter(|pair| pair[0] == pair[1]).count();
    if still + 1 == manipulated.len() {
        "the manipulated variable does not move in it".to_owned()
    } else if !found.is_empty() {
        format!("it holds {}", found.join(", "))
    } else if survey.setpoint_follows {
        "its setpoint moves all the time".to_owned()
    } else if real(still) > 0.5 * real(manipulated.len()) {
        "the manipulated variable moves now and then".to_owned()
    } else {
        "nothing but the controller's own reaction moves the process, which may not identify it".to_owned()
    }
}
