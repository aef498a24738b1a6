//! The observer gain that gives the whole loop a stated robustness.
//!
//! With a perfect model the loop broken at the process input is `1 + L = (1 + L_pd)·(1 + L_o)`, stable exactly if
//! the PD loop is and k = |K·Ko|·d < π/2. At k → 0 it is as robust as the PD loop, at π/2 not at all. Of the k that
//! meet a goal the largest rejects load best: ∫e = 1/(K·Kc·Ko) after a unit load step.

use std::f64::consts::FRAC_PI_2;

use super::Normal;
use super::goal::Goal;
use super::root::bracket;
use crate::tuning::RuleError;

/// A met goal is met to this: the margins are solved to rounding, and the gain to its last bits.
const MET: f64 = 1e-9;

/// How far inside the edge of the feasible set the nearest feasible value is named, so that asking for it succeeds.
pub(super) const MARGIN_TO_THE_EDGE: f64 = 1e-6;

/// The largest observer gain that meets the goal, or the least error that any observer gain has.
pub(super) fn largest(pd: Normal, goal: Goal, rule: &'static str) -> Result<Result<f64, f64>, RuleError> {
    let error =
        |k: f64| -> Result<f64, RuleError> { Ok(goal.error(&Normal { observer: k, ..pd }.margins(rule)?)) };
    // From the stability limit down, evenly, then by halves: at the end the observer hardly acts.
    let even = (1..40).map(|i| 1.0 - f64::from(i) / 40.0);
    let halves = (1..16).map(|i| 0.025 * 0.5_f64.powi(i));
    let (mut above, mut least) = (FRAC_PI_2, f64::INFINITY);
    let mut above_met = false;
    for k in even.chain(halves).map(|x| FRAC_PI_2 * x) {
        let here = error(k)?;
        least = least.min(here);
        let met = here <= 0.0;
        if met && !above_met {
            let (found, _) = bracket(k, above, 1e-12, |k| error(k).unwrap_or(f64::NAN));
            // Where a crossover appears or vanishes a margin jumps, and the goal is passed without being met.
            if error(found)?.abs() <= MET {
                return Ok(Ok(found));
            }
        }
        (above, above_met) = (k, met);
    }
    Ok(Err(least))
}

/// Loop gain and observer gain that give the loop both a gain margin and a phase margin: of the solutions the one
/// with the best load rejection; where there is none, the nearest phase margin that goes with the gain margin.
pub(super) fn both_margins(
    pd: Normal,
    gain_margin: f64,
    phase_margin: f64,
    rule: &'static str,
) -> Result<Result<Normal, Option<f64>>, RuleError> {
    let Some(edge) = largest_gain(pd, gain_margin, rule)? else { return Ok(Err(None)) };
    let at = |gain: f64| -> Result<Option<(Normal, f64)>, RuleError> {
        let pd = Normal { gain, ..pd };
        let Ok(observer) = largest(pd, Goal::GainMargin(gain_margin), rule)? else { return Ok(None) };
        let whole = Normal { observer, ..pd };
        Ok(Some((whole, Goal::PhaseMargin(phase_margin).error(&whole.margins(rule)?))))
    };
    let mut best: Option<Normal> = None;
    let mut last: Option<(Normal, f64)> = None;
    let mut nearest: Option<f64> = None;
    for i in 1..=40 {
        let here = at(edge * f64::from(i) / 40.0 * (1.0 - 1e-6))?;
        if let (Some((low, before)), Some((high, after))) = (last, here)
            && (before < 0.0) != (after < 0.0)
        {
            let error = |gain: f64| at(gain).ok().flatten().map_or(f64::NAN, |(_, error)| error);
            let (found, _) = bracket(low.gain, high.gain, 1e-13, error);
            let met = at(found)?.filter(|(_, error)| error.abs() <= MET).map(|(whole, _)| whole);
            let better = |whole: &Normal| {
                best.is_none_or(|best| whole.gain * whole.observer > best.gain * best.observer)
            };
            best = met.filter(better).or(best);
        }
        if let Some((_, error)) = here
            && nearest.is_none_or(|least| error.abs() < least.abs())
        {
            nearest = Some(error);
        }
        last = here;
    }
    let phase = |error: f64| phase_margin - error * (1.0 + MARGIN_TO_THE_EDGE);
    Ok(best.ok_or(nearest.map(phase)))
}

/// The loop gain at which the PD loop alone has the gain margin; the margin is inversely proportional to it.
fn largest_gain(pd: Normal, gain_margin: f64, rule: &'static str) -> Result<Option<f64>, RuleError> {
    let probe = Normal { gain: 0.1 / (1.0 + pd.derivative), observer: 0.0, ..pd };
    Ok(probe.margins(rule)?.gain_margin.map(|margin| probe.gain * margin / gain_margin))
}

/// Loop gain and observer gain that reject load best at a stated sensitivity peak; `None` where there are none.
pub(super) fn best_load(pd: Normal, peak: f64, rule: &'static str) -> Result<Option<Normal>, RuleError> {
    let Some(edge) = largest_gain(pd, 1.0, rule)? else { return Ok(None) };
    let at = |gain: f64| -> Result<Normal, RuleError> {
        let pd = Normal { gain, ..pd };
        let observer = largest(pd, Goal::SensitivityPeak(peak), rule)?.unwrap_or(0.0);
        Ok(Normal { observer, ..pd })
    };
    let worth = |whole: &Normal| whole.gain * whole.observer;
    let step = edge / 24.0;
    let mut best = at(step)?;
    for i in 2..24 {
        let here = at(step * f64::from(i))?;
        if worth(&here) > worth(&best) {
            best = here;
        }
    }
    // Golden section between the neighbours: the product is flat at its top, 50 steps reach its rounding.
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = ((best.gain - step).max(step * 1e-3), best.gain + step);
    for _ in 0..40 {
        let (left, right) = (high - ratio * (high - low), low + ratio * (high - low));
        let (at_left, at_right) = (at(left)?, at(right)?);
        let better = if worth(&at_left) > worth(&at_right) {
            high = right;
            at_left
        } else {
            low = left;
            at_right
        };
        if worth(&better) > worth(&best) {
            best = better;
        }
    }
    Ok((worth(&best) > 0.0).then_some(best))
}
