//! Ziegler-Nichols reaction curve, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.9/(K*d)`
//! - `Ti = 3.33*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field: the first published rule.
//!
//! # Limits
//! Sensitivity peak 4.16: hardly robust. The original prints Ti = d/0.3, a later book 3 d; 3.33 d is the rule
//! here.
//!
//! # Published values
//! `Kc*K*d` = 0.9; `Ti/d` = 3.33.
//!
//! # Reference
//! Ziegler, Nichols (1942), Trans. ASME 64, 759-768.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-zn-reaction",
    name: "Ziegler-Nichols reaction curve, PI",
    authors: "Ziegler, Nichols",
    year: 1942,
    citation: "Trans. ASME 64, 759-768",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.9/(K*d)"), ("Ti", "3.33*d")],
    when: "As history of the field: the first published rule.",
    limits: "Sensitivity peak 4.16: hardly robust. The original prints Ti = d/0.3, a later book 3 d; 3.33 d is the rule here.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a; github gmxavier/turu, turu.py, commit 14911e3c (O'Dwyer 2009 transcription)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-zn-reaction.toml"),
    law: by_formula,
};
