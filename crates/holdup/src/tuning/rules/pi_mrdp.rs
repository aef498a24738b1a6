//! PI, triple real dominant pole (2DOF).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 2*(sqrt(2) - 1)*exp(sqrt(2) - 2)/(K*d)`
//! - `Ti = (3 + 2*sqrt(2))*d`
//! - `b = 1 - 1/sqrt(2)`
//!
//! # Parameters
//! None.
//!
//! # When
//! Setpoint steps without overshoot: a triple real pole.
//!
//! # Limits
//! The setpoint weight b = 0.2929 makes the setpoint zero cancel one of the three poles.
//!
//! # Published values
//! `Kc*K*d` = 0.461; `Ti/d` = 5.828.
//!
//! # Reference
//! Huba; Vitecek, Viteckova (2010), M. Viteckova, A. Vitecek, 2DOF PI and PID controllers tuning, IFAC TDS
//! 2010; M. Huba, J. Process Control 23 (2013) 1379-1400.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-mrdp",
    name: "PI, triple real dominant pole (2DOF)",
    authors: "Huba; Vitecek, Viteckova",
    year: 2010,
    citation: "M. Viteckova, A. Vitecek, 2DOF PI and PID controllers tuning, IFAC TDS 2010; M. Huba, J. Process Control 23 (2013) 1379-1400",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[
        ("Kc", "2*(sqrt(2) - 1)*exp(sqrt(2) - 2)/(K*d)"),
        ("Ti", "(3 + 2*sqrt(2))*d"),
        ("b", "1 - 1/sqrt(2)"),
    ],
    when: "Setpoint steps without overshoot: a triple real pole.",
    limits: "The setpoint weight b = 0.2929 makes the setpoint zero cancel one of the three poles.",
    validity: &[],
    provenance: Provenance::MemoryRederived,
    source: "memory; derived here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-mrdp.toml"),
    law: by_formula,
};
