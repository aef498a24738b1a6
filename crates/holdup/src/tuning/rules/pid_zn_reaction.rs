//! Ziegler-Nichols reaction curve, PID.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1.2/(K*d)`
//! - `Ti = 2*d`
//! - `Td = 0.5*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field.
//!
//! # Limits
//! The derivative is unfiltered in the source. Hardly robust.
//!
//! # Published values
//! `Kc*K*d` = 1.2; `Ti/d` = 2; `Td/d` = 0.5.
//!
//! # Reference
//! Ziegler, Nichols (1942), Trans. ASME 64.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-zn-reaction",
    name: "Ziegler-Nichols reaction curve, PID",
    authors: "Ziegler, Nichols",
    year: 1942,
    citation: "Trans. ASME 64",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.2/(K*d)"), ("Ti", "2*d"), ("Td", "0.5*d")],
    when: "As history of the field.",
    limits: "The derivative is unfiltered in the source. Hardly robust.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github gmxavier/turu, turu.py, commit 14911e3c (O'Dwyer 2009 transcription); public code on GitHub (MathWorks utTuningStepResponse.m, integrating branch)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-zn-reaction.toml"),
    law: by_formula,
};
