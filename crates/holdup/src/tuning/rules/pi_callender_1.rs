//! Callender-Hartree-Porter, PI, criterion 1.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.568/(K*d)`
//! - `Ti = 3.64*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field: the first tuning for dead time.
//!
//! # Limits
//! Nothing beyond what the margins show.
//!
//! # Published values
//! `Kc*K*d` = 0.568; `Ti/d` = 3.64.
//!
//! # Reference
//! Callender, Hartree, Porter (1936), Time-lag in a control system, Phil. Trans. R. Soc. A 235, 415-444.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-callender-1",
    name: "Callender-Hartree-Porter, PI, criterion 1",
    authors: "Callender, Hartree, Porter",
    year: 1936,
    citation: "Time-lag in a control system, Phil. Trans. R. Soc. A 235, 415-444",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.568/(K*d)"), ("Ti", "3.64*d")],
    when: "As history of the field: the first tuning for dead time.",
    limits: "Nothing beyond what the margins show.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github gmxavier/turu, turu.py, commit 14911e3c (O'Dwyer 2009 transcription)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-callender-1.toml"),
    law: by_formula,
};
