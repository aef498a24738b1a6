//! Ziegler-Nichols reaction curve, P.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1/(K*d)`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field; a fast P control.
//!
//! # Limits
//! Gain margin 1.57 only. A load leaves a lasting error.
//!
//! # Published values
//! `Kc*K*d` = 1.0.
//!
//! # Reference
//! Ziegler, Nichols (1942), Optimum settings for automatic controllers, Trans. ASME 64, 759-768.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "p-zn-reaction",
    name: "Ziegler-Nichols reaction curve, P",
    authors: "Ziegler, Nichols",
    year: 1942,
    citation: "Optimum settings for automatic controllers, Trans. ASME 64, 759-768",
    structure: "P",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1/(K*d)")],
    when: "As history of the field; a fast P control.",
    limits: "Gain margin 1.57 only. A load leaves a lasting error.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/p-zn-reaction.toml"),
    law: by_formula,
};
