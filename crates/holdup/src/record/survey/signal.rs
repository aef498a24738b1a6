//! One signal of a record.

use serde::Serialize;

use super::compression::{Compression, compression};
use super::events::range;
use super::noise::{Noise, noise};
use super::oscillation::{Oscillation, oscillation};
use super::quantisation::{Quantisation, quantisation};
use super::sampling::Sampling;
use super::statistics::{differences, quantile, real, spread};

/// Rows of a record, both ends included.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Span {
    /// First row, from 0.
    pub from: usize,
    /// Last row.
    pub to: usize,
    /// Time of the first row [s].
    pub from_s: f64,
    /// Time of the last row [s].
    pub to_s: f64,
    /// The value there.
    pub value: f64,
}

impl Span {
    fn of(time: &[f64], values: &[f64], from: usize, end: usize) -> Self {
        Self { from, to: end - 1, from_s: time[from], to_s: time[end - 1], value: values[from] }
    }

    fn rows(&self) -> usize {
        self.to + 1 - self.from
    }
}

/// An end of a signal's range at which it stays.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Limit {
    /// The value.
    pub value: f64,
    /// Whether it is the upper end.
    pub is_high: bool,
    /// Share of the rows there.
    pub share: f64,
    /// Where it stays for at least five rows.
    pub spans: Vec<Span>,
}

/// What one signal shows.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Signal {
    /// Least value.
    pub least: f64,
    /// Greatest value.
    pub greatest: f64,
    /// Whether it has one value only.
    pub is_constant: bool,
    /// Where it stands still for longer than its other movement explains: a dead signal.
    pub flat: Vec<Span>,
    /// The smallest step, where there is one.
    pub quantisation: Option<Quantisation>,
    /// What a historian left of it.
    pub compression: Option<Compression>,
    /// Ends of its range at which it stays.
    pub limits: Vec<Limit>,
    /// Its noise.
    pub noise: Option<Noise>,
    /// Rows that leave their neighbours and come back at once, from 0.
    pub spikes: Vec<usize>,
    /// A regular oscillation.
    pub oscillation: Option<Oscillation>,
}

impl Signal {
    /// Looks at a signal.
    pub(super) fn of(time: &[f64], values: &[f64], sampling: &Sampling) -> Self {
        let (least, greatest) = range(values);
        if least == greatest {
            return Self {
                least,
                greatest,
                is_constant: true,
                flat: Vec::new(),
                quantisation: None,
                compression: None,
                limits: Vec::new(),
                noise: None,
                spikes: Vec::new(),
                oscillation: None,
            };
        }
        let quantisation = quantisation(values);
        let quantum = quantisation.map(|found| found.quantum);
        let limits = limits(time, values, quantum.unwrap_or(0.0));
        let at_limit = |span: &Span| {
            limits.iter().any(|limit| (limit.value - span.value).abs() <= quantum.unwrap_or(0.0))
        };
        let flat = flat(time, values).into_iter().filter(|span| !at_limit(span)).collect();
        Self {
            least,
            greatest,
            is_constant: false,
            flat,
            quantisation,
            compression: compression(values, sampling, quantum),
            limits,
            noise: noise(values),
            spikes: spikes(values, quantum.unwrap_or(0.0)),
            oscillation: oscillation(time, values, sampling),
        }
    }
}

/// Runs of equal values, as first row and the row behind the last.
fn runs(values: &[f64]) -> Vec<(usize, usize)> {
    let mut runs = Vec::new();
    let mut from = 0;
    for row in 1..=values.len() {
        if row == values.len() || values[row] != values[from] {
            runs.push((from, row));
            from = row;
        }
    }
    runs
}

/// Runs that a signal of this liveliness would have once in a thousand records: with the share p of rows that repeat
/// the value before, a run of L rows in n has the probability n·p^L. The longest run itself is no evidence of p.
fn flat(time: &[f64], values: &[f64]) -> Vec<Span> {
    const LEAST_ROWS: usize = 20;
    let runs = runs(values);
    let length = |run: &(usize, usize)| run.1 - run.0;
    let longest = runs.iter().map(length).max().unwrap_or(0);
    let others = values.len().saturating_sub(longest);
    let repeats = others.saturating_sub(runs.len().saturating_sub(1));
    let share = real(repeats + 1) / real(others + 2);
    let least = (1e-3 / real(values.len())).ln() / share.ln();
    let is_flat = |run: &&(usize, usize)| length(run) >= LEAST_ROWS && real(length(run)) > least;
    runs.iter().filter(is_flat).map(|&(from, end)| Span::of(time, values, from, end)).collect()
}

/// Ends of the range where a signal of many values stays: at least 3 % of its rows, in runs of five or more.
fn limits(time: &[f64], values: &[f64], quantum: f64) -> Vec<Limit> {
    const LEAST_LEVELS: usize = 20;
    const LEAST_RUN: usize = 5;
    let (low, high) = range(values);
    let mut levels: Vec<f64> = values.iter().copied().take(10_000).collect();
    levels.sort_by(f64::total_cmp);
    levels.dedup();
    if levels.len() < LEAST_LEVELS {
        return Vec::new();
    }
    // A converter at its end still shows its last digit.
    let near = (1.01 * quantum).min(0.002 * (high - low));
    let limit = |end: f64, is_high: bool| {
        let there: Vec<bool> = values.iter().map(|value| (value - end).abs() <= near).collect();
        let mut spans = Vec::new();
        let mut row = 0;
        while row < there.len() {
            let length = there[row..].iter().take_while(|there| **there).count();
            if length >= LEAST_RUN {
                spans.push(Span::of(time, values, row, row + length));
            }
            row += length.max(1);
        }
        let rows: usize = spans.iter().map(Span::rows).sum();
        let share = real(rows) / real(values.len());
        (share >= 0.03).then_some(Limit { value: end, is_high, share, spans })
    };
    [limit(low, false), limit(high, true)].into_iter().flatten().collect()
}

/// Rows that lie outside of both neighbours by eight times the usual distance, while the neighbours agree.
fn spikes(values: &[f64], quantum: f64) -> Vec<usize> {
    let bends = || values.windows(3).map(|part| part[1] - f64::midpoint(part[0], part[2]));
    let usual = spread(bends());
    let moves = quantile(differences(values).map(f64::abs).collect(), 0.95);
    let least = (8.0 * usual).max(3.0 * moves).max(3.0 * quantum);
    let part = |(row, bend): (usize, f64)| {
        let apart = (values[row + 2] - values[row]).abs();
        (bend.abs() > least && apart < 0.5 * bend.abs()).then_some(row + 1)
    };
    bends().enumerate().filter_map(part).collect()
}
