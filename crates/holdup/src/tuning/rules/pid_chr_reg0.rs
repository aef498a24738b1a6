//! Chien-Hrones-Reswick load 0%, PID slope form.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.95/(K*d)`
//! - `Ti = 2.38*d`
//! - `Td = 0.42*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Load rejection without overshoot, in the sense of 1952.
//!
//! # Limits
//! The derivative is unfiltered in the source. The original table prints Ti = 2.4 d.
//!
//! # Published values
//! `Kc*K*d` = 0.95; `Ti/d` = 2.38; `Td/d` = 0.42.
//!
//! # Reference
//! Chien, Hrones, Reswick (1952), Trans. ASME 74.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-chr-reg0",
    name: "Chien-Hrones-Reswick load 0%, PID slope form",
    authors: "Chien, Hrones, Reswick",
    year: 1952,
    citation: "Trans. ASME 74",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.95/(K*d)"), ("Ti", "2.38*d"), ("Td", "0.42*d")],
    when: "Load rejection without overshoot, in the sense of 1952.",
    limits: "The derivative is unfiltered in the source. The original table prints Ti = 2.4 d.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (MathWorks utTuningStepResponse.m, integrating branch)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-chr-reg0.toml"),
    law: by_formula,
};
