//! The work: the loop of the paper, and the sequences of processes and controllers that every peer can make for itself.

use holdup::analysis::response::{Integrals, Scenario, ScenarioError};
use holdup::model::{Controller, ModelError, Process, Seconds};

/// Process gain [m/(m³·s)] and dead time [s] of the paper.
pub(crate) const GAIN: f64 = 0.0506;
/// Dead time of the paper [s].
pub(crate) const DEAD_TIME: f64 = 6.0;

pub(crate) fn process() -> Result<Process, ModelError> {
    Process::integrating(GAIN, Seconds(DEAD_TIME))
}

/// A PID controller with the derivative filter Tf = Td/100.
pub(crate) fn pid(kc: f64, ti: f64, td: f64) -> Result<Controller, ModelError> {
    Controller::proportional(kc)?
        .with_integral_time(Seconds(ti))?
        .with_derivative_time(Seconds(td))?
        .with_filter_time(Seconds(td / 100.0))
}

pub(crate) fn controller() -> Result<Controller, ModelError> {
    pid(2.95, 15.0, 3.0)
}

/// Setpoint step at 0, load step at half the horizon.
pub(crate) fn scenario(horizon: f64) -> Result<Scenario, ScenarioError> {
    Scenario::new(vec![(0.0, 1.0)], vec![(horizon / 2.0, 1.0)], Seconds(horizon), 0.0)
}

/// Member `index` of an even sequence over the unit cube: multiples of irrational numbers, without their whole part.
#[expect(clippy::cast_precision_loss, reason = "an index is below 2^52")]
fn even<const N: usize>(steps: [f64; N], index: u64) -> [f64; N] {
    steps.map(|step| (0.5 + index as f64 * step).fract())
}

/// Process `index`: gain and dead time within ±20 % of the paper's.
pub(crate) fn perturbed(index: u64) -> Result<Process, ModelError> {
    // Powers of the reciprocal of the real root of x³ = x + 1.
    let [k, d] = even([0.754_877_666_246_692_7, 0.569_840_290_998_053_2], index);
    Process::integrating(GAIN * (0.8 + 0.4 * k), Seconds(DEAD_TIME * (0.8 + 0.4 * d)))
}

/// Settings Kc, Ti, Td of controller `index`: Kc 1…3, Ti 20…80 s, Td 0.5…3 s.
pub(crate) fn settings(index: u64) -> [f64; 3] {
    // Powers of the reciprocal of the real root of x⁴ = x + 1.
    let steps = [0.819_172_513_396_164_5, 0.671_043_606_703_789_3, 0.549_700_477_901_970_3];
    let [kc, ti, td] = even(steps, index);
    [1.0 + 2.0 * kc, 20.0 + 60.0 * ti, 0.5 + 2.5 * td]
}

/// The four integrals: IAE, ISE, ITAE, control energy.
pub(crate) fn four(found: &Integrals) -> [Option<f64>; 4] {
    [found.iae, found.ise, found.itae, found.control_energy]
}
