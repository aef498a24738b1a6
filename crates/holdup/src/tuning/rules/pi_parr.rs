//! Parr 1989 reaction curve, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.91/(K*d)`, `Ti = 3.3*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Only to compare with: Ziegler-Nichols in all but the last digit.
//!
//! # Limits
//! Gain margin 1.45, phase margin 18 deg, `M_s` 4.30, a setpoint step overshoots by 93 %.
//!
//! # Published values
//! `Kc*K*d` = 0.91; `Ti/d` = 3.3.
//!
//! # Reference
//! Parr (1989), Industrial Control Handbook, via O'Dwyer 2009.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-parr",
    name: "Parr 1989 reaction curve, PI",
    authors: "Parr",
    year: 1989,
    citation: "Industrial Control Handbook, via O'Dwyer 2009",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.91/(K*d)"), ("Ti", "3.3*d")],
    when: "Only to compare with: Ziegler-Nichols in all but the last digit.",
    limits: "Gain margin 1.45, phase margin 18 deg, M_s 4.30, a setpoint step overshoots by 93 %.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: turu.py, a transcription of O'Dwyer's handbook",
    status: Status::History("the Ziegler-Nichols settings again, nearly undamped (M_s 4.3)"),
    values: include_str!("../../../tests/rules/pi-parr.toml"),
    law: by_formula,
};
