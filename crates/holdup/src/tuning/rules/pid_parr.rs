//! Parr 1989 reaction curve PID.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1.25/(K*d)`
//! - `Ti = 2.5*d`
//! - `Td = 0.4*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field.
//!
//! # Limits
//! The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc*K*d` = 1.25; `Ti/d` = 2.5; `Td/d` = 0.4.
//!
//! # Reference
//! Parr (1989), Industrial Control Handbook, via O'Dwyer.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-parr",
    name: "Parr 1989 reaction curve PID",
    authors: "Parr",
    year: 1989,
    citation: "Industrial Control Handbook, via O'Dwyer",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.25/(K*d)"), ("Ti", "2.5*d"), ("Td", "0.4*d")],
    when: "As history of the field.",
    limits: "The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github gmxavier/turu, turu.py, commit 14911e3c (O'Dwyer 2009 transcription)",
    status: Status::History("Ziegler-Nichols in other digits, from a secondary transcription"),
    values: include_str!("../../../tests/rules/pid-parr.toml"),
    law: by_formula,
};
