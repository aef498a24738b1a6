//! Hagglund-Astrom 2002 revisited ZN, PI for integrating.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.35/(K*d)`, `Ti = 7*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Between robust and quick: `M_s` 1.48, load IAE 20 K d^2.
//!
//! # Limits
//! A setpoint step overshoots by 29 %. The transcription dates it 2004; it is the gain of `pi-amigo` with the integral
//! time of the earlier paper.
//!
//! # Published values
//! `Kc*K*d` = 0.35; `Ti/d` = 7.
//!
//! # Reference
//! Hagglund, Astrom (2002), Revisiting the Ziegler-Nichols tuning rules for PI control, Asian J. Control 4, 364-380.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-ah2002",
    name: "Hagglund-Astrom 2002 revisited ZN, PI for integrating",
    authors: "Hagglund, Astrom",
    year: 2002,
    citation: "Revisiting the Ziegler-Nichols tuning rules for PI control, Asian J. Control 4, 364-380",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.35/(K*d)"), ("Ti", "7*d")],
    when: "Between robust and quick: M_s 1.48, load IAE 20 K d^2.",
    limits: "A setpoint step overshoots by 29 %. The transcription dates it 2004; it is the gain of \
             pi-amigo with the integral time of the earlier paper.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-ah2002.toml"),
    law: by_formula,
};
