//! The optimum where several limits are reached at once: there they are equations, and only what they leave free is searched.
//!
//! A peak is the greatest of several, and so the limit on it has kinks; but each peak alone is a smooth function of the
//! settings. Where as many limits and peaks are reached as there are settings to solve them for, the others are searched
//! without a kink: the generalised reduced gradient (J. Abadie and J. Carpentier, in: R. Fletcher (ed.), Optimization, 1969,
//! 37–47).

mod linear;
mod piece;

use std::cell::RefCell;

use super::gain::{Candidate, Gains};
use super::quasi_newton::follow;
use super::simplex::minimise;
use crate::model::Controller;
use linear::{pivots, solved};
use piece::{Piece, pieces};

/// Size of the first simplex of what is left free, and at its end.
const FIRST: f64 = 0.01;
const FINEST: f64 = 1e-7;
/// The limits are kept by this much, relative, and reached to half of it.
const KEPT: f64 = 4e-12;
/// What exceeding the limits within the rounding of a search may gain, relative.
const ROUNDING: f64 = 1e-7;
/// Steps of Newton's method.
const STEPS: usize = 12;
/// Difference that makes a slope of the value along the ridge.
const SLOPE: f64 = 1e-5;
/// Difference that makes a slope.
const DIFFERENCE: f64 = 1e-6;
/// The gain is searched from this factor below to as much above.
const RANGE: f64 = 2.0;

/// What lies on the ridge.
pub(super) struct Ridged {
    pub(super) parts: Vec<f64>,
    pub(super) best: Candidate,
    /// Whether every limit that is reached costs something there: nothing next to it is better.
    pub(super) settled: bool,
}

/// A better controller on the ridge about this one, if there is one.
pub(super) fn along(gains: &Gains<'_>, parts: &[f64], from: &Candidate) -> Option<Ridged> {
    let settings = Settings { gains, gain: from.gain };
    let mut start: Vec<f64> = parts.iter().copied().chain([0.5]).collect();
    let mut reached = pieces(&settings, &start);
    // The least merit may lie a rounding outside of the limits: what keeps them is worth that.
    let mut least = if from.excess > 0.0 { from.value + ROUNDING * from.value.abs() } else { from.value };
    let mut ridged: Option<Ridged> = None;
    // One limit alone has no kink, and the gain reaches it.
    while reached.len() > 1 {
        let ridge = Ridge::new(&settings, &start, &reached);
        let found = ridge.as_ref().and_then(|ridge| Some((ridge, ridge.least()?)));
        let Some((ridge, (at, best))) = found else {
            // With one less: the one that is farthest from being reached.
            reached.pop();
            continue;
        };
        let left = ridge.best_left(&at);
        if best.value < least {
            least = best.value;
            ridged = Some(Ridged { parts: self::parts(&at).to_vec(), best, settled: left.is_none() });
        }
        start = at;
        match left {
            Some(piece) => drop(reached.remove(piece)),
            None => break,
        }
    }
    ridged
}

/// All settings as numbers from 0 to 1: the parts, and the gain about that of the start.
struct Settings<'a> {
    gains: &'a Gains<'a>,
    gain: f64,
}

impl Settings<'_> {
    fn gain(&self, of: &[f64]) -> f64 {
        self.gain * RANGE.powf(2.0 * of[of.len() - 1] - 1.0)
    }

    fn candidate(&self, at: &[f64]) -> Option<Candidate> {
        self.gains.candidate(parts(at), self.gain(at))
    }

    fn controller(&self, at: &[f64]) -> Option<Controller> {
        self.gains.design.controller(parts(at), self.gain(at)).ok()
    }
}

fn parts(of: &[f64]) -> &[f64] {
    &of[..of.len() - 1]
}

/// Pieces that are reached, and the settings that are solved for.
struct Ridge<'a> {
    settings: &'a Settings<'a>,
    pieces: &'a [Piece],
    start: Vec<f64>,
    solved_for: Vec<usize>,
    free: Vec<usize>,
    /// Slopes over what is solved for, at a neighbour.
    known: RefCell<Option<Vec<Vec<f64>>>>,
}

impl<'a> Ridge<'a> {
    fn new(settings: &'a Settings<'a>, start: &[f64], pieces: &'a [Piece]) -> Option<Self> {
        let all: Vec<usize> = (0..start.len()).collect();
        let mut ridge = Self {
            settings,
            pieces,
            start: start.to_vec(),
            solved_for: Vec::new(),
            free: all.clone(),
            known: RefCell::new(None),
        };
        let slopes = ridge.slopes(start, &all)?;
        ridge.solved_for = pivots(&slopes)?;
        ridge.free.retain(|index| !ridge.solved_for.contains(index));
        Some(ridge)
    }

    /// By how much every piece exceeds its limit, relative.
    fn excess(&self, at: &[f64]) -> Option<Vec<f64>> {
        self.pieces.iter().map(|piece| piece.excess(self.settings, at)).collect()
    }

    /// Slopes of every piece, over these settings.
    fn slopes(&self, at: &[f64], over: &[usize]) -> Option<Vec<Vec<f64>>> {
        let mut rows = vec![Vec::new(); self.pieces.len()];
        for &axis in over {
            let (mut up, mut down) = (at.to_vec(), at.to_vec());
            up[axis] = (at[axis] + DIFFERENCE).min(1.0);
            down[axis] = (at[axis] - DIFFERENCE).max(0.0);
            let (above, below) = (self.excess(&up)?, self.excess(&down)?);
            for (row, (above, below)) in rows.iter_mut().zip(above.iter().zip(below)) {
                row.push((above - below) / (up[axis] - down[axis]));
            }
        }
        Some(rows)
    }

    /// The settings at which every piece is reached, from those of a neighbour.
    fn reached(&self, mut at: Vec<f64>) -> Option<Vec<f64>> {
        let mut slopes = self.known.borrow_mut();
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let excess: Vec<f64> = self.excess(&at)?.iter().map(|excess| excess + KEPT).collect();
            let most = excess.iter().map(|excess| excess.abs()).fold(0.0, f64::max);
            if most <= 0.5 * KEPT {
                return Some(at);
            }
            if slopes.is_none() || most > 0.1 * last {
                *slopes = Some(self.slopes(&at, &self.solved_for)?);
            }
            last = most;
            let step = solved(slopes.clone()?, excess)?;
            for (axis, step) in self.solved_for.iter().zip(step) {
                at[*axis] -= step;
                if !(0.0..=1.0).contains(&at[*axis]) {
                    return None;
                }
            }
        }
        None
    }

    /// The best on the ridge.
    fn least(&self) -> Option<(Vec<f64>, Candidate)> {
        let mut near = self.reached(self.start.clone())?;
        let mut best: Option<(Vec<f64>, Candidate)> = None;
        let mut value = |free: &[f64]| {
            let mut at = near.clone();
            for (axis, part) in self.free.iter().zip(free) {
                at[*axis] = *part;
            }
            let Some(at) = self.reached(at) else { return f64::INFINITY };
            let slack = self.settings.gains.slack(parts(&at), self.settings.gain(&at));
            let Some(found) = self.settings.candidate(&at).filter(|_| slack.is_finite()) else {
                return f64::INFINITY;
            };
            let found = Candidate { excess: found.excess + (-slack).max(0.0), at_end: true, ..found };
            if found.excess == 0.0 && best.as_ref().is_none_or(|best| found.value < best.1.value) {
                best = Some((at.clone(), found));
            }
            near = at;
            found.merit()
        };
        let start: Vec<f64> = self.free.iter().map(|axis| self.start[*axis]).collect();
        let first = value(&start);
        match start.len() {
            0 => {}
            1 => drop(minimise(&start, FIRST, FINEST, &mut value)),
            // Without kinks.
            _ => drop(follow((start, first), SLOPE, &mut value)),
        }
        best
    }

    /// The piece whose limit is best left, if any: at the optimum each costs something.
    fn best_left(&self, at: &[f64]) -> Option<usize> {
        let value = |at: &[f64]| self.settings.candidate(at).map(|found| found.value);
        let slope = |axis: &usize| {
            let (mut up, mut down) = (at.to_vec(), at.to_vec());
            up[*axis] = (at[*axis] + DIFFERENCE).min(1.0);
            down[*axis] = (at[*axis] - DIFFERENCE).max(0.0);
            Some((value(&up)? - value(&down)?) / (up[*axis] - down[*axis]))
        };
        let falls: Option<Vec<f64>> =
            self.solved_for.iter().map(|axis| slope(axis).map(|slope| -slope)).collect();
        let slopes = self.slopes(at, &self.solved_for)?;
        let turned = (0..slopes.len()).map(|i| slopes.iter().map(|row| row[i]).collect()).collect();
        let prices = solved(turned, falls?)?;
        let least = (0..prices.len()).min_by(|&a, &b| prices[a].total_cmp(&prices[b]))?;
        (prices[least] < 0.0).then_some(least)
    }
}
