//! Hay, PI (memory only).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.42/(K*d)`
//! - `Ti = 5.8*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Never.
//!
//! # Limits
//! From memory, no source was read and nothing confirms it.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Hay (1998), J. Hay, The industrial art of controller tuning, via O'Dwyer.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-hay",
    name: "Hay, PI (memory only)",
    authors: "Hay",
    year: 1998,
    citation: "J. Hay, The industrial art of controller tuning, via O'Dwyer",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.42/(K*d)"), ("Ti", "5.8*d")],
    when: "Never.",
    limits: "From memory, no source was read and nothing confirms it.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Wrong("from memory only, and nothing confirms it"),
    values: include_str!("../../../tests/rules/pi-hay.toml"),
    law: by_formula,
};
