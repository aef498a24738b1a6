//! Fruehauf-Chien-Lauritsen, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.5/(K*d)`, `Ti = 5*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! A middle way without a knob: load IAE 10 K d^2 at `M_s` 1.83.
//!
//! # Limits
//! Gain margin 2.84, phase margin 39 deg; a setpoint step overshoots by 41 %. Read in a transcription, not in the
//! paper.
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
    when: "A middle way without a knob: load IAE 10 K d^2 at M_s 1.83.",
    limits: "Gain margin 2.84, phase margin 39 deg; a setpoint step overshoots by 41 %. Read in a \
             transcription, not in the paper.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-fruehauf1993.toml"),
    law: by_formula,
};
