//! Rotach PID.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1.21/(K*d)`
//! - `Ti = 1.60*d`
//! - `Td = 0.48*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Never.
//!
//! # Limits
//! The derivative is unfiltered in the source. From memory, and nothing confirms it.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Rotach (1995), via O'Dwyer.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-rotach",
    name: "Rotach PID",
    authors: "Rotach",
    year: 1995,
    citation: "via O'Dwyer",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.21/(K*d)"), ("Ti", "1.60*d"), ("Td", "0.48*d")],
    when: "Never.",
    limits: "The derivative is unfiltered in the source. From memory, and nothing confirms it.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Wrong("from memory only, and nothing confirms it"),
    values: include_str!("../../../tests/rules/pid-rotach.toml"),
    law: by_formula,
};
