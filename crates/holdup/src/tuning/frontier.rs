//! The best load rejection that a structure can have at a given robustness: what a rule is to be compared with.
//!
//! For each sensitivity peak the load IAE is minimised over the settings, on the integrator with K = 1 and d = 1 s
//! (other plain integrators follow by scaling). A fine search, not a proof: Kc is the greatest that keeps the peak,
//! the times are found by a pattern search that follows the optimum from peak to peak. The derivative is unfiltered.

use crate::analysis::frequency::margins;
use crate::analysis::infinite_horizon::{Input, to_infinity};
use crate::model::{ClosedLoop, Controller, Process, Seconds};

/// The step of the pattern search at which it ends [natural logarithm of a time].
const FINEST: f64 = 0.004;

/// Halvings of the interval that holds the greatest gain.
const HALVINGS: u32 = 22;

/// The structure whose settings are searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Structure {
    /// Kc and Ti.
    Pi,
    /// Kc, Ti and Td, ideal form, unfiltered.
    Pid,
}

/// The best controller found for a sensitivity peak, on K = 1, d = 1 s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Best {
    /// The sensitivity peak that is allowed [–].
    pub sensitivity_peak: f64,
    /// Its load IAE over all time [output unit · s].
    pub load_iae: f64,
    /// The controller.
    pub controller: Controller,
}

/// The best load IAE for each of these sensitivity peaks, which must rise; a peak that no controller has is left out.
///
/// ```
/// use holdup::tuning::frontier::{Structure, frontier};
/// let best = frontier(Structure::Pi, &[1.7]);
/// // SIMC has 16 at 1.70.
/// assert!(best[0].load_iae < 16.0 && best[0].load_iae > 0.5);
/// ```
#[must_use]
pub fn frontier(structure: Structure, peaks: &[f64]) -> Vec<Best> {
    let mut times = match structure {
        Structure::Pi => vec![8.0_f64.ln()],
        Structure::Pid => vec![4.0_f64.ln(), 0.4_f64.ln()],
    };
    let mut found: Vec<Best> = Vec::new();
    for &peak in peaks {
        let Some(best) = search(&mut times, peak) else { continue };
        // What is allowed for a lower peak is allowed here, too.
        let best = match found.last() {
            Some(before) if before.load_iae < best.load_iae => Best { sensitivity_peak: peak, ..*before },
            _ => best,
        };
        found.push(best);
    }
    found
}

/// Pattern search over the logarithms of the times, which end at the best.
fn search(times: &mut Vec<f64>, peak: f64) -> Option<Best> {
    let mut best = evaluate(times, peak);
    // A peak that this integral time does not allow is had with a longer one.
    for _ in 0..16 {
        if best.is_some() {
            break;
        }
        times[0] += 0.25;
        best = evaluate(times, peak);
    }
    let mut step = 0.25;
    while step > FINEST {
        let mut improved = false;
        for index in 0..times.len() {
            for direction in [-1.0, 1.0] {
                let mut moved = times.clone();
                moved[index] += direction * step;
                let here = evaluate(&moved, peak);
                if let Some(here) = here.filter(|here| best.is_none_or(|best| here.load_iae < best.load_iae))
                {
                    best = Some(here);
                    *times = moved;
                    improved = true;
                    break;
                }
            }
        }
        if !improved {
            step *= 0.4;
        }
    }
    best
}

/// The controller of these times with the greatest gain that keeps the peak.
fn evaluate(times: &[f64], peak: f64) -> Option<Best> {
    let process = Process::integrating(1.0, Seconds(1.0)).ok()?;
    let with = |gain: f64| {
        let pi = Controller::proportional(gain).ok()?.with_integral_time(Seconds(times[0].exp())).ok()?;
        times.get(1).map_or(Some(pi), |td| pi.with_derivative_time(Seconds(td.exp())).ok())
    };
    let keeps = |gain: f64| {
        let achieved =
            with(gain).and_then(|controller| margins(&ClosedLoop::new(&process, &controller)).ok());
        achieved.and_then(|achieved| achieved.sensitivity_peak).is_some_and(|found| found <= peak)
    };
    // The gains of stable loops lie below π/2 for PI and below some 1.6 for PID.
    let gains: Vec<f64> = (0..40).map(|i| 1.7 * 0.88_f64.powi(i)).collect();
    let first = gains.iter().position(|gain| keeps(*gain))?;
    let (mut low, mut high) = (gains[first], gains[first.checked_sub(1)?]);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if keeps(middle) { low = middle } else { high = middle }
    }
    let controller = with(low)?;
    let load_iae = to_infinity(&process, &controller, Input::Load).ok()?.iae?;
    Some(Best { sensitivity_peak: peak, load_iae, controller })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tuning::ranking::{ORDERS, rank};

    /// The rules of this structure, ideal form without filter, with their peak and their load IAE.
    fn rules(structure: &str) -> Vec<(&'static str, f64, f64)> {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let ranking = rank(&process, &ORDERS[0], |entry| entry.structure == structure);
        let mut rules: Vec<_> = ranking
            .rules
            .iter()
            .filter(|rule| {
                let controller = &rule.tuning.controller;
                controller.derivative_filter().is_none() && controller.output_filter().is_none()
            })
            .filter_map(|rule| Some((rule.entry.id, rule.achieved.sensitivity_peak?, rule.load_iae()?)))
            .filter(|(_, peak, _)| *peak < 3.0)
            .collect();
        rules.sort_by(|a, b| a.1.total_cmp(&b.1));
        rules
    }

    #[test]
    fn no_rule_lies_below_the_frontier_of_its_structure() {
        for (name, structure) in [("PI", Structure::Pi), ("PID", Structure::Pid)] {
            let rules = rules(name);
            let peaks: Vec<f64> = rules.iter().map(|(_, peak, _)| peak * (1.0 + 1e-9)).collect();
            let best = frontier(structure, &peaks);
            assert_eq!(best.len(), rules.len(), "{name}: a rule has a peak that the search has not");
            for ((id, peak, iae), best) in rules.iter().zip(&best) {
                // The times are found to 0.4 %: next to an optimum the IAE then is good to its square.
                assert!(
                    best.load_iae <= iae * (1.0 + 1e-4),
                    "{id}: {iae} at {peak}, found {}",
                    best.load_iae
                );
            }
        }
    }

    #[test]
    fn more_sensitivity_buys_load_rejection_and_no_neighbour_is_better() {
        let best = frontier(Structure::Pi, &[1.4, 2.0]);
        assert!(best[1].load_iae < best[0].load_iae, "{best:?}");
        let ti = best[0].controller.integral_time().unwrap();
        for factor in [0.9, 0.97, 1.03, 1.1] {
            let other = evaluate(&[(ti * factor).ln()], 1.4);
            assert!(other.is_none_or(|other| other.load_iae >= best[0].load_iae));
        }
    }
}
