//! Fruehauf-Chien-Lauritsen, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.5/(K*d)`
//! - `Ti = 5*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! A simple PI near SIMC with faster integral action.
//!
//! # Limits
//! Nothing beyond what the margins show.
//!
//! # Published values
//! `Kc*K*d` = 0.5; `Ti/d` = 5.
//!
//! # Reference
//! Fruehauf, Chien, Lauritsen (1993), Simplified IMC-PID tuning rules, ISA/93.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-fruehauf1993",
    name: "Fruehauf-Chien-Lauritsen, PI",
    authors: "Fruehauf, Chien, Lauritsen",
    year: 1993,
    citation: "Simplified IMC-PID tuning rules, ISA/93",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.5/(K*d)"), ("Ti", "5*d")],
    when: "A simple PI near SIMC with faster integral action.",
    limits: "Nothing beyond what the margins show.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-fruehauf1993.toml"),
    law: by_formula,
};
