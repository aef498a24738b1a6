//! Dead time, lag, gain and noise together: the noise whitens the fit, the fit leaves the noise.

use super::kind::Kind;
use super::noise::{Noise, Whitener};
use super::problem::{Fit, Problem, Whitened};
use super::search::{polish, search};
use super::squares::dot;
use super::strength::estimate;

/// A share of the response's squares that is rounding, not noise.
const ROUNDING: f64 = 1e-20;

/// Rounds between fit and noise, at most.
const ROUNDS: usize = 4;

/// A fit with the noise that goes with it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Joint {
    pub(crate) fit: Fit,
    pub(crate) noise: Noise,
    /// ln of the likelihood at its maximum over the linear coefficients and the noise's overall strength.
    pub(crate) likelihood: f64,
    /// Rows less fitted numbers.
    pub(crate) freedom: f64,
}

impl Joint {
    /// The whitener of the noise.
    pub(crate) fn whitener(&self, problem: &Problem<'_>) -> Whitener {
        Whitener::new(&self.noise, &problem.times)
    }
}

/// The best fit of a kind with the noise estimated from what it leaves. Starts from `start` noises, each searched globally;
/// the most likely wins and is repeated until the dead time stays.
pub(crate) fn joint(
    problem: &Problem<'_>,
    kind: Kind,
    step: f64,
    greatest: f64,
    starts: &[Noise],
) -> Option<Joint> {
    let mut best: Option<Joint> = None;
    for start in starts {
        let whitener = Whitener::new(start, &problem.times);
        let Some(fit) = search(&Whitened::new(problem, &whitener, kind), step, greatest) else { continue };
        let found = with_noise(problem, fit, None);
        if best.is_none_or(|best| found.likelihood > best.likelihood) {
            best = Some(found);
        }
    }
    let mut best = best?;
    for _ in 0..ROUNDS {
        if exact(problem, &best.fit) {
            break;
        }
        let whitener = best.whitener(problem);
        let whitened = Whitened::new(problem, &whitener, kind);
        let Some(fit) = search(&whitened, step, greatest) else { break };
        let found = with_noise(problem, fit, Some(&best.noise));
        let settled = (found.fit.dead_time - best.fit.dead_time).abs() < 1e-3 * step;
        if found.likelihood <= best.likelihood + 1e-3 && !settled {
            break;
        }
        best = found;
        if settled {
            break;
        }
    }
    // The fit of the noise that is reported, to the last digit.
    let whitener = best.whitener(problem);
    let fit = polish(&Whitened::new(problem, &whitener, kind), best.fit, greatest, true);
    Some(Joint { fit, ..best })
}

/// Whether a fit leaves rounding only.
pub(crate) fn exact(problem: &Problem<'_>, fit: &Fit) -> bool {
    let whitener = Whitener::new(&Noise::WHITE, &problem.times);
    let whitened = Whitened::new(problem, &whitener, fit.kind);
    let own = whitened.at(fit.dead_time, fit.lag);
    own.squares <= ROUNDING * dot(&problem.response, &problem.response)
}

/// The noise that a fit leaves, and how likely the two are.
pub(crate) fn with_noise(problem: &Problem<'_>, fit: Fit, near: Option<&Noise>) -> Joint {
    let mut columns = problem.own_columns(fit.kind, fit.lag);
    columns.push(problem.column(fit.kind.shape(fit.lag), fit.dead_time));
    #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
    let (rows, fitted) = (problem.len() as f64, (columns.len() + 1) as f64);
    let freedom = (rows - fitted - f64::from(u8::from(fit.kind.has_lag()))).max(1.0);
    let noise = if exact(problem, &fit) {
        let white = Whitener::new(&Noise::WHITE, &problem.times);
        let squares = Whitened::new(problem, &white, fit.kind).at(fit.dead_time, fit.lag).squares;
        Noise::WHITE.scaled((squares / rows).sqrt().max(f64::MIN_POSITIVE.sqrt()))
    } else {
        estimate(&problem.times, &columns, &problem.response, near).0
    };
    let whitener = Whitener::new(&noise, &problem.times);
    let fit = Whitened::new(problem, &whitener, fit.kind).at(fit.dead_time, fit.lag);
    let likelihood =
        -0.5 * (rows * (fit.squares.max(f64::MIN_POSITIVE) / rows).ln() + whitener.log_determinant());
    Joint { fit, noise, likelihood, freedom }
}

/// The noises that a search starts from: measurement noise alone, a level that walks, a load that wanders.
pub(crate) fn starting_noises(step: f64) -> [Noise; 3] {
    [
        Noise::WHITE,
        Noise { walk: 1.0 / step.sqrt(), ..Noise::WHITE },
        Noise { wander: 0.1 / (step * step.sqrt()), ..Noise::WHITE },
    ]
}
