//! Limits as smooth functions of the settings: each peak for itself.

use super::Settings;
use crate::analysis::frequency::{LoopTransfer, margins};
use crate::model::{ClosedLoop, Controller};
use crate::tuning::line::least;
use crate::tuning::optimise::limits::{Limit, Quantity};
use crate::tuning::optimise::objective::Transients;

/// Nearer to its limit, relative, a piece counts as reached.
const REACHED: f64 = 2e-2;
/// Settings are moved by so much to see other peaks.
const ASIDE: f64 = 1e-2;
/// Frequencies nearer than this factor are those of one peak.
const SAME: f64 = 1.15;
/// First step of the way to the top of a peak, as a factor; how often one is taken, and how much longer than the one before.
const STEP: f64 = 1.01;
const STEPS: u32 = 12;
const GROWTH: f64 = 1.5;
/// Relative width of the place of the top, whose square is what the peak misses.
const WIDTH: f64 = 1e-7;

/// A limit, or one peak of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    limit: Limit,
    /// Where the peak is \[rad/s\], for a limit on peaks.
    omega: Option<f64>,
}

impl Piece {
    /// By how much the limit is exceeded, relative; negative where it is kept.
    pub(super) fn excess(&self, settings: &Settings<'_>, at: &[f64]) -> Option<f64> {
        let design = settings.gains.design;
        let controller = settings.controller(at)?;
        let closed_loop = ClosedLoop::new(&design.process, &controller);
        let excess = |value: f64| {
            if self.limit.quantity.is_greatest() {
                value / self.limit.value - 1.0
            } else {
                1.0 - value / self.limit.value
            }
        };
        if let Some(omega) = self.omega {
            let transfer = LoopTransfer::new(&closed_loop).ok()?;
            return Some(excess(top(&transfer, self.limit.quantity, omega)?.1));
        }
        let value = value(self.limit.quantity, settings, &controller)?;
        value.is_finite().then(|| excess(value))
    }
}

/// The value of a quantity, whatever it costs.
fn value(quantity: Quantity, settings: &Settings<'_>, controller: &Controller) -> Option<f64> {
    let design = settings.gains.design;
    let transients = Transients::new(design, controller);
    if quantity.is_of_responses() {
        return quantity.of_transients(&transients);
    }
    let achieved = margins(&ClosedLoop::new(&design.process, controller)).ok()?;
    quantity.of(controller, &achieved)
}

/// Frequency and height of the peak next to a frequency; `None` where there is none near.
fn top(transfer: &LoopTransfer, quantity: Quantity, omega: f64) -> Option<(f64, f64)> {
    let height = |omega: f64| match quantity {
        Quantity::SensitivityPeak => transfer.sensitivity(omega).norm(),
        _ => transfer.complementary_sensitivity(omega).norm(),
    };
    let way = if height(omega * STEP) > height(omega / STEP) { STEP } else { 1.0 / STEP };
    let mut places = [omega / way, omega, omega * way];
    let mut steps = 0;
    while height(places[2]) > height(places[1]) {
        if steps == STEPS {
            return None;
        }
        steps += 1;
        places = [places[1], places[2], places[2] * (places[2] / places[1]).powf(GROWTH)];
    }
    let (low, high) = (places[0].min(places[2]), places[0].max(places[2]));
    let (at, negative) = least(low, high, WIDTH, &mut |omega| -height(omega));
    Some((at, -negative))
}

/// The pieces that are reached about these settings, the nearest first: no more than there are settings.
pub(super) fn pieces(settings: &Settings<'_>, at: &[f64]) -> Vec<Piece> {
    let design = settings.gains.design;
    let achieved = |at: &[f64]| {
        let controller = settings.controller(at)?;
        margins(&ClosedLoop::new(&design.process, &controller)).ok().filter(|achieved| achieved.stable)
    };
    let sides = (0..at.len()).flat_map(|axis| [(axis, ASIDE), (axis, -ASIDE)]);
    let moved = sides.map(|(axis, side)| {
        let mut moved = at.to_vec();
        moved[axis] = (at[axis] + side).clamp(0.0, 1.0);
        moved
    });
    let about: Vec<_> = std::iter::once(at.to_vec()).chain(moved).filter_map(|at| achieved(&at)).collect();
    let mut found: Vec<(Piece, f64)> = Vec::new();
    for &limit in settings.gains.limits.list() {
        let mut take = |omega: Option<f64>| {
            let piece = Piece { limit, omega };
            if let Some(excess) = piece.excess(settings, at).filter(|excess| excess.abs() < REACHED) {
                found.push((piece, excess));
            }
        };
        let frequencies = about.iter().filter_map(|achieved| match limit.quantity {
            Quantity::SensitivityPeak => achieved.sensitivity_peak_frequency,
            Quantity::ComplementarySensitivityPeak => achieved.complementary_sensitivity_peak_frequency,
            _ => None,
        });
        match limit.quantity {
            Quantity::SensitivityPeak | Quantity::ComplementarySensitivityPeak => {
                let mut known: Vec<f64> = Vec::new();
                for omega in frequencies {
                    if known.iter().all(|known| omega > known * SAME || omega < known / SAME) {
                        known.push(omega);
                        take(Some(omega));
                    }
                }
            }
            // It jumps.
            Quantity::SetpointSettlingTime => {}
            _ => take(None),
        }
    }
    found.sort_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    found.truncate(at.len());
    found.into_iter().map(|(piece, _)| piece).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Process, Seconds};

    #[test]
    fn each_of_two_peaks_is_found_from_beside_it() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let pid = Controller::proportional(0.45).unwrap().with_integral_time(Seconds(3.75)).unwrap();
        let pid = pid.with_derivative_time(Seconds(0.44)).unwrap().with_filter_time(Seconds(0.044)).unwrap();
        let closed_loop = ClosedLoop::new(&process, &pid);
        let transfer = LoopTransfer::new(&closed_loop).unwrap();
        // A script of its own (Python, golden section on |1 + C·G| between a row of 8000 frequencies) has them there.
        let [low, high] = [(0.618_757_3, 1.397_639_937_2), (1.871_900_1, 1.406_109_682_7)];
        let found =
            [0.5, 0.7, 1.7, 2.1].map(|omega| top(&transfer, Quantity::SensitivityPeak, omega).unwrap());
        for (top, of) in found.into_iter().zip([low, low, high, high]) {
            // The digits that are given, and half of them where the top is flat.
            assert!(
                (top.0 / of.0 - 1.0).abs() < 1e-6 && (top.1 / of.1 - 1.0).abs() < 1e-10,
                "{top:?} {of:?}"
            );
        }
        let greatest = margins(&closed_loop).unwrap().sensitivity_peak.unwrap();
        let heights = found.map(|top| top.1);
        // Rounding, and the square of the width.
        assert!((heights.into_iter().fold(0.0, f64::max) / greatest - 1.0).abs() < 1e-12);
        assert!((heights[0] - heights[1]).abs() < 1e-12 && (heights[2] - heights[3]).abs() < 1e-12);
    }
}
