//! Sudden changes of the load: when, and how large.

use serde::Serialize;

use super::confidence::{Inflation, one};
use super::identify::{Joint, Problem, Whitener, dot, solve};
use super::wording::{ends, three};

/// A sudden change of the load at the process input.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LoadStep {
    /// Time at which it begins to act on the level [s].
    #[serde(rename = "time_s")]
    pub time: f64,
    /// Interval of 95 % of the time [s].
    #[serde(rename = "time_interval_s")]
    pub time_interval: [f64; 2],
    /// Change of the load [input unit], positive where it acts as more input does.
    pub size: f64,
    /// Interval of 95 % of the change [input unit].
    pub size_interval: [f64; 2],
}

impl LoadStep {
    /// The step in a sentence.
    #[must_use]
    pub fn text(&self) -> String {
        let ([from, to], [low, high]) = (ends(self.time_interval), ends(self.size_interval));
        format!(
            "at {} s ({from} s to {to} s) the load changes by {} ({low} to {high}) in units of the manipulated variable",
            three(self.time),
            three(self.size)
        )
    }
}

/// The steps of a fit's problem with their intervals; `inflation` is that of the process gain.
///
/// Level, rate, gain and dead time are estimated together: the size is the coefficient of the level's column over the gain, and
/// the time moves by the coefficient of the rate's over it. Variances by the first derivatives.
pub(crate) fn load_steps(
    problem: &Problem<'_>,
    joint: &Joint,
    whitener: &Whitener,
    inflation: &Inflation,
) -> Vec<LoadStep> {
    let fit = &joint.fit;
    let shape = fit.kind.shape(fit.lag);
    let own = problem.own_columns(fit.kind, fit.lag);
    let first = own.len() - 2 * problem.load_steps.len();
    let input = problem.column(shape, fit.dead_time);
    let slope = problem.column(shape.rate(), fit.dead_time);
    let gain_at = own.len();
    let columns: Vec<Vec<f64>> =
        own.into_iter().chain([input, slope]).map(|column| whitener.whiten(column)).collect();
    let response = whitener.whiten(problem.response.clone());
    // Columns of length 1: what is solved has a condition of its correlations only.
    let lengths: Vec<f64> = columns.iter().map(|column| dot(column, column).sqrt()).collect();
    let normal = || -> Vec<Vec<f64>> {
        let row = |i: usize| {
            (0..columns.len()).map(|j| dot(&columns[i], &columns[j]) / (lengths[i] * lengths[j])).collect()
        };
        (0..columns.len()).map(row).collect()
    };
    let right = (0..columns.len()).map(|i| dot(&columns[i], &response) / lengths[i]).collect();
    let Some(weights) = solve(normal(), right) else { return Vec::new() };
    let weight = |i: usize| weights[i] / lengths[i];
    let inverse = |i: usize| -> Vec<f64> {
        let unit = (0..columns.len()).map(|j| f64::from(u8::from(i == j))).collect();
        solve(normal(), unit).unwrap_or_else(|| vec![f64::NAN; columns.len()])
    };
    let variance = fit.squares / joint.freedom * inflation.factor;
    let reach = (one(inflation.freedom) * variance).sqrt();
    let gain = weight(gain_at);
    let step = |index: usize| {
        let (level, rate) = (first + 2 * index, first + 2 * index + 1);
        let (size, moved) = (weight(level) / gain, -weight(rate) / weight(level));
        let of = |i: usize, row: &[f64], j: usize| row[j] / (lengths[i] * lengths[j]);
        let (of_level, of_rate, of_gain) = (inverse(level), inverse(rate), inverse(gain_at));
        let of_size = of(level, &of_level, level) / gain.powi(2)
            + of(gain_at, &of_gain, gain_at) * (size / gain).powi(2)
            - 2.0 * size / gain.powi(2) * of(level, &of_level, gain_at);
        let of_time = of(rate, &of_rate, rate) / weight(level).powi(2);
        let interval = |value: f64, variance: f64| {
            let half = reach * variance.max(0.0).sqrt();
            [value - half, value + half]
        };
        let time = problem.load_steps[index].time + moved;
        LoadStep {
            time,
            time_interval: interval(time, of_time),
            size,
            size_interval: interval(size, of_size),
        }
    };
    let mut found: Vec<LoadStep> = (0..problem.load_steps.len()).map(step).collect();
    found.retain(|step| step.time.is_finite() && step.size_interval.iter().all(|end| end.is_finite()));
    found.sort_by(|a, b| a.time.total_cmp(&b.time));
    found
}
