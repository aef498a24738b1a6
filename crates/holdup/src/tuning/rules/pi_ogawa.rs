//! Ogawa robust PI for parameter uncertainty.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = row(uncertainty_pct, 20, 0.45, 30, 0.39, 40, 0.34, 50, 0.3, 60, 0.27)/(K*d)`,
//! `Ti = row(uncertainty_pct, 20, 11, 30, 12, 40, 13, 50, 14, 60, 15)*d`.
//!
//! # Parameters
//! `uncertainty_pct` [%], default 30: uncertainty of the process parameters (one of 20, 30, 40, 50, 60).
//!
//! # When
//! A process whose gain and dead time are known only to some 20 to 60 %: well damped, `M_s` 1.58 to 1.30.
//!
//! # Limits
//! Rows as printed. Slow under load: load IAE 24 to 56 K d^2. Read in a transcription, not in the paper.
//!
//! # Published values
//! `Kc*K*d` and `Ti/d` of the five rows.
//!
//! # Reference
//! Ogawa (1995), PI controller tuning for robust performance, Proc. 4th IEEE Conf. on Control Applications.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-ogawa",
    name: "Ogawa robust PI for parameter uncertainty",
    authors: "Ogawa",
    year: 1995,
    citation: "PI controller tuning for robust performance, Proc. 4th IEEE Conf. on Control Applications",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "uncertainty_pct",
        Unit::Percent,
        Default::Number(30.0),
        "uncertainty of the process parameters",
    )
    .range("20 | 30 | 40 | 50 | 60")],
    formula: &[
        ("Kc", "row(uncertainty_pct, 20, 0.45, 30, 0.39, 40, 0.34, 50, 0.3, 60, 0.27)/(K*d)"),
        ("Ti", "row(uncertainty_pct, 20, 11, 30, 12, 40, 13, 50, 14, 60, 15)*d"),
    ],
    when: "A process whose gain and dead time are known only to some 20 to 60 %: well damped, M_s 1.58 to \
           1.30.",
    limits: "Rows as printed. Slow under load: load IAE 24 to 56 K d^2. Read in a transcription, not in \
             the paper.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-ogawa.toml"),
    law: by_formula,
};
