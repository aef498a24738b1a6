//! Callender-Hartree-Porter PID, criterion 2.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1.066/(K*d)`
//! - `Ti = 1.418*d`
//! - `Td = 0.47*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Never.
//!
//! # Limits
//! The derivative is unfiltered in the source. As transcribed its decay ratio is 0.16 and its sensitivity
//! peak 2.93.
//!
//! # Published values
//! `Kc*K*d` = 1.066; `Ti/d` = 1.418; `Td/d` = 0.47.
//!
//! # Reference
//! Callender, Hartree, Porter (1936), Phil. Trans. R. Soc. A 235.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-callender-2",
    name: "Callender-Hartree-Porter PID, criterion 2",
    authors: "Callender, Hartree, Porter",
    year: 1936,
    citation: "Phil. Trans. R. Soc. A 235",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.066/(K*d)"), ("Ti", "1.418*d"), ("Td", "0.47*d")],
    when: "Never.",
    limits: "The derivative is unfiltered in the source. As transcribed its decay ratio is 0.16 and its sensitivity peak 2.93.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github gmxavier/turu, turu.py, commit 14911e3c (O'Dwyer 2009 transcription)",
    status: Status::Wrong(
        "as transcribed it does not meet the criterion of its source: decay ratio 0.16, sensitivity peak 2.93",
    ),
    values: include_str!("../../../tests/rules/pid-callender-2.toml"),
    law: by_formula,
};
