//! PD, triple real pole.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 4*exp(-2)/(K*d)`
//! - `Td = d/4`
//!
//! # Parameters
//! None.
//!
//! # When
//! Setpoint steps without overshoot: a triple real pole.
//!
//! # Limits
//! The derivative is unfiltered. A load leaves a lasting error.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Huba; Vitecek (2003), multiple real dominant pole method.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pd-mrdp",
    name: "PD, triple real pole",
    authors: "Huba; Vitecek",
    year: 2003,
    citation: "multiple real dominant pole method",
    structure: "PD",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "4*exp(-2)/(K*d)"), ("Td", "d/4")],
    when: "Setpoint steps without overshoot: a triple real pole.",
    limits: "The derivative is unfiltered. A load leaves a lasting error.",
    validity: &[],
    provenance: Provenance::Derived,
    source: "derived here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pd-mrdp.toml"),
    law: by_formula,
};
