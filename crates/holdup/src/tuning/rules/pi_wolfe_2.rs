//! Wolfe 1951, PI, small decay ratio.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.87/(K*d)`, `Ti = 4.35*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Fast load rejection, load IAE 5.0 K d^2, where robustness may be spent.
//!
//! # Limits
//! Aggressive: gain margin 1.60, phase margin 24 deg, `M_s` 3.32, decay ratio 0.18, a setpoint step overshoots by 76
//! %. Read in a transcription, not in the paper.
//!
//! # Published values
//! `Kc*K*d` = 0.87; `Ti/d` = 4.35.
//!
//! # Reference
//! Wolfe (1951), Trans. ASME 73, 413-418.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-wolfe-2",
    name: "Wolfe 1951, PI, small decay ratio",
    authors: "Wolfe",
    year: 1951,
    citation: "Trans. ASME 73, 413-418",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.87/(K*d)"), ("Ti", "4.35*d")],
    when: "Fast load rejection, load IAE 5.0 K d^2, where robustness may be spent.",
    limits: "Aggressive: gain margin 1.60, phase margin 24 deg, M_s 3.32, decay ratio 0.18, a setpoint \
             step overshoots by 76 %. Read in a transcription, not in the paper.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-wolfe-2.toml"),
    law: by_formula,
};
