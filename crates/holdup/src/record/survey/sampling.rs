//! The sample period, its jitter and its gaps.

use serde::Serialize;

use super::statistics::{differences, quantile, real};

/// A step of time that is much longer than the others.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Gap {
    /// The row before it, from 0.
    pub after: usize,
    /// Time of that row [s].
    pub from_s: f64,
    /// Its length [s].
    pub length_s: f64,
}

/// How rows are spaced in time.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sampling {
    /// The median step of time [s].
    pub period_s: f64,
    /// Shortest step [s].
    pub shortest_s: f64,
    /// Longest step [s].
    pub longest_s: f64,
    /// Share of the steps that differ from the median by more than a tenth of it.
    pub irregular_share: f64,
    /// Steps too long to look over: three times the median where rows are even, ten times the ninth decile where they
    /// are not.
    pub gaps: Vec<Gap>,
}

impl Sampling {
    /// Looks at times [s] that increase strictly.
    pub(super) fn of(time: &[f64]) -> Self {
        let steps: Vec<f64> = differences(time).collect();
        let period = quantile(steps.clone(), 0.5);
        let irregular = steps.iter().filter(|step| (**step - period).abs() > 0.1 * period).count();
        let irregular_share = real(irregular) / real(steps.len().max(1));
        let greatest = if irregular_share < 0.1 { 3.0 * period } else { 10.0 * quantile(steps.clone(), 0.9) };
        let gap = |(after, &length_s): (usize, &f64)| {
            (length_s > greatest).then_some(Gap { after, from_s: time[after], length_s })
        };
        Self {
            period_s: period,
            shortest_s: steps.iter().copied().fold(f64::INFINITY, f64::min),
            longest_s: steps.iter().copied().fold(0.0, f64::max),
            irregular_share,
            gaps: steps.iter().enumerate().filter_map(gap).collect(),
        }
    }

    /// Whether rows are evenly spaced but for gaps.
    pub(super) fn is_even(&self) -> bool {
        self.irregular_share < 0.1
    }
}
