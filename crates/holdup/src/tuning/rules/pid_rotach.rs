//! Rotach PID.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1.21/(K*d)`, `Ti = 1.60*d`, `Td = 0.48*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Not to be used: its numbers could not be confirmed. pid-shinskey-noninteracting is a confirmed rule for the same
//! purpose.
//!
//! # Limits
//! From memory: no source was read, and nothing it states came with it that recomputing could confirm. Sensitivity
//! peak 3.3, gain margin 1.45, phase margin 24°.
//!
//! # Published values
//! No value is published with it that could be checked.
//!
//! # Reference
//! Rotach (1995), by way of O'Dwyer.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-rotach",
    name: "Rotach PID",
    authors: "Rotach",
    year: 1995,
    citation: "by way of O'Dwyer",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.21/(K*d)"), ("Ti", "1.60*d"), ("Td", "0.48*d")],
    when: "Not to be used: its numbers could not be confirmed. pid-shinskey-noninteracting is a confirmed rule \
           for the same purpose.",
    limits: "From memory: no source was read, and nothing it states came with it that recomputing could \
             confirm. Sensitivity peak 3.3, gain margin 1.45, phase margin 24°.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory: no source was read",
    status: Status::Wrong(
        "the coefficients are from memory and were never confirmed; as remembered they give a phase margin of \
         24° and a sensitivity peak of 3.3",
    ),
    values: include_str!("../../../tests/rules/pid-rotach.toml"),
    law: by_formula,
};
