//! The load over time: steps and ramps.

use super::equipment::LoadRamp;
use crate::analysis::response::Scenario;

/// Load disturbance at a time [s] and its rate [input unit/s], from the right.
pub(super) fn load_at(scenario: &Scenario, ramps: &[LoadRamp], time: f64) -> (f64, f64) {
    ramps
        .iter()
        .map(|ramp| ramp.at(time))
        .fold((scenario.load_at(time), 0.0), |sum, ramp| (sum.0 + ramp.0, sum.1 + ramp.1))
}

/// Times at which setpoint or load change, or change their slope, in rising order [s].
pub(super) fn changes(scenario: &Scenario, ramps: &[LoadRamp]) -> Vec<f64> {
    let events = scenario.setpoint().iter().chain(scenario.load()).map(|event| event.0);
    let mut times: Vec<f64> =
        events.chain(ramps.iter().flat_map(|ramp| [ramp.start(), ramp.end()])).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}
