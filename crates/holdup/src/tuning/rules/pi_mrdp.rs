//! PI, triple real dominant pole (2DOF).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 2*(sqrt(2) - 1)*exp(sqrt(2) - 2)/(K*d)`, `Ti = (3 + 2*sqrt(2))*d`, `b = 1 - 1/sqrt(2)`.
//!
//! # Parameters
//! None.
//!
//! # When
//! No oscillation and no overshoot, to setpoint and load, at `M_s` 1.70: the aperiodic counterpart of SIMC, with less
//! load IAE (12.6 against 16 K d^2).
//!
//! # Limits
//! The weight b is part of it: its zero cancels one of the three poles at -0.586/d; with b = 1 the setpoint step
//! overshoots.
//!
//! # Published values
//! `Kc*K*d` = 0.461; `Ti/d` = 5.828; `b` = 0.2929; `100*overshoot` = 0.
//!
//! # Reference
//! Huba; Vitecek, Viteckova (2010), M. Viteckova, A. Vitecek, 2DOF PI and PID controllers tuning, IFAC TDS 2010; M.
//! Huba, J. Process Control 23 (2013), 1379-1400. From memory, derived again here.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-mrdp",
    name: "PI, triple real dominant pole (2DOF)",
    authors: "Huba; Vitecek, Viteckova",
    year: 2010,
    citation: "M. Viteckova, A. Vitecek, 2DOF PI and PID controllers tuning, IFAC TDS 2010; M. Huba, J. \
               Process Control 23 (2013), 1379-1400",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[
        ("Kc", "2*(sqrt(2) - 1)*exp(sqrt(2) - 2)/(K*d)"),
        ("Ti", "(3 + 2*sqrt(2))*d"),
        ("b", "1 - 1/sqrt(2)"),
    ],
    when: "No oscillation and no overshoot, to setpoint and load, at M_s 1.70: the aperiodic counterpart \
           of SIMC, with less load IAE (12.6 against 16 K d^2).",
    limits: "The weight b is part of it: its zero cancels one of the three poles at -0.586/d; with b = 1 \
             the setpoint step overshoots.",
    validity: &[],
    provenance: Provenance::MemoryRederived,
    source: "none retrieved; re-derived: characteristic function and its first two derivatives vanish at \
             s d = sqrt(2) - 2",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-mrdp.toml"),
    law: by_formula,
};

#[cfg(test)]
mod tests {
    use crate::model::{Process, Seconds};
    use crate::tuning::{Parameters, rule};

    #[test]
    fn the_characteristic_function_has_a_triple_zero_that_the_weight_cancels_once() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let pi = rule("pi-mrdp").unwrap().tune(&process, &Parameters::new()).unwrap().controller;
        let (kc, ti) = (pi.proportional_gain(), pi.integral_time().unwrap());
        let s = 2.0_f64.sqrt() - 2.0;
        // s² + k·(s + 1/Ti)·e^(−s) and its first two derivatives.
        let (e, p) = (kc * (-s).exp(), s + 1.0 / ti);
        for zero in [s * s + e * p, 2.0 * s + e * (1.0 - p), 2.0 + e * (p - 2.0)] {
            // A few operations on numbers of size 1.
            assert!(zero.abs() < 1e-14, "{zero}");
        }
        assert!((pi.setpoint_weight() * ti * s + 1.0).abs() < 1e-14);
    }
}
