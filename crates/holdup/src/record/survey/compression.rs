//! What a historian left of a signal.

use serde::Serialize;

use super::events::range;
use super::sampling::Sampling;
use super::statistics::{differences, quantile, real, spread};

/// How a signal was thinned out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CompressionKind {
    /// Rows lie on straight lines between few archived points, as a swinging door leaves them.
    Interpolated,
    /// Rows hold the value of the last archived point.
    Held,
    /// Rows are the archived points themselves: uneven in time, each some least distance from the one before.
    OnChange,
}

/// Signs that a signal was thinned out before it was exported.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Compression {
    /// How.
    pub kind: CompressionKind,
    /// Share of the rows that are not archived points of their own.
    pub share: f64,
    /// Mean rows from one archived point to the next.
    pub rows_per_point: f64,
    /// The evidence, in words.
    pub evidence: String,
}

/// Looks for the marks of a historian; `quantum` is the signal's smallest step. Values that are held are a mark in a
/// signal that is `measured`; a setpoint or an output is held by who sets it.
pub(super) fn compression(
    values: &[f64],
    sampling: &Sampling,
    quantum: Option<f64>,
    measured: bool,
) -> Option<Compression> {
    const LEAST_ROWS: usize = 40;
    let moves: Vec<f64> = differences(values).filter(|step| *step != 0.0).map(f64::abs).collect();
    if values.len() < LEAST_ROWS || moves.len() < 10 {
        return None;
    }
    if sampling.is_even() {
        measured.then(|| held(values, &moves, quantum)).flatten().or_else(|| interpolated(values, quantum))
    } else {
        on_change(&moves, sampling)
    }
}

/// Rows that repeat a value while its moves are many quanta: the moves of a signal that is only quantised are of one.
fn held(values: &[f64], moves: &[f64], quantum: Option<f64>) -> Option<Compression> {
    let rows = values.len() - 1;
    let share = 1.0 - real(moves.len()) / real(rows);
    let usual = quantile(moves.to_vec(), 0.5);
    if share < 0.4 || usual < 4.0 * quantum.unwrap_or(0.0) {
        return None;
    }
    // A signal that rests and then moves for a while moves in rows on end; an archive in single ones.
    let steps: Vec<f64> = differences(values).collect();
    let single = steps.windows(2).filter(|pair| pair[0] != 0.0 && pair[1] == 0.0).count();
    if single * 2 < moves.len() {
        return None;
    }
    let rows_per_point = real(rows) / real(moves.len());
    let evidence = format!(
        "{:.0} % of the rows repeat the value before, and moves are usually {usual:.3e}, one every {rows_per_point:.1} rows",
        100.0 * share
    );
    Some(Compression { kind: CompressionKind::Held, share, rows_per_point, evidence })
}

/// Fewer points than these are no archive, but a signal that bends a few times.
const LEAST_POINTS: usize = 6;

/// Rows on straight lines: second differences of next to nothing, far more often than noise would have them.
fn interpolated(values: &[f64], quantum: Option<f64>) -> Option<Compression> {
    let bends: Vec<f64> = values.windows(3).map(|part| part[2] - 2.0 * part[1] + part[0]).collect();
    let moving = |row: usize| values[row] != values[row + 1] || values[row + 1] != values[row + 2];
    // The sixteenth digit of a straight line is no bend: of few archived points it would outnumber them.
    let (least, greatest) = range(values);
    let rounding = (1e-12 * least.abs().max(greatest.abs())).max(2.0 * quantum.unwrap_or(0.0));
    let bent: Vec<f64> = bends.iter().copied().filter(|bend| bend.abs() > rounding).collect();
    if bent.is_empty() {
        return None;
    }
    let size = spread(bent.iter().copied())
        .max(quantile(bends.iter().map(|bend| bend.abs()).collect(), 0.95) / 1.96);
    // A line that is rounded to the quantum bends by up to two of it.
    let straight = (0.02 * size).max(2.0 * quantum.unwrap_or(0.0));
    if size == 0.0 || straight > 0.1 * size {
        return None;
    }
    let on_line = |(row, bend): (usize, &f64)| bend.abs() <= straight && moving(row);
    let lined = bends.iter().enumerate().filter(|&pair| on_line(pair)).count();
    let share = real(lined) / real(bends.len());
    // Normal noise has the share 0.8·straight/size there.
    let expected = 0.8 * straight / size;
    if share < 0.15 || share < 6.0 * expected {
        return None;
    }
    // Archived points are kinks between straight lines. A signal that is smooth without noise, too, bends little in
    // most of its rows, but where it bends it does so in many rows on end.
    let is_bent = |bend: f64| bend.abs() > straight;
    let points = bends.windows(3).filter(|part| is_bent(part[1]));
    let kinks = points.clone().filter(|part| !is_bent(part[0]) && !is_bent(part[2])).count();
    let points = points.count();
    if points < LEAST_POINTS || kinks * 10 < points {
        return None;
    }
    let rows_per_point = 1.0 / (1.0 - share).max(1.0 / real(bends.len()));
    let evidence = format!(
        "{:.0} % of the rows lie on the straight line through their neighbours, where noise of this size would have {:.1} %",
        100.0 * share,
        100.0 * expected
    );
    Some(Compression { kind: CompressionKind::Interpolated, share, rows_per_point, evidence })
}

/// Uneven rows whose moves keep a least distance.
fn on_change(moves: &[f64], sampling: &Sampling) -> Option<Compression> {
    let (least, usual) = (quantile(moves.to_vec(), 0.02), quantile(moves.to_vec(), 0.5));
    let stretched = sampling.longest_s / sampling.shortest_s;
    // Moves of a continuous signal have no least size: the fiftieth part of them is a fortieth of the usual move.
    if least < 0.2 * usual || stretched < 3.0 {
        return None;
    }
    let rows_per_point = sampling.period_s / sampling.shortest_s;
    let evidence = format!(
        "rows are {:.3} s to {:.3} s apart, and 98 % of the moves are at least {least:.3e}",
        sampling.shortest_s, sampling.longest_s
    );
    Some(Compression { kind: CompressionKind::OnChange, share: 0.0, rows_per_point, evidence })
}
