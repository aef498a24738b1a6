//! `pd-exact`: PD control that meets two of gain margin, phase margin and settling time.

use super::curve::{Curve, Margin, Pd};
use super::{Normal, margins, settling};
use crate::model::Process;
use crate::tuning::{Entry, Infeasible, RuleError, Tuning, Values, from_settings};

const TWO: &str = "exactly two of Am, phi_m and Ts must be set";

/// The tuning of the rule.
pub(in crate::tuning) fn tune(
    entry: &'static Entry,
    process: &Process,
    values: &Values<'_>,
) -> Result<Tuning, RuleError> {
    let d = process.dead_time();
    let (am, phi, ts) = (values.given("Am"), values.given("phi_m"), values.given("Ts"));
    // With a settling time the response must be one that can be simulated and built: the derivative is filtered.
    let filter = values.given("N").map_or(if ts.is_some() { 0.01 } else { 0.0 }, |n| 1.0 / (n * d));
    let asked = values.specification();
    let infeasible = |(reason, nearest)| {
        RuleError::Infeasible(Box::new(Infeasible { rule: entry.id, asked, reason, nearest }))
    };
    let settled = |margin: Margin, ts: f64| {
        let curve = Curve { margin, filter };
        settling::solve(curve, ts / d).map_err(|(reason, nearest)| {
            infeasible((
                reason,
                nearest.into_iter().map(|time| settling::specification(curve, time * d)).collect(),
            ))
        })
    };
    let found = match (am, phi, ts) {
        (Some(am), Some(phi), None) => margins::solve(am, phi, filter).map_err(infeasible)?,
        (Some(am), None, Some(ts)) => settled(Margin::Gain(am), ts)?,
        (None, Some(phi), Some(ts)) => settled(Margin::Phase(phi), ts)?,
        _ => return Err(RuleError::Combination { rule: entry.id, reason: TWO }),
    };
    let ranked = rank(entry.id, found, filter)?;
    let mut tunings = ranked.into_iter().map(|pd| finish(entry, values, d, filter, pd));
    let mut best = tunings.next().unwrap_or(Err(RuleError::Combination { rule: entry.id, reason: TWO }))?;
    for other in tunings {
        best.alternatives.push(other?.controller);
    }
    if !best.alternatives.is_empty() {
        best.warnings.push(format!(
            "{} more controllers meet the specification; this one has the least sensitivity peak",
            best.alternatives.len()
        ));
    }
    Ok(best)
}

/// By rising sensitivity peak.
fn rank(rule: &'static str, found: Vec<Pd>, filter: f64) -> Result<Vec<Pd>, RuleError> {
    if found.len() < 2 {
        return Ok(found);
    }
    let mut peaks = Vec::new();
    for pd in found {
        let normal = Normal { gain: pd.gain, derivative: pd.derivative, filter, observer: 0.0 };
        peaks.push((normal.margins(rule)?.sensitivity_peak.unwrap_or(f64::INFINITY), pd));
    }
    peaks.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok(peaks.into_iter().map(|(_, pd)| pd).collect())
}

/// The tuning in the units of the process.
fn finish(
    entry: &'static Entry,
    values: &Values<'_>,
    d: f64,
    filter: f64,
    pd: Pd,
) -> Result<Tuning, RuleError> {
    let mut values = values.clone();
    let bandwidth = values.given("N").unwrap_or(1.0 / (filter * d));
    values.keep("Kc", pd.gain / (values.get("K")? * d));
    values.keep("Td", pd.derivative * d);
    if filter > 0.0 && pd.derivative > 0.0 {
        values.keep("N", bandwidth);
    }
    from_settings(entry, &values)
}
