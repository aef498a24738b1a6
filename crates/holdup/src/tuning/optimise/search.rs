//! The search over times and ratios, from many starts, and a sweep that looks for something better.

use rayon::prelude::*;
use thiserror::Error;

use super::design::{Design, Structure};
use super::gain::{Candidate, Gains, OUTSIDE, POLISHED, SEARCHING, SWEEPING};
use super::infeasible::Conflict;
use super::limits::{Limits, Quantity};
use super::objective::Objective;
use super::progress::{self, Progress};
use super::ridge;
use super::simplex::{minimise, search as simplex};
use super::task::Task;
use crate::analysis::frequency::{FrequencyError, Margins};
use crate::analysis::infinite_horizon::InfiniteHorizon;
use crate::model::{Controller, Process};

/// Starts, and one more for each variable.
const STARTS: usize = 2;
/// The same where a limit jumps: there are as many minima as the response has swings.
const STARTS_WITH_JUMPS: usize = 5;
/// Size of the simplex at the end of a search for how near a limit that jumps can be kept.
const ROUGH: f64 = 2e-3;
/// Rounds of searches: the second and later ones from where one ended apart from the best.
const ROUNDS: u64 = 4;
/// Points of the sweep over the whole space, for one variable and for more.
const SWEEP_OF_ONE: usize = 40;
const SWEEP: usize = 160;
/// Points of the sweep about the optimum for each variable, and the widths of the cubes that they fill.
const ABOUT: usize = 15;
const WIDTHS: [f64; 2] = [0.2, 0.02];
/// A coarse search ends at this part of its first size, and is made so often before a fine one.
const COARSE: f64 = 0.15;
const TIMES: usize = 2;
/// Sizes of the simplex: of a search, at its end, and of the polishing of the best, first and where that goes on.
const FIRST: f64 = 0.12;
pub(super) const SEARCHED: f64 = 1e-5;
const LAST: f64 = 1e-3;
const AGAIN: f64 = 0.03;
pub(super) const FINEST: f64 = 1e-8;
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
    /// What ended at an end of the range that is searched, and what has no part in the optimum.
    pub warnings: Vec<String>,
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
    Task::new(process, structure, objective, limits).optimise(&|_| {})
}

/// What the search found.
#[derive(Debug, Clone)]
pub(super) struct Found {
    pub(super) best: Candidate,
    pub(super) parts: Vec<f64>,
    pub(super) starts: usize,
    pub(super) agreeing: usize,
    pub(super) swept: usize,
    pub(super) least_swept: Option<f64>,
}

/// A search that found nothing.
#[derive(Debug, Clone, Copy)]
pub(super) enum Nothing {
    /// No controller met keeps the limits.
    Unkept,
    /// The same; and the least settling time that the other limits allow, `None` where they exclude each other.
    Settles(Option<f64>),
}

/// Sweeps, searches from the best points of the sweep and from others, and sweeps once more about what was found.
pub(super) fn find(
    design: &Design,
    objective: Objective,
    limits: &Limits,
    progress: &Progress<'_>,
) -> Result<Found, Nothing> {
    let count = design.variables.len();
    let with = |precision| Gains::new(design, objective, limits, precision);
    let (sweeping, searching, polish) = (with(SWEEPING), with(SEARCHING), with(POLISHED));
    let points = match count {
        0 => vec![Vec::new()],
        1 => lattice(1, SWEEP_OF_ONE),
        _ => lattice(count, SWEEP),
    };
    let mut sweep = swept(&sweeping, points, progress);
    let settling = Objective::Extreme(Quantity::SetpointSettlingTime);
    let rough = objective == settling;
    if let Some(limit) = limits.of(Quantity::SetpointSettlingTime)
        && !sweep.iter().any(|point| point.keeps)
    {
        // Whether it can be kept at all is a question of its own, which has an answer sooner; and that is a start.
        let others = limits.clone().without(Quantity::SetpointSettlingTime);
        let nearest = find(design, settling, &others, &Progress::silent()).ok();
        match nearest {
            Some(found) if found.best.value <= limit => {
                sweep.splice(0..0, swept(&sweeping, vec![found.parts], &Progress::silent()));
            }
            _ => {
                let nearest = nearest.map(|found| found.best.value);
                return Err(Nothing::Settles(nearest));
            }
        }
    }
    let number = if searching.jumps() { STARTS_WITH_JUMPS } else { STARTS };
    let starts = starts(&sweep, number + count);
    let share = progress::SEARCHES / (ROUNDS * starts.len() as u64).max(1);
    let mut ends: Vec<End> = starts
        .into_par_iter()
        .map(|start| {
            let mut watch = progress.search(share);
            if rough {
                roughly_from(&searching, &start, FIRST, ROUGH, &mut watch)
            } else {
                quickly_from(&searching, &start, FIRST, &mut watch)
            }
        })
        .collect();
    // One that ended apart from the best goes on from there: on kinks a search may end too early.
    for _ in 1..if rough { 1 } else { ROUNDS } {
        let best = ends.iter().map(End::value).fold(f64::INFINITY, f64::min);
        let apart = |end: &End| end.value() > best + AGREE * best.abs() && end.value() < OUTSIDE;
        ends = ends
            .into_par_iter()
            .map(|end| {
                let mut watch = progress.search(share);
                if end.fixed || !apart(&end) {
                    return end;
                }
                let next = search_from(&searching, &end.parts, AGAIN, SEARCHED, &mut watch);
                if next.value() < end.value() { next } else { End { fixed: true, ..end } }
            })
            .collect();
    }
    let kept: Vec<&End> = ends.iter().filter(|end| end.best.is_some()).collect();
    // Where none keeps the limits, the search goes on from the one that comes nearest.
    let nearest = kept.iter().copied().chain(&ends).min_by(|a, b| a.value().total_cmp(&b.value()));
    let mut end = nearest.ok_or(Nothing::Unkept)?.clone();
    // What is found about the optimum is better only where the search ended too early: then it goes on from there.
    let mut sizes = [LAST, AGAIN, AGAIN].into_iter().peekable();
    while let Some(size) = sizes.next() {
        let mut watch = progress.search(progress::END / 4);
        let next = if rough {
            roughly_from(&polish, &end.parts, AGAIN, LAST * ROUGH, &mut watch)
        } else {
            search_from(&polish, &end.parts, size, FINEST, &mut watch)
        };
        drop(watch);
        if next.value() < end.value() {
            end = next;
        }
        let about = swept(&sweeping, about(&end.parts), &Progress::silent());
        let enough = end.value() - AGREE * end.value().abs();
        let better = about.first().filter(|point| point.merit < enough).cloned();
        sweep.extend(about);
        match better {
            Some(point) if sizes.peek().is_some() => {
                end = End { parts: point.parts, best: None, merit: point.merit, fixed: false }
            }
            _ => break,
        }
    }
    let best = end.best.ok_or(Nothing::Unkept)?;
    let least = best.value + AGREE * best.value.abs();
    let agreeing = kept.iter().filter(|end| end.value() <= least).count();
    let least_swept = sweep.iter().map(|point| point.merit).min_by(f64::total_cmp);
    Ok(Found {
        best,
        parts: end.parts,
        starts: kept.len(),
        agreeing,
        swept: sweep.len(),
        least_swept: least_swept.filter(|value| *value < OUTSIDE),
    })
}

/// Where a search ended.
#[derive(Debug, Clone)]
pub(super) struct End {
    pub(super) parts: Vec<f64>,
    /// The best that keeps every limit.
    pub(super) best: Option<Candidate>,
    /// What it is worth, or the least merit met where none keeps them.
    merit: f64,
    /// Whether another search from there leads nowhere.
    fixed: bool,
}

impl End {
    fn value(&self) -> f64 {
        self.best.map_or(self.merit, |best| best.value)
    }
}

/// The local search, to the end.
pub(super) fn search_from(
    gains: &Gains<'_>,
    start: &[f64],
    size: f64,
    finest: f64,
    watch: &mut progress::Search<'_>,
) -> End {
    let mut search = Search::new(gains, watch);
    let last = minimise(start, size, finest, &mut |parts| search.value(parts));
    search.onto_the_ridge();
    search.end(last)
}

/// The same by a coarse simplex and the ridge that it meets; to the end where it meets none.
pub(super) fn quickly_from(
    gains: &Gains<'_>,
    start: &[f64],
    size: f64,
    watch: &mut progress::Search<'_>,
) -> End {
    if start.len() < 2 {
        return search_from(gains, start, size, SEARCHED, watch);
    }
    let mut search = Search::new(gains, watch);
    let (mut near, mut size) = (start.to_vec(), size);
    for _ in 0..TIMES {
        let last = simplex(&near, size, COARSE * size, &mut |parts| search.value(parts));
        if search.onto_the_ridge() {
            return search.end(last);
        }
        near = search.kept.as_ref().map_or(last.0, |kept| kept.0.clone());
        size *= COARSE;
    }
    search_from(gains, &near, size, SEARCHED, watch)
}

/// The local search by a simplex alone.
fn roughly_from(
    gains: &Gains<'_>,
    start: &[f64],
    size: f64,
    finest: f64,
    watch: &mut progress::Search<'_>,
) -> End {
    let mut search = Search::new(gains, watch);
    let by = if start.len() < 2 { minimise } else { simplex };
    let last = by(start, size, finest, &mut |parts| search.value(parts));
    search.end(last)
}

/// The value of designs on the way of a search, each from the gain of the one before it. The least merit may lie a rounding
/// outside of the limits: what counts is the best that keeps them.
struct Search<'a, 'b> {
    gains: &'a Gains<'a>,
    watch: &'a mut progress::Search<'b>,
    known: Option<Candidate>,
    kept: Option<(Vec<f64>, Candidate)>,
}

impl<'a, 'b> Search<'a, 'b> {
    fn new(gains: &'a Gains<'a>, watch: &'a mut progress::Search<'b>) -> Self {
        Self { gains, watch, known: None, kept: None }
    }

    fn value(&mut self, parts: &[f64]) -> f64 {
        self.watch.evaluated();
        let found = self.gains.best_near(parts, self.known);
        self.known = found.candidate().or(self.known);
        let better = |found: &Candidate| {
            found.keeps() && self.kept.as_ref().is_none_or(|(_, kept)| found.value < kept.value)
        };
        if let Some(found) = found.candidate().filter(better) {
            self.kept = Some((parts.to_vec(), found));
        }
        found.merit()
    }

    /// Goes on to what is better on a ridge; whether the optimum lies there.
    fn onto_the_ridge(&mut self) -> bool {
        let found = self.kept.as_ref().and_then(|(parts, best)| ridge::along(self.gains, parts, best));
        let settled = found.as_ref().is_some_and(|found| found.settled);
        self.kept = found.map(|found| (found.parts, found.best)).or(self.kept.take());
        settled
    }

    /// The best that keeps the limits; where none does, what came nearest.
    fn end(self, (parts, merit): (Vec<f64>, f64)) -> End {
        match self.kept {
            Some((parts, best)) => End { parts, best: Some(best), merit, fixed: false },
            None => End { parts, best: None, merit, fixed: false },
        }
    }
}

/// A point of a sweep with its best gain.
#[derive(Debug, Clone)]
struct Swept {
    parts: Vec<f64>,
    merit: f64,
    keeps: bool,
}

/// These points, the best first.
fn swept(gains: &Gains<'_>, points: Vec<Vec<f64>>, progress: &Progress<'_>) -> Vec<Swept> {
    let share = progress::SWEEP / (points.len() as u64).max(1);
    let at = |parts: Vec<f64>| {
        let best = gains.best(&parts);
        progress.add(share);
        let keeps = best.candidate().is_some_and(|found| found.keeps());
        Swept { parts, merit: best.merit(), keeps }
    };
    let mut sweep: Vec<Swept> = points.into_par_iter().map(at).collect();
    sweep.sort_by(|a, b| a.merit.total_cmp(&b.merit));
    sweep
}

/// Points about the optimum, near and nearer.
fn about(parts: &[f64]) -> Vec<Vec<f64>> {
    let count = parts.len();
    let points = if count == 0 { Vec::new() } else { lattice(count, ABOUT * count) };
    let near = |width: f64| {
        let moved = move |(x, part): (&f64, &f64)| (x + width * (part - 0.5)).clamp(0.0, 1.0);
        points.iter().map(move |point| parts.iter().zip(point).map(moved).collect())
    };
    WIDTHS.into_iter().flat_map(near).collect()
}

/// The best points of the sweep, of which half are far from the very best.
fn starts(sweep: &[Swept], count: usize) -> Vec<Vec<f64>> {
    let mut chosen: Vec<Vec<f64>> = Vec::new();
    let distance = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
    for apart in [0.25, 0.0] {
        for point in sweep {
            let new = chosen.iter().all(|known| distance(known, &point.parts) > apart);
            if chosen.len() < count && point.merit.is_finite() && new {
                chosen.push(point.parts.clone());
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
