//! Set-point overshoot closed-loop PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `A = 1.152*S^2 - 1.607*S + 1`, `Kc = Kc0*A/F`, `Ti = 2.44*tp*F`. `Kc0` and `tp` [s] are gain and peak time, from
//! the setpoint step on, of the P control whose first overshoot is S.
//!
//! # Parameters
//! `S`, default 0.3: overshoot of the P-only experiment (in 0.1..0.6).
//! `F`, default 1: detuning factor (must be >= 1).
//!
//! # When
//! Tuning from one setpoint step under P control, done on the model: S near 0.3 gives settings close to SIMC.
//!
//! # Limits
//! Kc0 and tp are those of the exact P-only response; in a plant they are measured. The source takes the smaller of
//! two integral times; on an integrator only 2.44 tp F remains, and that limit is from memory. `M_s` 1.70 at the
//! defaults.
//!
//! # Published values
//! `Kc*K*d/(1.152*S^2 - 1.607*S + 1)` = 0.798373 at `S = 0.3`; `Ti/(2.44*d)` = 3.28475 at `S = 0.3`.
//!
//! # Reference
//! Shamsuzzoha, Skogestad (2010), The setpoint overshoot method: a simple and fast closed-loop approach for PID
//! tuning, J. Process Control 20, 1220-1234. Partly from memory.

use std::f64::consts::{E, FRAC_PI_2};

use crate::model::Process;
use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Provenance, RuleError, Status, Tuning, Unit, Values, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-shamsuzzoha-skogestad",
    name: "Set-point overshoot closed-loop PI",
    authors: "Shamsuzzoha, Skogestad",
    year: 2010,
    citation: "The setpoint overshoot method: a simple and fast closed-loop approach for PID tuning, J. \
               Process Control 20, 1220-1234",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[
        Parameter::new("S", Unit::Ratio, Default::Number(0.3), "overshoot of the P-only experiment")
            .range("0.1..0.6"),
        Parameter::new("F", Unit::Ratio, Default::Number(1.0), "detuning factor").range(">= 1"),
    ],
    formula: &[("A", "1.152*S^2 - 1.607*S + 1"), ("Kc", "Kc0*A/F"), ("Ti", "2.44*tp*F")],
    when: "Tuning from one setpoint step under P control, done on the model: S near 0.3 gives settings \
           close to SIMC.",
    limits: "Kc0 and tp are those of the exact P-only response; in a plant they are measured. The source \
             takes the smaller of two integral times; on an integrator only 2.44 tp F remains, and that \
             limit is from memory. M_s 1.70 at the defaults.",
    validity: &[],
    provenance: Provenance::RetrievedAndMemory,
    source: "public code on GitHub (the polynomial A); abstract at c.coek.info; the limit 2.44 tp from \
             memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-shamsuzzoha-skogestad.toml"),
    law: tune,
};

fn tune(entry: &'static Entry, process: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let mut values = values.clone();
    let (k, d) = (values.get("K")?, values.get("d")?);
    let (loop_gain, peak_time) = experiment(values.get("S")?);
    values.keep("Kc0", loop_gain / (k * d));
    values.keep("tp", peak_time * d);
    by_formula(entry, process, &values)
}

/// Loop gain K·Kc0·d and peak time over dead time of the P control whose first overshoot is the given ratio.
///
/// The overshoot rises with the gain, from nothing at 1/e to 1 at the stability limit π/2.
fn experiment(overshoot: f64) -> (f64, f64) {
    let (low, high) = bisect(1.0 / E, FRAC_PI_2, |gain| -error(gain, peak_time(gain)) >= overshoot);
    let gain = 0.5 * (low + high);
    (gain, peak_time(gain))
}

/// Control error after a unit setpoint step at time t in dead times: the method of steps, in closed form.
fn error(gain: f64, t: f64) -> f64 {
    let (mut sum, mut n, mut factorial) = (1.0, 1, 1.0);
    while f64::from(n) < t {
        factorial *= f64::from(n);
        sum += (-gain * (t - f64::from(n))).powi(n) / factorial;
        n += 1;
    }
    sum
}

/// Time of the first peak of the output, in dead times: one after the error first is zero.
///
/// The output turns where the error one dead time earlier changes sign. Until then the error falls, so it has no other
/// zero before, and it is negative at the first whole number after that zero.
fn peak_time(gain: f64) -> f64 {
    // Close to 1/e the first zero moves to infinity; what the gain is searched for ends long before.
    let after = (1..40).map(f64::from).find(|&n| error(gain, n) <= 0.0).unwrap_or(40.0);
    1.0 + bisect(after - 1.0, after, |t| error(gain, t) <= 0.0).1
}

/// The two neighbouring numbers between which a condition that holds from some point on begins to hold.
fn bisect(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> (f64, f64) {
    loop {
        let middle = low + 0.5 * (high - low);
        if middle <= low || middle >= high {
            return (low, high);
        }
        if holds(middle) { high = middle } else { low = middle }
    }
}

#[cfg(test)]
mod tests {
    use super::{error, experiment, peak_time};
    use crate::analysis::response::{Scenario, simulate};
    use crate::model::{ClosedLoop, Controller, Process, Seconds};

    #[test]
    fn the_experiment_has_its_overshoot_in_the_exact_simulation() {
        let process = Process::integrating(2.0, Seconds(3.0)).unwrap();
        let step = Scenario::unit_setpoint_step(Seconds(300.0)).unwrap();
        for overshoot in [0.1, 0.2, 0.3, 0.45, 0.6] {
            let p = Controller::proportional(experiment(overshoot).0 / 6.0).unwrap();
            let found = simulate(&ClosedLoop::new(&process, &p), &step).unwrap().metrics.overshoot.unwrap();
            // The simulation promises 1e-9.
            assert!((found - overshoot).abs() < 1e-8, "{found} {overshoot}");
        }
    }

    #[test]
    fn at_loop_gain_one_the_overshoot_is_a_half_after_three_dead_times() {
        // The error is 1 − (t − 1) until t = 2, so it is zero there and the output peaks at 3.
        assert!((peak_time(1.0) - 3.0).abs() < 1e-15);
        assert_eq!(error(1.0, 3.0), -0.5);
    }
}
