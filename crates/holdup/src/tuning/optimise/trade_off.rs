//! The frontier: the best value of the objective for every sensitivity peak.

use super::design::{Design, Structure};
use super::gain::{Candidate, Gains, OUTSIDE, POLISHED};
use super::limits::{Limits, Quantity};
use super::objective::Objective;
use super::search::{OptimiseError, find};
use super::simplex::minimise;
use crate::model::{Controller, Process};

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

/// The best controller for each of these sensitivity peaks, which must rise, under the other limits; a peak that no controller
/// keeps is left out.
///
/// Each point is searched from the one before; the first, the middle and the last also from scratch.
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
    let design = Design::new(process, structure, limits.of(Quantity::NoiseGain).is_some());
    if let Some(reason) = objective.degenerate(&design, limits) {
        return Err(OptimiseError::Degenerate(reason));
    }
    let mut points: Vec<Point> = Vec::new();
    let mut parts: Option<Vec<f64>> = None;
    for (index, &peak) in peaks.iter().enumerate() {
        let limits = limits.clone().with(Quantity::SensitivityPeak, peak);
        let gains = Gains { design: &design, limits: &limits, objective, precision: POLISHED };
        let value = |parts: &[f64]| gains.best(parts).map_or(f64::INFINITY, |found| found.value);
        let mut best: Option<(Vec<f64>, Candidate)> = None;
        if let Some(start) = &parts {
            let (end, _) = minimise(start, 0.03, 1e-6, &value);
            best = gains.best(&end).map(|candidate| (end, candidate));
        }
        let from_scratch = best.is_none() || index == peaks.len() / 2 || index + 1 == peaks.len();
        let found = if from_scratch { find(&design, objective, &limits) } else { None };
        if let Some(found) = found
            && best.as_ref().is_none_or(|(_, known)| found.best.value < known.value)
        {
            best = Some((found.parts, found.best));
        }
        let Some((end, candidate)) = best.filter(|(_, candidate)| candidate.value < OUTSIDE) else {
            continue;
        };
        points.push(Point {
            sensitivity_peak: peak,
            value: candidate.value,
            controller: candidate.controller,
        });
        parts = Some(end);
    }
    Ok(points)
}
