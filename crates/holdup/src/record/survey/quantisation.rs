//! The smallest step of a signal.

use serde::Serialize;

use super::statistics::{quantile, real};

/// Values that are looked at: more do not make a step clearer.
const LOOKED_AT: usize = 50_000;

/// Share of the distances that must be multiples of the quantum.
const SHARE: f64 = 0.95;

/// A multiple may be off by this share of the quantum: a converter's values are rounded once more when they are
/// written.
const OFF: f64 = 0.1;

/// The steps in which a signal moves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Quantisation {
    /// The step.
    pub quantum: f64,
    /// Different values in the record.
    pub levels: usize,
    /// Share of the distances between neighbouring levels that are multiples of the step.
    pub share: f64,
}

/// The greatest step of which nearly all distances between levels are multiples; none where there is no such step.
/// Every number in a file has a last digit, and that, too, is a step: only its size beside the noise makes it coarse.
pub(super) fn quantisation(values: &[f64]) -> Option<Quantisation> {
    let mut levels: Vec<f64> = values.iter().copied().take(LOOKED_AT).collect();
    levels.sort_by(f64::total_cmp);
    levels.dedup();
    let scale = levels.first()?.abs().max(levels.last()?.abs());
    let apart = |pair: &[f64]| Some(pair[1] - pair[0]).filter(|distance| *distance > 1e-9 * scale);
    let distances: Vec<f64> = levels.windows(2).filter_map(apart).collect();
    if distances.len() < 2 {
        return None;
    }
    let least = distances.iter().copied().fold(f64::INFINITY, f64::min);
    let median = quantile(distances.clone(), 0.5);
    let decimal =
        (0..12).map(|digits| 0.1_f64.powi(digits)).find(|step| multiples(&distances, *step) > 0.999);
    let candidates = [Some(median), Some(least), Some(least / 2.0), decimal];
    candidates
        .into_iter()
        .flatten()
        .map(|step| refined(&distances, step))
        .map(|quantum| Quantisation { quantum, levels: levels.len(), share: multiples(&distances, quantum) })
        // Below this a step is rounding of the sixteenth digit.
        .filter(|found| found.share >= SHARE && found.quantum > 1e-8 * scale)
        .max_by(|a, b| a.quantum.total_cmp(&b.quantum))
}

/// Share of the distances that are multiples of a step.
fn multiples(distances: &[f64], step: f64) -> f64 {
    let near = |distance: &&f64| {
        let ratio = **distance / step;
        ratio > 0.5 && (ratio - ratio.round()).abs() <= OFF
    };
    real(distances.iter().filter(near).count()) / real(distances.len())
}

/// The step by which the distances are multiples in the mean.
fn refined(distances: &[f64], step: f64) -> f64 {
    let counts: f64 = distances.iter().map(|distance| (distance / step).round()).sum();
    if counts > 0.0 { distances.iter().sum::<f64>() / counts } else { step }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Uneven multiples of an irrational-looking number in (0, 1).
    fn scattered(count: usize) -> Vec<f64> {
        (0..count).map(|k| (real(k) * 0.754_877_666_246_693).fract()).collect()
    }

    #[test]
    fn a_converter_is_seen_also_when_its_values_are_rounded_to_digits() {
        let quantum = 100.0 / 4095.0;
        for digits in [1e15, 1e5, 1e4] {
            let values: Vec<f64> = scattered(300)
                .iter()
                .map(|x| (((30.0 + 5.0 * x) / quantum).round() * quantum * digits).round() / digits)
                .collect();
            let found = quantisation(&values).unwrap();
            // Rounding to 1e-4 shifts 200 levels by at most half of it: 2.5e-7 of the mean step.
            assert!((found.quantum - quantum).abs() < 1e-3 * quantum, "{digits}: {found:?}");
        }
    }

    #[test]
    fn continuous_values_have_no_step_but_that_of_their_digits() {
        assert_eq!(quantisation(&scattered(500)), None);
        let rounded: Vec<f64> = scattered(500).iter().map(|x| (x * 1e5).round() / 1e5).collect();
        let found = quantisation(&rounded).unwrap();
        assert!((found.quantum - 1e-5).abs() < 1e-7, "{found:?}");
        assert_eq!(quantisation(&[3.0; 40]), None);
    }
}
