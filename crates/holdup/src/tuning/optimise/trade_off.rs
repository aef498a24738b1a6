//! The frontier: the best value of the objective for every sensitivity peak.

use super::curve::Curve;
use super::design::Structure;
use super::gain::{Gains, SEARCHING};
use super::limits::{Limits, Quantity};
use super::objective::Objective;
use super::progress::Progress;
use super::search::{OptimiseError, find, quickly_from};
use super::task::Task;
use crate::model::{Controller, Process};

/// Size of the simplex that follows the optimum from peak to peak.
const NEAR: f64 = 0.03;

/// One point of the frontier.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// The sensitivity peak that is allowed \[–\].
    pub sensitivity_peak: f64,
    /// The value of the objective.
    pub value: f64,
    /// The controller.
    pub controller: Controller,
}

/// Steps of [`between`] from one point to the next.
const PARTS: u32 = 8;

/// The frontier between its points, for a picture: sensitivity peaks and values on a monotone cubic in the logarithms of value and
/// M_s − 1. Chords would pass above rules that are nearly best. The points themselves are on it.
///
/// ```
/// use holdup::model::{Process, Seconds};
/// use holdup::tuning::optimise::{Limits, Objective, Structure, between, trade_off};
/// let process = Process::integrating(1.0, Seconds(1.0))?;
/// let of = |peaks: &[f64]| trade_off(&process, Structure::P, Objective::SetpointIae, &Limits::default(), peaks);
/// let (peaks, values) = between(&of(&[1.2, 1.3, 1.4])?);
/// let place = peaks.iter().position(|peak| (peak - 1.25).abs() < 1e-12).unwrap();
/// assert!((values[place] / of(&[1.25])?[0].value - 1.0).abs() < 2e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn between(points: &[Point]) -> (Vec<f64>, Vec<f64>) {
    let (peaks, values): (Vec<f64>, Vec<f64>) =
        points.iter().map(|point| (point.sensitivity_peak, point.value)).unzip();
    if peaks.len() < 2 {
        return (peaks, values);
    }
    let curve = Curve::new(&peaks, &values);
    let part = |pair: &[f64]| {
        let (from, to) = (pair[0], pair[1]);
        (0..PARTS).map(move |k| from + (to - from) * f64::from(k) / f64::from(PARTS))
    };
    let fine: Vec<f64> = peaks.windows(2).flat_map(part).chain(peaks.last().copied()).collect();
    let values = fine.iter().map(|peak| curve.at(*peak)).collect();
    (fine, values)
}

/// The best controller for each of these sensitivity peaks, which must rise, under the other limits; a peak that no controller
/// keeps is left out.
///
/// Each point is searched from the one before; the first, the middle and the last also from scratch.
///
/// ```
/// use holdup::model::{Process, Seconds};
/// use holdup::tuning::optimise::{Limits, Objective, Structure, trade_off};
/// let process = Process::integrating(1.0, Seconds(1.0))?;
/// let best = trade_off(&process, Structure::Pi, Objective::LoadIae, &Limits::default(), &[1.5, 1.7])?;
/// // SIMC has 16 at 1.70; more sensitivity buys load rejection.
/// assert!(best[1].value < 16.0 && best[0].value > best[1].value);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`OptimiseError::Degenerate`] where the objective has no optimum.
pub fn trade_off(
    process: &Process,
    structure: Structure,
    objective: Objective,
    limits: &Limits,
    peaks: &[f64],
) -> Result<Vec<Point>, OptimiseError> {
    Task::new(process, structure, objective, limits).trade_off(peaks, &|_| {})
}

impl Task {
    /// The same, with the filter of this task; any limit of it on the sensitivity peak is replaced. `tell` is called with
    /// thousandths of each peak as they are done, a thousand a peak.
    ///
    /// # Errors
    /// As [`trade_off`].
    pub fn trade_off(&self, peaks: &[f64], tell: &(dyn Fn(u64) + Sync)) -> Result<Vec<Point>, OptimiseError> {
        let (design, objective) = (self.design()?, self.objective);
        let mut points: Vec<Point> = Vec::new();
        let mut parts: Option<Vec<f64>> = None;
        for (index, &peak) in peaks.iter().enumerate() {
            let limits = self.limits.clone().with(Quantity::SensitivityPeak, peak);
            let gains = Gains::new(&design, objective, &limits, SEARCHING);
            let (progress, silent) = (Progress::new(tell), Progress::silent());
            let from_last = parts.as_ref().and_then(|start| {
                let end = quickly_from(&gains, start, NEAR, &mut silent.search(0));
                Some((end.parts, end.best?))
            });
            let from_scratch = from_last.is_none() || index == peaks.len() / 2 || index + 1 == peaks.len();
            let found = if from_scratch { find(&design, objective, &limits, &progress).ok() } else { None };
            let found = found.map(|found| (found.parts, found.best));
            let best = from_last.into_iter().chain(found).min_by(|a, b| a.1.value.total_cmp(&b.1.value));
            progress.finish();
            let Some((end, candidate)) = best else { continue };
            points.push(Point {
                sensitivity_peak: peak,
                value: self.proven(&candidate),
                controller: candidate.controller,
            });
            parts = Some(end);
        }
        Ok(points)
    }
}
