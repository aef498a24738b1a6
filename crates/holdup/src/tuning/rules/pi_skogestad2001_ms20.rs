//! Skogestad 2001 optimum for Ms=2.0, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.49/(K*d)`, `Ti = 3.77*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Fast load rejection at a sensitivity peak that many accept as the limit.
//!
//! # Limits
//! Phase margin 33 deg, a setpoint step overshoots by 51 %. Read in a transcription, not in the paper.
//!
//! # Published values
//! `sensitivity_peak` = 2.0.
//!
//! # Reference
//! Skogestad (2001), Probably the best simple PID tuning rules in the world, `AIChE` Annual Meeting, Reno 2001.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-skogestad2001-ms20",
    name: "Skogestad 2001 optimum for Ms=2.0, PI",
    authors: "Skogestad",
    year: 2001,
    citation: "Probably the best simple PID tuning rules in the world, AIChE Annual Meeting, Reno 2001",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.49/(K*d)"), ("Ti", "3.77*d")],
    when: "Fast load rejection at a sensitivity peak that many accept as the limit.",
    limits: "Phase margin 33 deg, a setpoint step overshoots by 51 %. Read in a transcription, not in the \
             paper.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-skogestad2001-ms20.toml"),
    law: by_formula,
};
