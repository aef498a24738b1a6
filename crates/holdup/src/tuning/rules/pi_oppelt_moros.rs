//! Oppelt (Moros 1999) reaction curve, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.8/(K*d)`
//! - `Ti = 3*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field.
//!
//! # Limits
//! Close to Ziegler-Nichols.
//!
//! # Published values
//! `Kc*K*d` = 0.8; `Ti/d` = 3.0.
//!
//! # Reference
//! Oppelt; Moros (1999), via O'Dwyer 2009.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-oppelt-moros",
    name: "Oppelt (Moros 1999) reaction curve, PI",
    authors: "Oppelt; Moros",
    year: 1999,
    citation: "via O'Dwyer 2009",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.8/(K*d)"), ("Ti", "3*d")],
    when: "As history of the field.",
    limits: "Close to Ziegler-Nichols.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github gmxavier/turu, turu.py, commit 14911e3c (O'Dwyer 2009 transcription)",
    status: Status::History("close to Ziegler-Nichols, from a secondary transcription"),
    values: include_str!("../../../tests/rules/pi-oppelt-moros.toml"),
    law: by_formula,
};
