//! Penner, max closed-loop gain 2.0, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.8/(K*d)`
//! - `Ti = 5.9*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! PI with the complementary peak 2.
//!
//! # Limits
//! From memory, no source was read.
//!
//! # Published values
//! `Mt` = 2.0.
//!
//! # Reference
//! Penner (1988), Tuning rules for a PI controller, Proc. ISA (via O'Dwyer).

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-penner-20",
    name: "Penner, max closed-loop gain 2.0, PI",
    authors: "Penner",
    year: 1988,
    citation: "Tuning rules for a PI controller, Proc. ISA (via O'Dwyer)",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.8/(K*d)"), ("Ti", "5.9*d")],
    when: "PI with the complementary peak 2.",
    limits: "From memory, no source was read.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-penner-20.toml"),
    law: by_formula,
};
