//! How slowly a loop may be sampled.

use holdup_control::Law;

use super::margins::{is_stable, sampled_margins};
use crate::analysis::frequency::{FrequencyError, Margins, margins};
use crate::model::{ClosedLoop, Controller, NoSampledLaw, Process, Seconds, sampled_law};

/// Whole samples per dead time up to which every span between two whole numbers is examined.
const SPANS: u32 = 48;

/// Powers of two beyond.
const DOUBLINGS: u32 = 6;

/// Parts into which a span is cut where the margin comes near the demand.
const DEPTH: u32 = 6;

/// The largest sample period up to which a demand holds for every smaller one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LargestPeriod {
    /// It does not hold without sampling either.
    None,
    /// Up to here [s].
    UpTo(Seconds),
    /// Up to the dead time [s], the longest period that is considered.
    DeadTime(Seconds),
}

/// The largest sample period up to which what `slack` measures stays at 0 or above, for it and every smaller one; at most the
/// dead time.
///
/// `slack` says by how much a loop of these margins exceeds a demand: `|m| m.gain_margin.map_or(f64::INFINITY, |g| g - 2.0)`. It
/// is not asked about an unstable loop.
///
/// A margin does not fall steadily when samples come slower: it has a wave at every period of which the dead time
/// is a whole multiple. So the search goes upwards from no sampling at all, span by span between those periods, and cuts a span
/// further wherever the parabola through its ends and its middle comes near the demand; the first violation is then
/// bisected to rounding. Every verdict is exact; that none is missed between two of them is made likely, not proven.
///
/// ```
/// use holdup::analysis::frequency::sampled::{LargestPeriod, largest_sample_period};
/// use holdup::model::{Process, notation::read_controller, Seconds};
/// let level = Process::integrating(0.0506, Seconds(6.0))?;
/// let pi = read_controller("Kc=1.647,Ti=48")?;
/// let found = largest_sample_period(&level, &pi, Seconds(0.0), |m| m.gain_margin.map_or(f64::INFINITY, |g| g - 2.5))?;
/// let LargestPeriod::UpTo(Seconds(h)) = found else { panic!("a period") };
/// assert!(h > 1.0 && h < 3.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`PeriodError`] if there is no sampled law, or the numbers are out of the reach of double precision.
pub fn largest_sample_period(
    process: &Process,
    controller: &Controller,
    delay: Seconds,
    slack: impl Fn(&Margins) -> f64,
) -> Result<LargestPeriod, PeriodError> {
    let continuous = margins(&ClosedLoop::new(process, controller))?;
    // Checks that there is a law; only an observer's line depends on the period.
    sampled_law::<f64>(process, controller, Seconds(process.dead_time()))?;
    if !continuous.stable || slack(&continuous) < 0.0 {
        return Ok(LargestPeriod::None);
    }
    let at = |h: f64| {
        let Ok(law) = sampled_law::<f64>(process, controller, Seconds(h)) else { return f64::NEG_INFINITY };
        if !is_stable(&law, process, h, delay) {
            return f64::NEG_INFINITY;
        }
        slack_of(&law, process, h, delay, &slack)
    };
    Ok(first_violation(process.dead_time(), at))
}

/// The largest sample period up to which the loop is stable, for it and every smaller one; see
/// [`largest_sample_period`].
///
/// # Errors
/// As [`largest_sample_period`].
pub(crate) fn largest_stable_period(
    process: &Process,
    law: impl Fn(f64) -> Option<Law<f64>>,
    delay: Seconds,
) -> Option<f64> {
    let at = |h: f64| law(h).filter(|law| is_stable(law, process, h, delay)).map_or(-1.0, |_| 1.0);
    match first_violation(process.dead_time(), at) {
        LargestPeriod::UpTo(Seconds(h)) => Some(h),
        LargestPeriod::DeadTime(_) | LargestPeriod::None => None,
    }
}

fn slack_of(
    law: &Law<f64>,
    process: &Process,
    h: f64,
    delay: Seconds,
    slack: &impl Fn(&Margins) -> f64,
) -> f64 {
    match sampled_margins(law, process, Seconds(h), delay) {
        Ok(found) if found.margins.stable => slack(&found.margins),
        _ => f64::NEG_INFINITY,
    }
}

/// The first period at which `at` is negative, going up to `longest`.
fn first_violation(longest: f64, at: impl Fn(f64) -> f64) -> LargestPeriod {
    let beyond = (1..=DOUBLINGS).rev().map(|i| longest / (f64::from(SPANS) * 2f64.powi(i.cast_signed())));
    let spans = (1..=SPANS).rev().map(|samples| longest / f64::from(samples));
    let mut before = None;
    for h in beyond.chain(spans) {
        let here = at(h);
        let Some((from, slack)) = before.replace((h, here)) else {
            if here < 0.0 {
                // Between the fastest sampling that is looked at and none at all.
                return LargestPeriod::UpTo(Seconds(bisected(0.0, h, &at)));
            }
            continue;
        };
        if let Some(found) = within((from, slack), (h, here), DEPTH, &at) {
            return LargestPeriod::UpTo(Seconds(found));
        }
    }
    LargestPeriod::DeadTime(Seconds(longest))
}

/// The first violation between two periods, the slack at the first of which is not negative.
fn within(
    (from, first): (f64, f64),
    (to, last): (f64, f64),
    depth: u32,
    at: &impl Fn(f64) -> f64,
) -> Option<f64> {
    let middle = f64::midpoint(from, to);
    let half = at(middle);
    if half < 0.0 || last < 0.0 {
        let left = if half < 0.0 { (middle, half) } else { (to, last) };
        let start = if half < 0.0 { (from, first) } else { (middle, half) };
        // An earlier one may hide before it.
        if depth > 0
            && left.0 - start.0 > 1e-3 * to
            && let Some(found) = within(start, left, depth - 1, at)
        {
            return Some(found);
        }
        return Some(bisected(start.0, left.0, at));
    }
    // Least value of the parabola through the three.
    let (slope, bend) = (0.5 * (last - first), 0.5 * (first + last) - half);
    let vertex = if bend > 0.0 { (-0.5 * slope / bend).clamp(-1.0, 1.0) } else { -slope.signum() };
    let least = half + vertex * (slope + vertex * bend);
    let range = (first - half).abs().max((last - half).abs());
    if depth == 0 || least > range || !range.is_finite() {
        return None;
    }
    within((from, first), (middle, half), depth - 1, at)
        .or_else(|| within((middle, half), (to, last), depth - 1, at))
}

/// Where the verdict changes, to rounding.
fn bisected(mut holds: f64, mut fails: f64, at: &impl Fn(f64) -> f64) -> f64 {
    while fails - holds > 1e-13 * fails {
        let middle = f64::midpoint(holds, fails);
        if middle <= holds || middle >= fails {
            break;
        }
        if at(middle) < 0.0 {
            fails = middle;
        } else {
            holds = middle;
        }
    }
    holds
}

/// Why there is no largest sample period.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PeriodError {
    /// There is no sampled law.
    #[error(transparent)]
    Law(#[from] NoSampledLaw),
    /// The numbers of the loop are out of reach.
    #[error(transparent)]
    Frequency(#[from] FrequencyError),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_of_several_violations_is_found() {
        // A dip of width 0.02 about 2.1 and a fall from 4 on.
        let slack = |h: f64| (((h - 2.1) / 0.2).powi(2) - 0.0025).min(4.0 - h);
        let LargestPeriod::UpTo(Seconds(found)) = first_violation(6.0, slack) else { panic!() };
        assert!((found - 2.09).abs() < 1e-9, "{found}");
        assert_eq!(first_violation(6.0, |_| 1.0), LargestPeriod::DeadTime(Seconds(6.0)));
    }
}
