//! Callender-Hartree-Porter, PI, criterion 2.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.690/(K*d)`
//! - `Ti = 2.45*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Never.
//!
//! # Limits
//! As transcribed its decay ratio is 0.19 and its sensitivity peak 3.65.
//!
//! # Published values
//! `Kc*K*d` = 0.69; `Ti/d` = 2.45.
//!
//! # Reference
//! Callender, Hartree, Porter (1936), Phil. Trans. R. Soc. A 235.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-callender-2",
    name: "Callender-Hartree-Porter, PI, criterion 2",
    authors: "Callender, Hartree, Porter",
    year: 1936,
    citation: "Phil. Trans. R. Soc. A 235",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.690/(K*d)"), ("Ti", "2.45*d")],
    when: "Never.",
    limits: "As transcribed its decay ratio is 0.19 and its sensitivity peak 3.65.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github gmxavier/turu, turu.py, commit 14911e3c (O'Dwyer 2009 transcription)",
    status: Status::Wrong(
        "as transcribed it does not meet the criterion of its source: decay ratio 0.19, sensitivity peak 3.65",
    ),
    values: include_str!("../../../tests/rules/pi-callender-2.toml"),
    law: by_formula,
};
