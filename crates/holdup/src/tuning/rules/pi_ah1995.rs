//! Astrom-Hagglund 1995 version of ZN ultimate, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.63/(K*d)`, `Ti = 3.2*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Ziegler-Nichols with a little less gain, in the same spirit of fast load rejection.
//!
//! # Limits
//! Still aggressive: gain margin 2.07, phase margin 26 deg, `M_s` 2.59, a setpoint step overshoots by 68 %. The source
//! writes it as 0.4 Ku and 0.8 Pu. Read in a transcription, not in the book.
//!
//! # Published values
//! `Kc*K*d` = 0.63; `Ti/d` = 3.2.
//!
//! # Reference
//! Astrom, Hagglund (1995), PID Controllers: Theory, Design and Tuning, 2nd ed., ISA.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-ah1995",
    name: "Astrom-Hagglund 1995 version of ZN ultimate, PI",
    authors: "Astrom, Hagglund",
    year: 1995,
    citation: "PID Controllers: Theory, Design and Tuning, 2nd ed., ISA",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.63/(K*d)"), ("Ti", "3.2*d")],
    when: "Ziegler-Nichols with a little less gain, in the same spirit of fast load rejection.",
    limits: "Still aggressive: gain margin 2.07, phase margin 26 deg, M_s 2.59, a setpoint step \
             overshoots by 68 %. The source writes it as 0.4 Ku and 0.8 Pu. Read in a transcription, not \
             in the book.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-ah1995.toml"),
    law: by_formula,
};
