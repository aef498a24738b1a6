//! Haalman, P.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 2/(3*K*d)`
//!
//! # Parameters
//! None.
//!
//! # When
//! A P control with the sensitivity peak 1.9.
//!
//! # Limits
//! A load leaves a lasting error.
//!
//! # Published values
//! `Kc*K*d` = 0.6667; `Ms` = 1.9.
//!
//! # Reference
//! Haalman (1965), A. Haalman, Adjusting controllers for a deadtime process, Control Engineering 12 (July
//! 1965) 71-73.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "p-haalman",
    name: "Haalman, P",
    authors: "Haalman",
    year: 1965,
    citation: "A. Haalman, Adjusting controllers for a deadtime process, Control Engineering 12 (July 1965) 71-73",
    structure: "P",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "2/(3*K*d)")],
    when: "A P control with the sensitivity peak 1.9.",
    limits: "A load leaves a lasting error.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/p-haalman.toml"),
    law: by_formula,
};
