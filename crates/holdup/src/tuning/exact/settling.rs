//! PD control with a stated settling time and one stated margin.
//!
//! Along the curve of the margin the settling time is a piecewise smooth function of the derivative time: it jumps
//! where an extremum of the response touches the edge of the 2 % band, and it grows without limit at the far end. The
//! curve is scanned, every change of sign of (settling time − request) is bracketed to the last bits, and the values
//! on both sides of the bracket tell a crossing from a jump. Between the points of the scan local extrema are refined,
//! so that a pair of crossings between two points is found as well.

use super::Normal;
use super::curve::{Curve, Margin, Pd};
use super::root::bracket;
use crate::analysis::response::{Scenario, simulate};
use crate::model::Seconds;
use crate::tuning::Specification;

/// Points of the scan; the settling time of a PD loop has a few branches along the curve.
const POINTS: u32 = 100;

/// Settling time is met to this [dead times].
const MET: f64 = 1e-6;

/// The PD loops of the curve that settle at `target` dead times, or why there is none and what there is.
pub(super) fn solve(curve: Curve, target: f64) -> Result<Vec<Pd>, (String, Vec<Settled>)> {
    let error = |parameter: f64| settling_time(curve.at(parameter), curve.filter, target) - target;
    let mut scan: Vec<(f64, f64)> = points(&curve, target).into_iter().map(|p| (p, error(p))).collect();
    scan = refined(&scan, &error);
    let mut found = Vec::new();
    let mut jumps = Vec::new();
    for pair in scan.windows(2).filter(|pair| (pair[0].1 < 0.0) != (pair[1].1 < 0.0)) {
        let (left, right) = bracket(pair[0].0, pair[1].0, 1e-3 * MET, error);
        let (at_left, at_right) = (error(left), error(right));
        let (parameter, nearest) =
            if at_left.abs() < at_right.abs() { (left, at_left) } else { (right, at_right) };
        if nearest.abs() <= MET && long_settling_time(curve.at(parameter), curve.filter, target) {
            found.push(curve.at(parameter));
        } else {
            jumps.push((at_left, at_right));
        }
    }
    if found.is_empty() { Err(nothing(curve, &scan, &jumps, target)) } else { Ok(found) }
}

/// A settling time that can be had [dead times].
pub(super) type Settled = f64;

fn nothing(curve: Curve, scan: &[(f64, f64)], jumps: &[(f64, f64)], target: f64) -> (String, Vec<Settled>) {
    if jumps.is_empty() {
        let reason = "it is shorter than the least settling time with this margin".to_owned();
        return (reason, least(curve, scan, target).into_iter().collect());
    }
    let below = jumps.iter().map(|jump| jump.0.min(jump.1)).fold(f64::NEG_INFINITY, f64::max);
    let above = jumps.iter().map(|jump| jump.0.max(jump.1)).fold(f64::INFINITY, f64::min);
    let reason = "the settling time jumps past it, as an extremum enters the 2 % band".to_owned();
    (
        reason,
        [below, above].into_iter().filter(|error| error.is_finite()).map(|error| target + error).collect(),
    )
}

/// The least settling time on the curve [dead times].
fn least(curve: Curve, scan: &[(f64, f64)], target: f64) -> Option<Settled> {
    let settled = |parameter: f64, horizon: f64| {
        within(curve.at(parameter), curve.filter, horizon).unwrap_or(f64::INFINITY)
    };
    // The horizon grows until some loop of the scan settles.
    let mut horizon = target + 5.0;
    let (times, index) = loop {
        let times: Vec<_> =
            scan.iter().map(|(parameter, _)| (*parameter, settled(*parameter, horizon))).collect();
        let index = (0..times.len()).min_by(|a, b| times[*a].1.total_cmp(&times[*b].1))?;
        if times[index].1.is_finite() {
            break (times, index);
        }
        if horizon > 1000.0 {
            return None;
        }
        horizon *= 1.5;
    };
    let (mut low, mut high) = (times[index.saturating_sub(1)].0, times[(index + 1).min(times.len() - 1)].0);
    let (mut at, mut best) = times[index];
    for _ in 0..30 {
        let (left, right) = (0.5 * (low + at), 0.5 * (at + high));
        let (at_left, at_right) = (settled(left, best + 5.0), settled(right, best + 5.0));
        if at_left < best {
            (high, at, best) = (at, left, at_left);
        } else if at_right < best {
            (low, at, best) = (at, right, at_right);
        } else {
            (low, high) = (left, right);
        }
    }
    Some(best)
}

/// The parameters of the scan, from Td = 0 to where the slow closed-loop pole near −1/Td alone takes longer than the
/// target.
fn points(curve: &Curve, target: f64) -> Vec<f64> {
    let (first, last) = curve.ends();
    // With gain g at the gain crossover the response takes at least 3/g: below 1/target nothing settles in time.
    let first =
        if matches!(curve.margin, Margin::Phase(_)) { first.max(1.0 / target).min(last) } else { first };
    let span = last - first;
    let enough = |parameter: f64| curve.at(parameter).derivative - target;
    let near_last = last - span * 1e-12;
    let far = if enough(near_last) > 0.0 && enough(first) < 0.0 {
        bracket(first, near_last, 1e-3, enough).1
    } else {
        near_last
    };
    let mut points: Vec<f64> =
        (0..POINTS).map(|i| first + (far - first) * f64::from(i) / f64::from(POINTS)).collect();
    // Towards the far end the derivative time grows like 1/distance: even steps in its logarithm.
    let reach = (last - far) / span;
    if reach > 0.0 {
        let geometric = |i: u32| last - span * reach.powf(f64::from(i) / f64::from(POINTS / 2));
        points.extend((1..=POINTS / 2).map(geometric));
    }
    points.sort_by(|a, b| if last > first { a.total_cmp(b) } else { b.total_cmp(a) });
    points.dedup();
    points
}

/// The scan with the local extrema that face the target refined, where a pair of crossings may hide.
fn refined(scan: &[(f64, f64)], error: &impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let mut all = scan.to_vec();
    for three in scan.windows(3) {
        let [left, middle, right] = [three[0], three[1], three[2]];
        let sign = if middle.1 > 0.0 { 1.0 } else { -1.0 };
        let faces = |other: f64| sign * other >= sign * middle.1;
        // Not far from the target, compared with how much the neighbours differ.
        let near = middle.1.abs() <= 2.0 * (left.1 - middle.1).abs().max((right.1 - middle.1).abs());
        if !(middle.1.is_finite() && faces(left.1) && faces(right.1) && near) {
            continue;
        }
        let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
        let (mut low, mut high) = (left.0, right.0);
        for _ in 0..12 {
            let (a, b) = (high - ratio * (high - low), low + ratio * (high - low));
            let (at_a, at_b) = (error(a), error(b));
            all.extend([(a, at_a), (b, at_b)]);
            if (at_a > 0.0) != (middle.1 > 0.0) || (at_b > 0.0) != (middle.1 > 0.0) {
                break;
            }
            if sign * at_a < sign * at_b { high = b } else { low = a }
        }
    }
    let rising = scan.first().zip(scan.last()).is_some_and(|(first, last)| first.0 < last.0);
    all.sort_by(|a, b| if rising { a.0.total_cmp(&b.0) } else { b.0.total_cmp(&a.0) });
    all
}

/// Settling time [dead times] of a unit setpoint step, derivative on the error; infinite where the response is
/// outside the band a period of its ringing after the target, which is all that the scan must know.
///
/// A response that stays in the band for as long again as it took to get there has settled: short horizons first.
fn settling_time(pd: Pd, filter: f64, target: f64) -> f64 {
    let end = target + 5.0_f64.max(0.15 * target);
    let mut horizon = 20.0;
    while horizon < end {
        if let Some(time) = within(pd, filter, horizon)
            && time <= 0.5 * horizon
        {
            return time;
        }
        horizon *= 3.0;
    }
    within(pd, filter, end).unwrap_or(f64::INFINITY)
}

/// Whether the settling time is still the target when the horizon is much longer.
fn long_settling_time(pd: Pd, filter: f64, target: f64) -> bool {
    within(pd, filter, (4.0 * target).max(100.0)).is_some_and(|time| (time - target).abs() <= MET)
}

fn within(pd: Pd, filter: f64, horizon: f64) -> Option<f64> {
    let closed = Normal { gain: pd.gain, derivative: pd.derivative, filter, observer: 0.0 }.closed().ok()?;
    let scenario = Scenario::unit_setpoint_step(Seconds(horizon)).ok()?;
    simulate(&closed, &scenario).ok()?.metrics.settling_time.map(|Seconds(time)| time)
}

/// The specification of a curve's margin with a settling time [s].
pub(super) fn specification(curve: Curve, settling_time: f64) -> Specification {
    let settling_time = Some(settling_time);
    match curve.margin {
        Margin::Gain(am) => {
            Specification { gain_margin: Some(am), settling_time, ..Specification::default() }
        }
        Margin::Phase(phi) => {
            Specification { phase_margin: Some(phi), settling_time, ..Specification::default() }
        }
    }
}
