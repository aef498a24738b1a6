//! The sampled response at requested times.

use super::run::Moment;
use crate::analysis::response::{Scenario, Trajectory};

/// Signals of a sampled loop at requested times [s]; at an event the value from the right.
///
/// The manipulated variable is the output of the law, held from sample to sample; the valve position is what the valve makes of
/// it. Both are in the scale in which they rest at `initial_manipulated`. The process sees the position's deviation from that rest, plus the load.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SampledTrajectory {
    /// The signals that a continuous loop has, too.
    pub signals: Trajectory,
    /// Valve position [input unit].
    pub valve_position: Vec<f64>,
}

/// Fills in the requested times.
pub(super) struct Sampler {
    /// Indices of the times in increasing order.
    order: Vec<usize>,
    next: usize,
    rest: f64,
    initial: f64,
    result: SampledTrajectory,
}

impl Sampler {
    pub(super) fn new(scenario: &Scenario, rest: f64, estimates: bool, times: &[f64]) -> Self {
        let mut order: Vec<usize> = (0..times.len()).collect();
        order.sort_by(|&a, &b| times[a].total_cmp(&times[b]));
        let empty = || vec![f64::NAN; times.len()];
        let signals = Trajectory {
            time: times.to_vec(),
            setpoint: empty(),
            controlled_variable: empty(),
            manipulated_variable: empty(),
            load: empty(),
            load_estimate: estimates.then(empty),
        };
        let result = SampledTrajectory { signals, valve_position: empty() };
        Self { order, next: 0, rest, initial: scenario.initial(), result }
    }

    /// Takes the times within this piece; its end is the next one's unless it is the last.
    pub(super) fn take(&mut self, moment: &Moment<'_>, horizon: f64) {
        let (start, end) = (moment.piece.start, moment.piece.start + moment.piece.length);
        while let Some(&index) = self.order.get(self.next) {
            let signals = &mut self.result.signals;
            let time = signals.time[index];
            if time >= end && end < horizon {
                return;
            }
            let gone = (time - start).clamp(0.0, moment.piece.length);
            signals.setpoint[index] = self.initial + moment.setpoint;
            signals.controlled_variable[index] = self.initial + moment.piece.output(gone);
            signals.manipulated_variable[index] = self.rest + moment.manipulated;
            signals.load[index] = moment.load.0 + moment.load.1 * gone;
            if let Some((estimates, estimate)) = signals.load_estimate.as_mut().zip(moment.load_estimate) {
                estimates[index] = estimate;
            }
            self.result.valve_position[index] = self.rest + moment.valve.0 + moment.valve.1 * gone;
            self.next += 1;
        }
    }

    /// The signals; of a run that overflowed those before that.
    pub(super) fn finish(self) -> SampledTrajectory {
        if self.next == self.order.len() {
            return self.result;
        }
        let mut kept = self.order[..self.next].to_vec();
        kept.sort_unstable();
        let pick = |values: &[f64]| kept.iter().map(|&index| values[index]).collect::<Vec<f64>>();
        let signals = &self.result.signals;
        SampledTrajectory {
            signals: Trajectory {
                time: pick(&signals.time),
                setpoint: pick(&signals.setpoint),
                controlled_variable: pick(&signals.controlled_variable),
                manipulated_variable: pick(&signals.manipulated_variable),
                load: pick(&signals.load),
                load_estimate: signals.load_estimate.as_deref().map(pick),
            },
            valve_position: pick(&self.result.valve_position),
        }
    }
}
