//! Chien-Hrones-Reswick load 20%, PID slope form.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1.2/(K*d)`
//! - `Ti = 2*d`
//! - `Td = 0.42*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Load rejection with 20 % overshoot, in the sense of 1952.
//!
//! # Limits
//! The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc*K*d` = 1.2; `Ti/d` = 2; `Td/d` = 0.42.
//!
//! # Reference
//! Chien, Hrones, Reswick (1952), Trans. ASME 74.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-chr-reg20",
    name: "Chien-Hrones-Reswick load 20%, PID slope form",
    authors: "Chien, Hrones, Reswick",
    year: 1952,
    citation: "Trans. ASME 74",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.2/(K*d)"), ("Ti", "2*d"), ("Td", "0.42*d")],
    when: "Load rejection with 20 % overshoot, in the sense of 1952.",
    limits: "The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github gmxavier/turu, turu.py, commit 14911e3c (O'Dwyer 2009 transcription)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-chr-reg20.toml"),
    law: by_formula,
};
