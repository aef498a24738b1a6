//! Sudden changes of the load, found one after the other, each of which must pay for itself.
//!
//! A load that steps bends the level: its column is the answer of the process to a step. Of all rows the one is taken whose
//! column explains most of what is left. The noise is estimated anew with it, because a step that is not seen passes for
//! a load that wanders; and a load that wanders passes for a step. A column of no meaning with the four numbers of the noise
//! (colour, its time, walk, wander) raises twice the logarithm of the likelihood over that of the true noise by at most a χ² of five
//! degrees of freedom, and the best of n rows by more than c with a probability of at most n·P(χ²₅ > c), whatever the
//! rows have in common (Bonferroni's inequality): a step counts only beyond the c at which that is [`FALSE_ALARM`], and so
//! for two and three at once.

use super::joint::{Joint, joint, with_noise};
use super::noise::{Noise, Whitener};
use super::problem::{Problem, StepTime, Whitened};
use super::squares::dot;

/// Most steps that are looked for.
pub(crate) const MOST: usize = 3;

/// Probability, at most, of a step in a record whose load has none, under the fitted noise.
pub(crate) const FALSE_ALARM: f64 = 0.01;

/// Rows at either end in which a step cannot be told from the initial state, or has no time to show.
const MARGIN: usize = 5;

/// Rows that are looked at in a first pass.
const TRIED: usize = 400;

/// Share of the slow parts of the noise that may be a step's doing.
const SLOW: f64 = 0.05;

/// A fit with the steps of the load that were found.
pub(crate) struct Stepped<'r> {
    pub(crate) problem: Problem<'r>,
    pub(crate) joint: Joint,
}

/// A problem with some steps, and how likely it is with the noise that goes with them.
struct Tried<'r> {
    problem: Problem<'r>,
    noise: Noise,
    likelihood: f64,
}

/// The fit with up to `most` steps of the load; none where none pays for itself.
///
/// Two steps may hide each other: what the second leaves makes the first look like a load that wanders. So steps are
/// added before they are judged, and those count that pay for themselves beside all fewer ones.
pub(crate) fn with_load_steps<'r>(
    problem: &Problem<'r>,
    start: &Joint,
    step: f64,
    greatest: f64,
    most: usize,
) -> Option<Stepped<'r>> {
    if problem.len() < 4 * MARGIN {
        return None;
    }
    #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
    let rows = (problem.len() - 2 * MARGIN) as f64;
    // The noise without and with steps is found from the same starts.
    let without = with_noise(problem, start.fit, None).likelihood.max(start.likelihood);
    let mut path = vec![Tried { problem: problem.clone(), noise: start.noise, likelihood: without }];
    while path.len() <= most {
        let last = &path[path.len() - 1];
        let Some(mut next) = with_one_more(last, start) else { break };
        if 2.0 * (next.likelihood - last.likelihood) < threshold(1, rows) / 2.0 {
            break;
        }
        // Where the others are now may not be where they are best.
        for index in 0..next.problem.load_steps.len() - 1 {
            let mut fewer = next.problem.clone();
            fewer.load_steps.remove(index);
            let fewer = Tried { problem: fewer, ..next };
            next = match with_one_more(&fewer, start) {
                Some(moved) if moved.likelihood > next.likelihood => moved,
                _ => Tried { problem: next.problem, ..fewer },
            };
        }
        path.push(next);
    }
    let pays = |more: usize| {
        (0..more).all(|fewer| {
            2.0 * (path[more].likelihood - path[fewer].likelihood) > threshold(more - fewer, rows)
        })
    };
    let count = (1..path.len()).rev().find(|count| pays(*count))?;
    let Tried { mut problem, noise, .. } = path.swap_remove(count);
    for index in 0..count {
        let known = Joint { noise, ..*start };
        let time = problem.load_steps.remove(index).time;
        let time = refined(&problem, &known, time);
        problem.load_steps.insert(index, StepTime { time, uncertain: true });
    }
    let joint = joint(&problem, start.fit.kind, step, greatest, &[noise])?;
    Some(Stepped { problem, joint })
}

/// The most likely place of one more step.
fn with_one_more<'r>(known: &Tried<'r>, start: &Joint) -> Option<Tried<'r>> {
    let of = Joint { noise: known.noise, ..*start };
    let tried = candidates(&known.problem, &of).into_iter().map(|time| {
        let problem = known.problem.with_load_step(StepTime { time, uncertain: false });
        let found = with_noise(&problem, start.fit, None);
        Tried { problem, noise: found.noise, likelihood: found.likelihood }
    });
    tried.max_by(|a, b| a.likelihood.total_cmp(&b.likelihood))
}

/// How much twice the logarithm of the likelihood must rise for so many steps at any of so many rows.
///
/// n^m/m! places, each with a probability P(χ² > c) of 4 + m degrees of freedom: together [`FALSE_ALARM`].
fn threshold(steps: usize, rows: f64) -> f64 {
    let places = (1..=steps).fold(1.0, |places, m| {
        #[expect(clippy::cast_precision_loss, reason = "at most three")]
        let m = m as f64;
        places * rows / m
    });
    // The tail falls with c: halving, up to what 10⁹⁹ places would need.
    let (mut low, mut high) = (0.0, 500.0);
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if places * tail(4 + steps, middle) > FALSE_ALARM {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// P(χ² > c): the sum over every second number of degrees, from 2 as e^(−c/2), or from 1 by its bound √(2/(πc))·e^(−c/2), which is
/// below a fifteenth of the whole from c = 10 and 5 degrees on.
fn tail(freedom: usize, c: f64) -> f64 {
    let odd = freedom % 2 == 1;
    let mut term = if odd { (2.0 / (std::f64::consts::PI * c)).sqrt() } else { 1.0 };
    let (mut sum, mut degrees) = (term, if odd { 1.0 } else { 2.0 });
    for _ in 1..freedom.div_ceil(2) {
        term *= c / degrees;
        sum += term;
        degrees += 2.0;
    }
    sum * (-c / 2.0).exp()
}

/// The times at which a step explains most under the noise as it is, and under a noise without slow parts.
fn candidates(problem: &Problem<'_>, known: &Joint) -> Vec<f64> {
    let noise = &known.noise;
    let quiet = Noise {
        white: noise.white.hypot(SLOW * noise.coloured).max(SLOW * noise.walk * problem.step().sqrt()),
        walk: SLOW * noise.walk,
        wander: SLOW * noise.wander,
        ..*noise
    };
    let middle = Noise { wander: SLOW.sqrt() * noise.wander, walk: SLOW.sqrt() * noise.walk, ..*noise };
    let rows = MARGIN..problem.len() - MARGIN;
    let stride = rows.len().div_ceil(TRIED);
    let mut found: Vec<f64> = Vec::new();
    for noise in [noise, &middle, &quiet] {
        let explained = Explained::new(problem, known, noise);
        let best = |rows: &mut dyn Iterator<Item = usize>| {
            rows.map(|row| (explained.by(problem.times[row]), row)).max_by(|a, b| a.0.total_cmp(&b.0))
        };
        let Some((_, near)) = best(&mut rows.clone().step_by(stride)) else { continue };
        let around = near.saturating_sub(stride).max(rows.start)..(near + stride + 1).min(rows.end);
        let Some((_, row)) = best(&mut around.clone()) else { continue };
        let time = problem.times[row];
        if !found.contains(&time) {
            found.push(time);
        }
    }
    found
}

/// The time between rows that explains most.
fn refined(problem: &Problem<'_>, known: &Joint, time: f64) -> f64 {
    let explained = Explained::new(problem, known, &known.noise);
    let step = problem.step();
    let (mut best, mut reach) = ((explained.by(time), time), 2.0 * step);
    while reach > 0.05 * step {
        let at = best.1;
        for place in -4_i8..=4 {
            let tried = at + reach * f64::from(place) / 4.0;
            let inside = tried > problem.times[0] && tried < problem.times[problem.len() - 1];
            if inside && explained.by(tried) > best.0 {
                best = (explained.by(tried), tried);
            }
        }
        reach /= 3.0;
    }
    best.1
}

/// How much of the response a step explains beside the columns of a fit.
struct Explained<'p, 'r> {
    problem: &'p Problem<'r>,
    known: &'p Joint,
    whitener: Whitener,
    basis: super::squares::Basis,
    response: Vec<f64>,
}

impl<'p, 'r> Explained<'p, 'r> {
    fn new(problem: &'p Problem<'r>, known: &'p Joint, noise: &Noise) -> Self {
        let fit = &known.fit;
        let whitener = Whitener::new(noise, &problem.times);
        let whitened = Whitened::new(problem, &whitener, fit.kind);
        let (mut basis, response) = whitened.rest(fit.lag);
        let column = whitened.column(fit.kind.shape(fit.lag), fit.dead_time);
        basis.add(column);
        let response = basis.projected(response);
        Self { problem, known, whitener, basis, response }
    }

    /// The squares that the column of a step at this time takes away.
    fn by(&self, time: f64) -> f64 {
        let [column, _] = self.problem.load_column(self.known.fit.kind, self.known.fit.lag, time);
        let whole = self.whitener.whiten(column);
        let before = dot(&whole, &whole);
        let column = self.basis.projected(whole);
        let own = dot(&column, &column);
        // A column that the others span explains nothing but rounding.
        if own <= 1e-12 * before {
            return 0.0;
        }
        dot(&column, &self.response).powi(2) / own
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// χ² of five degrees of freedom from tables: 20.515 for 0.001, 25.745 for 0.0001; of six 33.107 for 0.00001, of seven 29.878
    /// for 0.0001. 1 %: the bound on the last term.
    #[test]
    fn the_threshold_bounds_the_false_alarm() {
        for (steps, places, c) in
            [(1, 10.0, 20.515), (1, 100.0, 25.745), (2, 1000.0, 33.107), (3, 100.0, 29.878)]
        {
            // Rows whose power over the factorial is the number of places.
            let rows = match steps {
                1 => places,
                2 => f64::sqrt(2.0 * places),
                _ => f64::cbrt(6.0 * places),
            };
            assert!((threshold(steps, rows) / c - 1.0).abs() < 0.01, "{steps}: {}", threshold(steps, rows));
        }
    }
}
