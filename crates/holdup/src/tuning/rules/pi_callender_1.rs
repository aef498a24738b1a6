//! Callender-Hartree-Porter, PI, criterion 1.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.568/(K*d)`, `Ti = 3.64*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! The earliest rule with a stated damping that holds: an oscillation that dies in one period.
//!
//! # Limits
//! Gain margin 2.37, phase margin 31 deg, `M_s` 2.21; a setpoint step overshoots by 57 %. The transcription names it
//! for d/T = 0.3 and prints a period of 5.10 d; it is 10.5 d.
//!
//! # Published values
//! `decay_ratio` = 0.015; `Kc*K*d` = 0.568; `Ti/d` = 3.64; `period_s/d` = 5.10 (DIFFERENCE, see the values file).
//!
//! # Reference
//! Callender, Hartree, Porter (1936), Time-lag in a control system, Phil. Trans. R. Soc. A 235, 415-444.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-callender-1",
    name: "Callender-Hartree-Porter, PI, criterion 1",
    authors: "Callender, Hartree, Porter",
    year: 1936,
    citation: "Time-lag in a control system, Phil. Trans. R. Soc. A 235, 415-444",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.568/(K*d)"), ("Ti", "3.64*d")],
    when: "The earliest rule with a stated damping that holds: an oscillation that dies in one period.",
    limits: "Gain margin 2.37, phase margin 31 deg, M_s 2.21; a setpoint step overshoots by 57 %. The \
             transcription names it for d/T = 0.3 and prints a period of 5.10 d; it is 10.5 d.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: turu.py, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-callender-1.toml"),
    law: by_formula,
};
