//! Rotach, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.75/(K*d)`
//! - `Ti = 2.41*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field.
//!
//! # Limits
//! Sensitivity peak 4.2. From memory, no source was read.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Rotach (1995), V. Ya. Rotach, Automation tuning of PID controllers (via O'Dwyer).

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-rotach",
    name: "Rotach, PI",
    authors: "Rotach",
    year: 1995,
    citation: "V. Ya. Rotach, Automation tuning of PID controllers (via O'Dwyer)",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.75/(K*d)"), ("Ti", "2.41*d")],
    when: "As history of the field.",
    limits: "Sensitivity peak 4.2. From memory, no source was read.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::History("sensitivity peak 4.2"),
    values: include_str!("../../../tests/rules/pi-rotach.toml"),
    law: by_formula,
};
