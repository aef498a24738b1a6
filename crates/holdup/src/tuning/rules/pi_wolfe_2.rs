//! Wolfe 1951, PI, small decay ratio.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.87/(K*d)`
//! - `Ti = 4.35*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field.
//!
//! # Limits
//! Nothing beyond what the margins show.
//!
//! # Published values
//! `Kc*K*d` = 0.87; `Ti/d` = 4.35.
//!
//! # Reference
//! Wolfe (1951), Trans. ASME 73, 413-418.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-wolfe-2",
    name: "Wolfe 1951, PI, small decay ratio",
    authors: "Wolfe",
    year: 1951,
    citation: "Trans. ASME 73, 413-418",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.87/(K*d)"), ("Ti", "4.35*d")],
    when: "As history of the field.",
    limits: "Nothing beyond what the margins show.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-wolfe-2.toml"),
    law: by_formula,
};
