//! Parr PID from the reaction curve.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1.25/(K*d)`, `Ti = 2.5*d`, `Td = 0.4*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! As history only: a variant of Ziegler-Nichols from a handbook.
//!
//! # Limits
//! Sensitivity peak 3.48, gain margin 1.43, phase margin 28°. No property of the loop came with the transcription
//! that could be checked. The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc*K*d` = 1.25; `Ti/d` = 2.5; `Td/d` = 0.4.
//!
//! # Reference
//! Parr (1989), Industrial Control Handbook, by way of O'Dwyer.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-parr",
    name: "Parr PID from the reaction curve",
    authors: "Parr",
    year: 1989,
    citation: "Industrial Control Handbook, by way of O'Dwyer",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.25/(K*d)"), ("Ti", "2.5*d"), ("Td", "0.4*d")],
    when: "As history only: a variant of Ziegler-Nichols from a handbook.",
    limits: "Sensitivity peak 3.48, gain margin 1.43, phase margin 28°. No property of the loop came with the \
             transcription that could be checked. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github gmxavier/turu, turu.py, commit 14911e3c (a transcription of O'Dwyer's handbook of 2009)",
    status: Status::History(
        "a handbook variant of Ziegler-Nichols with sensitivity peak 3.5, of which no property is stated",
    ),
    values: include_str!("../../../tests/rules/pid-parr.toml"),
    law: by_formula,
};
