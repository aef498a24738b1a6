//! O'Dwyer 2001 gain/phase margin PI (as transcribed).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = row(row, 1, 0.558, 2, 0.484, 3, 0.458, 4, 0.357, 5, 0.305)/(K*d)`,
//! `Ti = row(row, 1, 1.4, 2, 1.55, 3, 3.35, 4, 4.3, 5, 12.15)*d`.
//!
//! # Parameters
//! `row`, default 1: row of the table: gain margin and phase margin 1.5, 46.2 deg; 2, 45.5 deg; 3, 59.9 deg; 4, 60
//! deg; 5, 75 deg (one of 1, 2, 3, 4, 5).
//!
//! # When
//! Never: `pi-gpm-exact` meets a gain and a phase margin exactly.
//!
//! # Limits
//! The phase margins are 3, 8, 30, 37 and 57 deg instead of 46.2, 45.5, 59.9, 60 and 75. PI control of this process
//! with gain margin A has a phase margin below 90 (1 - 1/A) deg, which the pairs of rows 1, 2 and 5 exceed: they are
//! impossible.
//!
//! # Published values
//! `Kc*K*d` and `Ti/d` of the five rows; gain and phase margins are DIFFERENCES but for the gain margin of row 5 (see
//! the values file).
//!
//! # Reference
//! O'Dwyer (2001), PI and PID controller tuning rule design for processes with delay, to achieve constant gain and
//! phase margins.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-odwyer2001",
    name: "O'Dwyer 2001 gain/phase margin PI (as transcribed)",
    authors: "O'Dwyer",
    year: 2001,
    citation: "PI and PID controller tuning rule design for processes with delay, to achieve constant \
               gain and phase margins",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "row",
        Unit::Ratio,
        Default::Number(1.0),
        "row of the table: gain margin and phase margin 1.5, 46.2 deg; 2, 45.5 deg; 3, 59.9 deg; 4, 60 \
         deg; 5, 75 deg",
    )
    .range("1 | 2 | 3 | 4 | 5")],
    formula: &[
        ("Kc", "row(row, 1, 0.558, 2, 0.484, 3, 0.458, 4, 0.357, 5, 0.305)/(K*d)"),
        ("Ti", "row(row, 1, 1.4, 2, 1.55, 3, 3.35, 4, 4.3, 5, 12.15)*d"),
    ],
    when: "Never: pi-gpm-exact meets a gain and a phase margin exactly.",
    limits: "The phase margins are 3, 8, 30, 37 and 57 deg instead of 46.2, 45.5, 59.9, 60 and 75. PI \
             control of this process with gain margin A has a phase margin below 90 (1 - 1/A) deg, which \
             the pairs of rows 1, 2 and 5 exceed: they are impossible.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Wrong(
        "no row has its stated phase margin: they are 3, 8, 30, 37 and 57 deg instead of 46.2, 45.5, \
             59.9, 60 and 75",
    ),
    values: include_str!("../../../tests/rules/pi-odwyer2001.toml"),
    law: by_formula,
};
