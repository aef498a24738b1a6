//! P, double real dominant pole (critical damping).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1/(exp(1)*K*d)`
//!
//! # Parameters
//! None.
//!
//! # When
//! The fastest P control without overshoot: a double real pole.
//!
//! # Limits
//! A load leaves a lasting error.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Viteckova; Huba (1999), M. Viteckova, Seeking of PI and PID controllers by desired model method (1999); M.
//! Huba, J. Process Control 23 (2013).

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "p-mrdp",
    name: "P, double real dominant pole (critical damping)",
    authors: "Viteckova; Huba",
    year: 1999,
    citation: "M. Viteckova, Seeking of PI and PID controllers by desired model method (1999); M. Huba, J. Process Control 23 (2013)",
    structure: "P",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1/(exp(1)*K*d)")],
    when: "The fastest P control without overshoot: a double real pole.",
    limits: "A load leaves a lasting error.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a; derived here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/p-mrdp.toml"),
    law: by_formula,
};
