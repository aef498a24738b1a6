//! Set-point overshoot closed-loop PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc0 = 0.798373/(K*d)`
//! - `tp = 3.28475*d`
//! - `A = 1.152*S^2 - 1.607*S + 1`
//! - `Kc = Kc0*A/F`
//! - `Ti = 2.44*tp*F`
//!
//! # Parameters
//! `S`, default 0.3: overshoot of the P test (range 0.3); `F`, default 1.0: detuning factor (range >= 1).
//!
//! # When
//! PI from one closed-loop P test, here from the exact response of that test.
//!
//! # Limits
//! Kc0 and tp are those of the exact P test with overshoot 0.3, so only S = 0.3 is offered. tp counts from
//! the setpoint step.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Shamsuzzoha, Skogestad (2010), The setpoint overshoot method: a simple and fast closed-loop approach for
//! PID tuning, J. Process Control 20, 1220-1234.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-shamsuzzoha-skogestad",
    name: "Set-point overshoot closed-loop PI",
    authors: "Shamsuzzoha, Skogestad",
    year: 2010,
    citation: "The setpoint overshoot method: a simple and fast closed-loop approach for PID tuning, J. Process Control 20, 1220-1234",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[
        Parameter::new("S", Unit::Ratio, Default::Number(0.3), "overshoot of the P test").range("0.3"),
        Parameter::new("F", Unit::Ratio, Default::Number(1.0), "detuning factor").range(">= 1"),
    ],
    formula: &[
        ("Kc0", "0.798373/(K*d)"),
        ("tp", "3.28475*d"),
        ("A", "1.152*S^2 - 1.607*S + 1"),
        ("Kc", "Kc0*A/F"),
        ("Ti", "2.44*tp*F"),
    ],
    when: "PI from one closed-loop P test, here from the exact response of that test.",
    limits: "Kc0 and tp are those of the exact P test with overshoot 0.3, so only S = 0.3 is offered. tp counts from the setpoint step.",
    validity: &[],
    provenance: Provenance::RetrievedAndMemory,
    source: "retrieved (A polynomial and y_inf=0.45(yp+yu)): public code on GitHub; method abstract https://c.coek.info/pdf-on-line-pi-controller-tuning-using-closed-loop-setpoint-response-.html; the 2.44 tp limit from memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-shamsuzzoha-skogestad.toml"),
    law: by_formula,
};
