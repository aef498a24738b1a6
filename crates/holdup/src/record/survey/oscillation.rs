//! Regular oscillation: period, strength, shape.
//!
//! N. F. Thornhill, B. Huang and H. Zhang (2003), Detection of multiple oscillations in control loops, Journal of
//! Process Control 13, 91–100: the zero crossings of the autocorrelation function of a regular oscillation are evenly
//! spaced. With the mean period T of the intervals and the standard deviation σ of the period, the oscillation is
//! regular where r = T/(3σ) exceeds 1. Noise makes no regular crossings, and disturbs those of the signal less than in
//! the signal itself.

use serde::Serialize;

use super::sampling::Sampling;
use super::spectrum::autocorrelation;
use super::statistics::{mean, real};

/// The shape of one cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shape {
    /// Round: a linear loop, or a smooth disturbance.
    Sinusoidal,
    /// Straight flanks: what an integrator makes of a square wave, the sign of a sticking valve.
    Triangular,
    /// Flat tops: a signal that switches between two values.
    Square,
}

/// A regular oscillation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Oscillation {
    /// Its period [s].
    pub period_s: f64,
    /// Standard deviation of the period [s], from the crossings.
    pub period_deviation_s: f64,
    /// Regularity r of Thornhill, Huang and Zhang; above 1.
    pub regularity: f64,
    /// Autocorrelation one period apart: 1 where every cycle is like the last, 0 where nothing comes back.
    pub strength: f64,
    /// Half the distance from trough to peak of the mean cycle, in the unit of the signal.
    pub amplitude: f64,
    /// Periods in the record.
    pub cycles: f64,
    /// The shape of the mean cycle.
    pub shape: Shape,
}

/// Crossings of the autocorrelation function that are used at most, after the paper.
const CROSSINGS: usize = 11;

/// Intervals that are needed: two periods, besides the first quarter.
const LEAST_INTERVALS: usize = 4;

/// Least autocorrelation one period apart that is worth a word.
const LEAST_STRENGTH: f64 = 0.2;

/// Looks for a regular oscillation: first about the straight line through the signal, then about means over ever
/// shorter stretches, which take away what is slower.
pub(super) fn oscillation(time: &[f64], values: &[f64], sampling: &Sampling) -> Option<Oscillation> {
    const LEAST_ROWS: usize = 40;
    if values.len() < LEAST_ROWS {
        return None;
    }
    let even = evenly(time, values, sampling);
    let straight = without_line(&even);
    let about = |share: usize| -> Option<Oscillation> {
        let width = straight.len() / share;
        let tried = if share == 1 { straight.clone() } else { without_mean(&straight, width) };
        // A mean over a stretch leaves only what is faster than it.
        regular(&tried, sampling.period_s)
            .filter(|found| share == 1 || found.period_s < real(width) * sampling.period_s)
    };
    [1, 4, 12, 36].into_iter().find_map(about)
}

/// The signal at even times, on straight lines between its rows.
fn evenly(time: &[f64], values: &[f64], sampling: &Sampling) -> Vec<f64> {
    if sampling.is_even() && sampling.gaps.is_empty() {
        return values.to_vec();
    }
    let mut row = 0;
    let last = time.len() - 1;
    let count = values.len();
    let step = (time[last] - time[0]) / real(count - 1);
    (0..count)
        .map(|k| {
            let at = time[0] + step * real(k);
            while row + 2 < time.len() && time[row + 1] < at {
                row += 1;
            }
            let share = ((at - time[row]) / (time[row + 1] - time[row])).clamp(0.0, 1.0);
            values[row] + share * (values[row + 1] - values[row])
        })
        .collect()
}

/// The signal less its straight line of least squares.
fn without_line(values: &[f64]) -> Vec<f64> {
    let middle = real(values.len() - 1) / 2.0;
    let centre = mean(values);
    let (mut product, mut square) = (0.0, 0.0);
    for (row, value) in values.iter().enumerate() {
        let x = real(row) - middle;
        product += x * (value - centre);
        square += x * x;
    }
    let slope = product / square;
    values.iter().enumerate().map(|(row, value)| value - centre - slope * (real(row) - middle)).collect()
}

/// The signal less its mean over `width` rows about each.
fn without_mean(values: &[f64], width: usize) -> Vec<f64> {
    let mut sums = Vec::with_capacity(values.len() + 1);
    sums.push(0.0);
    for value in values {
        sums.push(sums[sums.len() - 1] + value);
    }
    let half = (width / 2).max(1);
    let about = |(row, value): (usize, &f64)| {
        let (from, to) = (row.saturating_sub(half), (row + half + 1).min(values.len()));
        value - (sums[to] - sums[from]) / real(to - from)
    };
    values.iter().enumerate().map(about).collect()
}

fn regular(values: &[f64], step: f64) -> Option<Oscillation> {
    let acf = autocorrelation(values);
    let crossings = crossings(&acf);
    let intervals: Vec<f64> = crossings.windows(2).map(|pair| pair[1] - pair[0]).collect();
    if intervals.len() < LEAST_INTERVALS {
        return None;
    }
    let half = mean(&intervals);
    let variance =
        intervals.iter().map(|interval| (interval - half).powi(2)).sum::<f64>() / real(intervals.len() - 1);
    let (period, deviation) = (2.0 * half, 2.0 * variance.sqrt());
    // Crossings lie between rows: they are not known to be more even than a hundredth of a row.
    let regularity = period / (3.0 * deviation.max(0.01));
    let strength = interpolated(&acf, period)?;
    if regularity <= 1.0 || strength < LEAST_STRENGTH || period < 4.0 {
        return None;
    }
    let cycle = mean_cycle(values, period)?;
    let (low, high) = super::events::range(&cycle);
    Some(Oscillation {
        period_s: period * step,
        period_deviation_s: deviation * step,
        regularity,
        strength,
        amplitude: (high - low) / 2.0,
        cycles: real(values.len()) / period,
        shape: shape(&cycle),
    })
}

/// Lags at which the function changes its sign, between rows by a straight line. Wiggles about zero that stay within
/// a twentieth of lag 0 are no change of sign.
fn crossings(acf: &[f64]) -> Vec<f64> {
    const BAND: f64 = 0.05;
    let (mut found, mut sign, mut last) = (Vec::new(), 1.0, 0.0);
    // Beyond half of the record the sums are short.
    for lag in 1..acf.len() / 2 {
        if acf[lag - 1] * acf[lag] <= 0.0 && acf[lag - 1] != acf[lag] {
            last = real(lag) - acf[lag] / (acf[lag] - acf[lag - 1]);
        }
        if acf[lag] * sign < -BAND {
            found.push(last);
            sign = -sign;
        }
        if found.len() == CROSSINGS {
            break;
        }
    }
    found
}

fn interpolated(acf: &[f64], lag: f64) -> Option<f64> {
    let below = floor(lag);
    let share = lag - real(below);
    Some(acf.get(below)? * (1.0 - share) + acf.get(below + 1)? * share)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "lags are positive and fewer than rows"
)]
fn floor(lag: f64) -> usize {
    lag.max(0.0) as usize
}

/// Points of the mean cycle.
const POINTS: usize = 32;

/// The mean of the cycles, each from one rise through zero to the next and stretched to the same length; cycles that
/// are more than a quarter longer or shorter than the period are left out.
fn mean_cycle(values: &[f64], period: f64) -> Option<Vec<f64>> {
    let width = floor(period / 8.0).max(1);
    let mut smooth = vec![0.0];
    for value in values {
        smooth.push(smooth[smooth.len() - 1] + value);
    }
    let at = |row: usize| {
        let (from, to) = (row.saturating_sub(width / 2), (row + width / 2 + 1).min(values.len()));
        (smooth[to] - smooth[from]) / real(to - from)
    };
    let rises: Vec<usize> = (1..values.len()).filter(|&row| at(row - 1) < 0.0 && at(row) >= 0.0).collect();
    let mut sum = vec![0.0; POINTS];
    let mut count = 0_usize;
    for pair in rises.windows(2) {
        let length = real(pair[1] - pair[0]);
        if (length / period - 1.0).abs() > 0.25 {
            continue;
        }
        count += 1;
        for (point, sum) in sum.iter_mut().enumerate() {
            let place = real(pair[0]) + length * real(point) / real(POINTS);
            *sum += interpolated(values, place).unwrap_or(0.0);
        }
    }
    let centre = mean(&sum);
    (count > 0).then(|| sum.iter().map(|value| (value - centre) / real(count)).collect())
}

/// The shape by the ratio of mean modulus to root mean square: 1 for a square wave, 0.900 for a sinusoid, 0.866 for a
/// triangle. The limits are the middles.
fn shape(cycle: &[f64]) -> Shape {
    let modulus = cycle.iter().map(|value| value.abs()).sum::<f64>() / real(cycle.len());
    let square = (cycle.iter().map(|value| value * value).sum::<f64>() / real(cycle.len())).sqrt();
    match modulus / square {
        ratio if ratio < 0.883 => Shape::Triangular,
        ratio if ratio < 0.95 => Shape::Sinusoidal,
        _ => Shape::Square,
    }
}
