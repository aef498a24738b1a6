//! Callender-Hartree-Porter, PI, criterion 2.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.690/(K*d)`, `Ti = 2.45*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Never: criterion 1 of the same authors (`pi-callender-1`) does what it says.
//!
//! # Limits
//! Gain margin 1.73, phase margin 18 deg, `M_s` 3.65, a setpoint step overshoots by 89 %.
//!
//! # Published values
//! `Kc*K*d` = 0.69; `Ti/d` = 2.45; `decay_ratio` = 0.043 (DIFFERENCE, see the values file); `period_s/d` = 6.28
//! (DIFFERENCE, see the values file).
//!
//! # Reference
//! Callender, Hartree, Porter (1936), Phil. Trans. R. Soc. A 235.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-callender-2",
    name: "Callender-Hartree-Porter, PI, criterion 2",
    authors: "Callender, Hartree, Porter",
    year: 1936,
    citation: "Phil. Trans. R. Soc. A 235",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.690/(K*d)"), ("Ti", "2.45*d")],
    when: "Never: criterion 1 of the same authors (pi-callender-1) does what it says.",
    limits: "Gain margin 1.73, phase margin 18 deg, M_s 3.65, a setpoint step overshoots by 89 %.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: turu.py, a transcription of O'Dwyer's handbook",
    status: Status::Wrong(
        "the transcription states a decay ratio of 0.043 and a period of 6.28 d, the loop has 0.186 \
             and 7.63 d",
    ),
    values: include_str!("../../../tests/rules/pi-callender-2.toml"),
    law: by_formula,
};
