//! Ziegler-Nichols reaction curve, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.9/(K*d)`, `Ti = 3.33*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! As the classic to compare with; fast load rejection where a nearly undamped loop is accepted.
//!
//! # Limits
//! Legacy: gain margin 1.47, phase margin 18 deg, `M_s` 4.16, a setpoint step overshoots by 92 %. The original prints
//! Ti = d/0.3; a later book prints 3 d.
//!
//! # Published values
//! `Kc*K*d` = 0.9; `Ti/d` = 3.33; `sensitivity_peak` = 4.16.
//!
//! # Reference
//! Ziegler, Nichols (1942), Trans. ASME 64, 759-768.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-zn-reaction",
    name: "Ziegler-Nichols reaction curve, PI",
    authors: "Ziegler, Nichols",
    year: 1942,
    citation: "Trans. ASME 64, 759-768",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.9/(K*d)"), ("Ti", "3.33*d")],
    when: "As the classic to compare with; fast load rejection where a nearly undamped loop is accepted.",
    limits: "Legacy: gain margin 1.47, phase margin 18 deg, M_s 4.16, a setpoint step overshoots by 92 %. \
             The original prints Ti = d/0.3; a later book prints 3 d.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook; turu.py, another \
             one (Ti = 3.3 d)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-zn-reaction.toml"),
    law: by_formula,
};
