//! Astrom-Hagglund 1995 version of ZN ultimate, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.63/(K*d)`
//! - `Ti = 3.2*d`
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
//! `Kc*K*d` = 0.63; `Ti/d` = 3.2.
//!
//! # Reference
//! Astrom, Hagglund (1995), PID Controllers: Theory, Design and Tuning, 2nd ed., ISA.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-ah1995",
    name: "Astrom-Hagglund 1995 version of ZN ultimate, PI",
    authors: "Astrom, Hagglund",
    year: 1995,
    citation: "PID Controllers: Theory, Design and Tuning, 2nd ed., ISA",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.63/(K*d)"), ("Ti", "3.2*d")],
    when: "As history of the field.",
    limits: "Nothing beyond what the margins show.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-ah1995.toml"),
    law: by_formula,
};
