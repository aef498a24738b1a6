//! Kookos-Lygeros-Arvanitis gain/phase margin, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = row(row, 1, 0.942, 2, 0.698, 3, 0.491, 4, 0.384)/(K*d)`,
//! `Ti = row(row, 1, 4.510, 2, 4.098, 3, 6.942, 4, 18.710)*d`.
//!
//! # Parameters
//! `row`, default 3: row of the table: gain margin and phase margin 1.5, 22.5 deg; 2, 30 deg; 3, 45 deg; 4, 60 deg
//! (one of 1, 2, 3, 4).
//!
//! # When
//! A stated gain and phase margin without a computation: row 3 (gain margin 3, phase margin 45 deg) is the usual
//! choice.
//!
//! # Limits
//! Rows as printed. Rows 1 and 2 are aggressive (`M_s` 3.81 and 2.52) and round: 1.48 and 21.7 deg, 1.97 and 29.5 deg;
//! `pi-gpm-exact` meets any feasible pair exactly.
//!
//! # Published values
//! `Kc*K*d`, `Ti/d`, gain margin and phase margin of the four rows; the phase margin of row 1 is a DIFFERENCE (see the
//! values file).
//!
//! # Reference
//! Kookos, Lygeros, Arvanitis (1999), On-line PI controller tuning for integrator/dead time processes, European J.
//! Control 5, 19-31.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-kookos",
    name: "Kookos-Lygeros-Arvanitis gain/phase margin, PI",
    authors: "Kookos, Lygeros, Arvanitis",
    year: 1999,
    citation: "On-line PI controller tuning for integrator/dead time processes, European J. Control 5, \
               19-31",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "row",
        Unit::Ratio,
        Default::Number(3.0),
        "row of the table: gain margin and phase margin 1.5, 22.5 deg; 2, 30 deg; 3, 45 deg; 4, 60 deg",
    )
    .range("1 | 2 | 3 | 4")],
    formula: &[
        ("Kc", "row(row, 1, 0.942, 2, 0.698, 3, 0.491, 4, 0.384)/(K*d)"),
        ("Ti", "row(row, 1, 4.510, 2, 4.098, 3, 6.942, 4, 18.710)*d"),
    ],
    when: "A stated gain and phase margin without a computation: row 3 (gain margin 3, phase margin 45 \
           deg) is the usual choice.",
    limits: "Rows as printed. Rows 1 and 2 are aggressive (M_s 3.81 and 2.52) and round: 1.48 and 21.7 \
             deg, 1.97 and 29.5 deg; pi-gpm-exact meets any feasible pair exactly.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-kookos.toml"),
    law: by_formula,
};
