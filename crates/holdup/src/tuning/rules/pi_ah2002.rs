//! Hagglund-Astrom 2002 revisited ZN, PI for integrating.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.35/(K*d)`
//! - `Ti = 7*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! PI with moderate robustness.
//!
//! # Limits
//! Nothing beyond what the margins show.
//!
//! # Published values
//! `Kc*K*d` = 0.35; `Ti/d` = 7.
//!
//! # Reference
//! Hagglund, Astrom (2002), Revisiting the Ziegler-Nichols tuning rules for PI control, Asian J. Control 4,
//! 364-380.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-ah2002",
    name: "Hagglund-Astrom 2002 revisited ZN, PI for integrating",
    authors: "Hagglund, Astrom",
    year: 2002,
    citation: "Revisiting the Ziegler-Nichols tuning rules for PI control, Asian J. Control 4, 364-380",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.35/(K*d)"), ("Ti", "7*d")],
    when: "PI with moderate robustness.",
    limits: "Nothing beyond what the margins show.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-ah2002.toml"),
    law: by_formula,
};
