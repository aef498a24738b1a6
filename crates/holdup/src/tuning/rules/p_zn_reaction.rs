//! Ziegler-Nichols reaction curve, P.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1/(K*d)`.
//!
//! # Parameters
//! None.
//!
//! # When
//! A first gain from a slope and a dead time read off a chart, where a quarter decay is acceptable.
//!
//! # Limits
//! Lightly damped: gain margin 1.57, phase margin 33 deg, `M_s` 3.13, a setpoint step overshoots by 50 %. P control
//! leaves a lasting error under load. Read in a transcription, not in the paper.
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
    when: "A first gain from a slope and a dead time read off a chart, where a quarter decay is \
           acceptable.",
    limits: "Lightly damped: gain margin 1.57, phase margin 33 deg, M_s 3.13, a setpoint step overshoots \
             by 50 %. P control leaves a lasting error under load. Read in a transcription, not in the \
             paper.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/p-zn-reaction.toml"),
    law: by_formula,
};
