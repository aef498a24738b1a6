//! The search over times and ratios, from many starts, and a sweep that looks for something better.

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;
use thiserror::Error;

use super::design::{Design, Structure};
use super::gain::{Candidate, Gains, OUTSIDE, POLISHED, SEARCHING};
use super::infeasible::{Conflict, conflict};
use super::limits::{Limits, Quantity};
use super::objective::Objective;
use super::simplex::minimise;
use crate::analysis::frequency::{FrequencyError, Margins, margins};
use crate::analysis::infinite_horizon::{InfiniteHorizon, Input, to_infinity};
use crate::model::{ClosedLoop, Controller, Process};

/// Starts for each variable, and one more.
const STARTS: usize = 2;
/// Points of the sweep for each variable, as a power.
const SWEEP: usize = 10;
const SWEEP_MOST: usize = 120;
/// Size of the simplex at which a search ends, and at which the polishing of the best does.
const SEARCHED: f64 = 1e-5;
const FINEST: f64 = 1e-9;
/// Relative difference up to which two starts have found the same.
const AGREE: f64 = 1e-5;

/// The best controller found, with what shows that it is the best.
#[derive(Debug, Clone)]
pub struct Optimum {
    /// The controller.
    pub controller: Controller,
    /// The value of the objective.
    pub value: f64,
    /// What the loop achieves, broken at the process input.
    pub achieved: Margins,
    /// Integrals after a unit load step and after a unit setpoint step; absent where they are out of reach.
    pub load: Option<InfiniteHorizon>,
    /// Integrals after a unit setpoint step.
    pub setpoint: Option<InfiniteHorizon>,
    /// Starts of the search that found any controller.
    pub starts: usize,
    /// Those of them that ended at the same value, within 1e-5.
    pub agreeing: usize,
    /// Points of the sweep over the whole space, each with its best gain.
    pub swept: usize,
    /// The least value that the sweep alone met.
    pub least_swept: Option<f64>,
}

/// Why there is no optimum.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum OptimiseError {
    /// The objective has none.
    #[error("{0}")]
    Degenerate(String),
    /// No controller of the structure keeps all limits.
    #[error("{0}")]
    Infeasible(Conflict),
    /// The loop is out of the reach of double precision.
    #[error(transparent)]
    Frequency(#[from] FrequencyError),
}

/// The best controller of a structure for a process under limits.
///
/// ```
/// use holdup::model::{Process, Seconds};
/// use holdup::tuning::optimise::{Limits, Objective, Quantity, Structure, optimise};
/// let process = Process::integrating(1.0, Seconds(1.0))?;
/// let limits = Limits::default().with(Quantity::SensitivityPeak, 1.7);
/// let best = optimise(&process, Structure::Pi, Objective::LoadIae, &limits)?;
/// // SIMC has 16 at M_s = 1.70.
/// assert!(best.value < 15.0 && best.achieved.sensitivity_peak.unwrap() <= 1.7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`OptimiseError`]: the objective has no optimum, the limits exclude each other (says which, and the nearest value), or the
/// numbers are out of reach.
pub fn optimise(
    process: &Process,
    structure: Structure,
    objective: Objective,
    limits: &Limits,
) -> Result<Optimum, OptimiseError> {
    let design = Design::new(process, structure, limits.of(Quantity::NoiseGain).is_some());
    if let Some(reason) = objective.degenerate(&design, limits) {
        return Err(OptimiseError::Degenerate(reason));
    }
    let Some(found) = find(&design, objective, limits) else {
        return Err(OptimiseError::Infeasible(conflict(&design, limits)));
    };
    let controller = found.best.controller;
    let integrals = |input| to_infinity(process, &controller, input).ok();
    Ok(Optimum {
        controller,
        value: found.best.value,
        achieved: margins(&ClosedLoop::new(process, &controller))?,
        load: integrals(Input::Load).filter(|_| structure.rejects_load()),
        setpoint: integrals(Input::Setpoint),
        starts: found.starts,
        agreeing: found.agreeing,
        swept: found.swept,
        least_swept: found.least_swept,
    })
}

/// What the search found.
#[derive(Debug, Clone)]
pub(super) struct Found {
    pub(super) best: Candidate,
    pub(super) parts: Vec<f64>,
    starts: usize,
    agreeing: usize,
    swept: usize,
    least_swept: Option<f64>,
}

/// Sweeps, searches from the best points of the sweep, and from others.
pub(super) fn find(design: &Design, objective: Objective, limits: &Limits) -> Option<Found> {
    let gains = Gains { design, limits, objective, precision: SEARCHING };
    let count = design.variables.len();
    let swept = AtomicUsize::new(0);
    let value = |parts: &[f64]| gains.best(parts).map_or(f64::INFINITY, |found| found.value);
    let points = if count == 0 {
        vec![Vec::new()]
    } else {
        lattice(count, SWEEP.pow(u32::try_from(count).unwrap_or(9)).min(SWEEP_MOST))
    };
    let mut sweep: Vec<(Vec<f64>, f64)> = points
        .into_par_iter()
        .map(|parts| {
            swept.fetch_add(1, Ordering::Relaxed);
            let at = value(&parts);
            (parts, at)
        })
        .collect();
    sweep.sort_by(|a, b| a.1.total_cmp(&b.1));
    let least_swept = sweep.first().map(|point| point.1).filter(|value| *value < OUTSIDE);
    let ends: Vec<(Vec<f64>, f64)> = if count == 0 {
        sweep
    } else {
        starts(&sweep, STARTS * count + 1)
            .into_par_iter()
            .map(|start| minimise(&start, 0.12, SEARCHED, &value))
            .collect()
    };
    let finite: Vec<&(Vec<f64>, f64)> = ends.iter().filter(|end| end.1 < OUTSIDE).collect();
    let (parts, least) = finite.iter().min_by(|a, b| a.1.total_cmp(&b.1)).copied()?.clone();
    let agreeing = finite.iter().filter(|end| end.1 - least <= AGREE * least.abs()).count();
    let gains = Gains { precision: POLISHED, ..gains };
    let value = |parts: &[f64]| gains.best(parts).map_or(f64::INFINITY, |found| found.value);
    let parts = if count == 0 { parts } else { minimise(&parts, 1e-3, FINEST, &value).0 };
    let best = gains.best(&parts)?;
    Some(Found { best, parts, starts: finite.len(), agreeing, swept: swept.into_inner(), least_swept })
}

/// The best points of the sweep, of which half are far from the very best.
fn starts(sweep: &[(Vec<f64>, f64)], count: usize) -> Vec<Vec<f64>> {
    let mut chosen: Vec<Vec<f64>> = Vec::new();
    let distance = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
    for apart in [0.25, 0.0] {
        for (parts, value) in sweep {
            let new = chosen.iter().all(|known| distance(known, parts) > apart);
            if chosen.len() < count && value.is_finite() && new {
                chosen.push(parts.clone());
            }
        }
    }
    chosen
}

/// Points that fill the cube evenly: the generalised golden-ratio sequence.
fn lattice(dimensions: usize, count: usize) -> Vec<Vec<f64>> {
    // The root of x^(n+1) = x + 1.
    let mut root = 1.5_f64;
    for _ in 0..60 {
        #[expect(clippy::cast_precision_loss, reason = "a handful of variables")]
        let power = 1.0 / (dimensions + 1) as f64;
        root = (1.0 + root).powf(power);
    }
    (1..=count)
        .map(|index| {
            let mut step = 1.0;
            (0..dimensions)
                .map(|_| {
                    step /= root;
                    #[expect(clippy::cast_precision_loss, reason = "hundreds of points")]
                    let part = 0.5 + step * index as f64;
                    part.fract()
                })
                .collect()
        })
        .collect()
}
