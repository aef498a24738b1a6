//! Parr 1989 reaction curve, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.91/(K*d)`
//! - `Ti = 3.3*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field.
//!
//! # Limits
//! Nearly Ziegler-Nichols.
//!
//! # Published values
//! `Kc*K*d` = 0.91; `Ti/d` = 3.3.
//!
//! # Reference
//! Parr (1989), E.A. Parr, Industrial Control Handbook, via O'Dwyer 2009.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-parr",
    name: "Parr 1989 reaction curve, PI",
    authors: "Parr",
    year: 1989,
    citation: "E.A. Parr, Industrial Control Handbook, via O'Dwyer 2009",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.91/(K*d)"), ("Ti", "3.3*d")],
    when: "As history of the field.",
    limits: "Nearly Ziegler-Nichols.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github gmxavier/turu, turu.py, commit 14911e3c (O'Dwyer 2009 transcription)",
    status: Status::History("Ziegler-Nichols in other digits"),
    values: include_str!("../../../tests/rules/pi-parr.toml"),
    law: by_formula,
};
