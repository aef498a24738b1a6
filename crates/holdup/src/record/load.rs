//! The load that explains the rest: what must have entered at the process input.

use serde::Serialize;

use super::Record;
use super::identify::{Joint, Kind, Problem};

/// The load disturbance along a record.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RecoveredLoad {
    /// Times [s].
    #[serde(rename = "time_s")]
    pub time: Vec<f64>,
    /// Load at the process input [input unit], as deviation from its mean.
    pub load: Vec<f64>,
    /// Time over which each value is a mean [s]: faster loads are not seen.
    #[serde(rename = "window_s")]
    pub window: f64,
    /// Standard deviation of the load [input unit].
    pub standard_deviation: f64,
}

/// Least rows in a window.
const LEAST_ROWS: f64 = 5.0;

/// The load of an integrating process: the slope, over a moving window, of what the input does not explain, over the process gain.
///
/// The window balances the measurement noise in a slope against what a wandering load does meanwhile: for white noise of
/// variance s² every h and a wander w the two are equal at (12·s²·h·3/w²)^(1/4). `None` for other kinds.
pub(crate) fn recover_load(record: &Record, problem: &Problem<'_>, joint: &Joint) -> Option<RecoveredLoad> {
    let fit = &joint.fit;
    if !matches!(fit.kind, Kind::Integrating | Kind::IntegratingWithLag) || fit.gain == 0.0 {
        return None;
    }
    let time = record.time();
    let column = problem.at_times(fit.kind.shape(fit.lag), fit.dead_time, time);
    let rest: Vec<f64> =
        record.controlled_variable().iter().zip(&column).map(|(y, v)| y - fit.gain * v).collect();
    let span = time[time.len() - 1] - time[0];
    #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
    let step = span / (time.len() - 1) as f64;
    let noise = joint.noise;
    let measured = noise.white.powi(2) * step + 2.0 * noise.coloured.powi(2) * noise.correlation_time;
    let balanced = (36.0 * measured / noise.wander.powi(2)).powf(0.25);
    let longest = (span / 8.0).max(LEAST_ROWS * step);
    let window = if balanced.is_finite() { balanced } else { longest }.clamp(LEAST_ROWS * step, longest);
    let slopes = moving_slope(time, &rest, window);
    let load: Vec<f64> = slopes.iter().map(|slope| slope / fit.gain).collect();
    #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
    let rows = load.len() as f64;
    let mean = load.iter().sum::<f64>() / rows;
    let load: Vec<f64> = load.iter().map(|value| value - mean).collect();
    let standard_deviation = (load.iter().map(|value| value * value).sum::<f64>() / rows).sqrt();
    Some(RecoveredLoad { time: time.to_vec(), load, window, standard_deviation })
}

/// The slope of the straight line through the rows within half a window of each row.
fn moving_slope(time: &[f64], values: &[f64], window: f64) -> Vec<f64> {
    let (mut from, mut to) = (0, 0);
    // n, Σt, Σt², Σy, Σty, with times from the first row.
    let mut sums = [0.0; 5];
    let add = |sums: &mut [f64; 5], k: usize, sign: f64| {
        let (t, y) = (time[k] - time[0], values[k]);
        for (sum, value) in sums.iter_mut().zip([1.0, t, t * t, y, t * y]) {
            *sum += sign * value;
        }
    };
    (0..time.len())
        .map(|k| {
            // At the ends the window stays whole and leans inwards.
            let first = (time[k] - window / 2.0).clamp(time[0], (time[time.len() - 1] - window).max(time[0]));
            while to < time.len() && time[to] <= first + window * (1.0 + 1e-9) {
                add(&mut sums, to, 1.0);
                to += 1;
            }
            while from < to && time[from] < first - 1e-9 * window {
                add(&mut sums, from, -1.0);
                from += 1;
            }
            let [n, t, tt, y, ty] = sums;
            let slope = (n * ty - t * y) / (n * tt - t * t);
            if slope.is_finite() { slope } else { 0.0 }
        })
        .collect()
}
