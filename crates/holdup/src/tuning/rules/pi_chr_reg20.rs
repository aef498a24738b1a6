//! Chien-Hrones-Reswick load 20% overshoot, PI, slope form.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.7/(K*d)`
//! - `Ti = 2.3*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field.
//!
//! # Limits
//! From memory, no source was read.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Chien, Hrones, Reswick (1952), Trans. ASME 74, 175-185.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-chr-reg20",
    name: "Chien-Hrones-Reswick load 20% overshoot, PI, slope form",
    authors: "Chien, Hrones, Reswick",
    year: 1952,
    citation: "Trans. ASME 74, 175-185",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.7/(K*d)"), ("Ti", "2.3*d")],
    when: "As history of the field.",
    limits: "From memory, no source was read.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::History("from memory only, no source was read"),
    values: include_str!("../../../tests/rules/pi-chr-reg20.toml"),
    law: by_formula,
};
