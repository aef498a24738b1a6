//! `pd-exact`: PD control that meets two of gain margin, phase margin and settling time.

use super::curve::Pd;
use super::{Normal, margins};
use crate::model::Process;
use crate::tuning::{Entry, Infeasible, RuleError, Tuning, Values, from_settings};

/// The tuning of the rule.
pub(in crate::tuning) fn tune(
    entry: &'static Entry,
    process: &Process,
    values: &Values<'_>,
) -> Result<Tuning, RuleError> {
    let d = process.dead_time();
    let filter = values.given("N").map_or(0.0, |n| 1.0 / (n * d));
    let asked = values.specification();
    let infeasible = |(reason, nearest)| {
        RuleError::Infeasible(Box::new(Infeasible { rule: entry.id, asked, reason, nearest }))
    };
    let found = match (values.given("Am"), values.given("phi_m"), values.given("Ts")) {
        (Some(am), Some(phi), None) => margins::solve(am, phi, filter).map_err(infeasible)?,
        _ => {
            let reason = "exactly two of Am, phi_m and Ts must be set";
            return Err(RuleError::Combination { rule: entry.id, reason });
        }
    };
    let ranked = rank(entry.id, found, filter)?;
    let mut tunings = ranked.into_iter().map(|pd| finish(entry, values, d, filter, pd));
    let reason = "exactly two of Am, phi_m and Ts must be set";
    let mut best = tunings.next().unwrap_or(Err(RuleError::Combination { rule: entry.id, reason }))?;
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
