//! Haalman, P.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 2/(3*K*d)`.
//!
//! # Parameters
//! None.
//!
//! # When
//! A brisk P control with usual robustness; the loop that other rules of Haalman produce by cancelling lags.
//!
//! # Limits
//! `M_s` 1.92, a setpoint step overshoots by 18 %. P control leaves a lasting error under load.
//!
//! # Published values
//! `Kc*K*d` = 0.6667; `sensitivity_peak` = 1.9.
//!
//! # Reference
//! Haalman (1965), Adjusting controllers for a deadtime process, Control Engineering 12 (July 1965), 71-73.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "p-haalman",
    name: "Haalman, P",
    authors: "Haalman",
    year: 1965,
    citation: "Adjusting controllers for a deadtime process, Control Engineering 12 (July 1965), 71-73",
    structure: "P",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "2/(3*K*d)")],
    when: "A brisk P control with usual robustness; the loop that other rules of Haalman produce by \
           cancelling lags.",
    limits: "M_s 1.92, a setpoint step overshoots by 18 %. P control leaves a lasting error under load.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/p-haalman.toml"),
    law: by_formula,
};
