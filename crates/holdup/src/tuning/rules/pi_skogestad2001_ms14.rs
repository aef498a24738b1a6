//! Skogestad 2001 optimum for Ms=1.4, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.28/(K*d)`, `Ti = 7*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Robust control: about the largest integral gain that `M_s` 1.4 allows.
//!
//! # Limits
//! Slow to reject loads, load IAE 28 K d^2. Read in a transcription, not in the paper.
//!
//! # Published values
//! `sensitivity_peak` = 1.4.
//!
//! # Reference
//! Skogestad (2001), Probably the best simple PID tuning rules in the world, `AIChE` Annual Meeting, Reno 2001 (row as
//! in O'Dwyer).

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-skogestad2001-ms14",
    name: "Skogestad 2001 optimum for Ms=1.4, PI",
    authors: "Skogestad",
    year: 2001,
    citation: "Probably the best simple PID tuning rules in the world, AIChE Annual Meeting, Reno 2001 \
               (row as in O'Dwyer)",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.28/(K*d)"), ("Ti", "7*d")],
    when: "Robust control: about the largest integral gain that M_s 1.4 allows.",
    limits: "Slow to reject loads, load IAE 28 K d^2. Read in a transcription, not in the paper.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-skogestad2001-ms14.toml"),
    law: by_formula,
};
