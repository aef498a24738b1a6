//! What happened: switches of mode, setpoint moves, output steps.

use serde::Serialize;

use super::statistics::{differences, real, spread};
use crate::record::Operation;

/// A move of a signal.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Move {
    /// The first row with the new value, from 0.
    pub row: usize,
    /// Its time [s].
    pub at_s: f64,
    /// The value before.
    pub from: f64,
    /// The value after.
    pub to: f64,
    /// Time that the move takes [s]; 0 for a step.
    pub takes_s: f64,
}

/// A change of who moves the actuator.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Switch {
    /// The first row after it, from 0.
    pub row: usize,
    /// Its time [s].
    pub at_s: f64,
    /// Whether the controller has the actuator afterwards.
    pub to_automatic: bool,
}

/// Who moved the actuator, and when that changed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OperationShares {
    /// Share of the rows in automatic.
    pub automatic: f64,
    /// Share of the rows in manual.
    pub manual: f64,
    /// Share of the rows that do not say.
    pub unknown: f64,
    /// The changes; rows that do not say are none.
    pub switches: Vec<Switch>,
}

impl OperationShares {
    /// Counts and looks for changes.
    pub(super) fn of(time: &[f64], operation: &[Operation]) -> Self {
        let share = |wanted: Operation| {
            real(operation.iter().filter(|own| **own == wanted).count()) / real(operation.len().max(1))
        };
        let mut switches = Vec::new();
        let mut before = Operation::Unknown;
        for (row, &now) in operation.iter().enumerate() {
            if now == Operation::Unknown {
                continue;
            }
            if before != Operation::Unknown && before != now {
                switches.push(Switch { row, at_s: time[row], to_automatic: now == Operation::Automatic });
            }
            before = now;
        }
        Self {
            automatic: share(Operation::Automatic),
            manual: share(Operation::Manual),
            unknown: share(Operation::Unknown),
            switches,
        }
    }
}

/// Moves of the setpoint, and whether it moves so often that it follows something.
pub(super) fn setpoint_moves(time: &[f64], values: &[f64]) -> (Vec<Move>, bool) {
    let (low, high) = range(values);
    // What an exporter rounds is no move.
    let least = 1e-6 * low.abs().max(high.abs()).max(high - low);
    let moving: Vec<bool> = differences(values).map(|step| step.abs() > least).collect();
    let follows = moving.iter().filter(|moving| **moving).count() * 5 > moving.len();
    let mut moves: Vec<Move> = Vec::new();
    let mut row = 0;
    while row < moving.len() {
        if !moving[row] {
            row += 1;
            continue;
        }
        let first = row;
        while row < moving.len() && moving[row] {
            row += 1;
        }
        moves.push(Move {
            row: first + 1,
            at_s: time[first + 1],
            from: values[first],
            to: values[row],
            takes_s: time[row] - time[first + 1],
        });
    }
    (if follows { Vec::new() } else { moves }, follows)
}

/// Steps of the manipulated variable that are six times its usual move from row to row, and a fiftieth of its range.
pub(super) fn output_steps(time: &[f64], values: &[f64]) -> Vec<Move> {
    let (low, high) = range(values);
    let usual = spread(differences(values));
    // Where less than a twentieth of the rows moves, every move is one that somebody made.
    let least = (6.0 * usual).max(0.02 * (high - low));
    if high == low {
        return Vec::new();
    }
    let step = |(row, step): (usize, f64)| {
        let (from, to) = (values[row], values[row + 1]);
        (step.abs() > least).then_some(Move { row: row + 1, at_s: time[row + 1], from, to, takes_s: 0.0 })
    };
    differences(values).enumerate().filter_map(step).collect()
}

/// Least and greatest value.
pub(super) fn range(values: &[f64]) -> (f64, f64) {
    values
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)))
}
