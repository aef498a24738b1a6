//! PD, triple real pole, double integrator.
//!
//! # Applies to
//! The double integrator with dead time.
//!
//! # Formula
//! - `Kc = 2*(sqrt(2) - 1)*exp(sqrt(2) - 2)/((3 + 2*sqrt(2))*K*d^2)`
//! - `Td = (3 + 2*sqrt(2))*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Setpoint steps without overshoot: a triple real pole.
//!
//! # Limits
//! From memory, derived again here.
//!
//! # Published values
//! `Kc*K*d^2` = 0.079; `Kc*Td*K*d` = 0.461.
//!
//! # Reference
//! Huba (1999), M. Huba et al., dynamical classes / double integrator + dead time.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "dipdt-pd-mrdp",
    name: "PD, triple real pole, double integrator",
    authors: "Huba",
    year: 1999,
    citation: "M. Huba et al., dynamical classes / double integrator + dead time",
    structure: "PD",
    process: Applies::DoubleIntegrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[
        ("Kc", "2*(sqrt(2) - 1)*exp(sqrt(2) - 2)/((3 + 2*sqrt(2))*K*d^2)"),
        ("Td", "(3 + 2*sqrt(2))*d"),
    ],
    when: "Setpoint steps without overshoot: a triple real pole.",
    limits: "From memory, derived again here.",
    validity: &[],
    provenance: Provenance::MemoryRederived,
    source: "derived here; memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/dipdt-pd-mrdp.toml"),
    law: by_formula,
};
