//! Ogawa robust PI for parameter uncertainty.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = row(uncertainty_pct, 20, 0.45, 30, 0.39, 40, 0.34, 50, 0.30, 60, 0.27)/(K*d)`
//! - `Ti = row(uncertainty_pct, 20, 11, 30, 12, 40, 13, 50, 14, 60, 15)*d`
//!
//! # Parameters
//! `uncertainty_pct` [%], default 30: uncertainty of the process (range 20 | 30 | 40 | 50 | 60).
//!
//! # When
//! PI for a stated uncertainty of gain and dead time.
//!
//! # Limits
//! The table is used as printed: rows only.
//!
//! # Published values
//! `Kc*K*d` = 0.45; `Ti/d` = 11; `Kc*K*d` = 0.39; `Ti/d` = 12; `Kc*K*d` = 0.34; `Ti/d` = 13; `Kc*K*d` = 0.30;
//! `Ti/d` = 14; `Kc*K*d` = 0.27; `Ti/d` = 15.
//!
//! # Reference
//! Ogawa (1995), S. Ogawa, PI controller tuning for robust performance, Proc. 4th IEEE CCA 1995.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-ogawa",
    name: "Ogawa robust PI for parameter uncertainty",
    authors: "Ogawa",
    year: 1995,
    citation: "S. Ogawa, PI controller tuning for robust performance, Proc. 4th IEEE CCA 1995",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "uncertainty_pct",
        Unit::Percent,
        Default::Number(30.0),
        "uncertainty of the process",
    )
    .range("20 | 30 | 40 | 50 | 60")],
    formula: &[
        ("Kc", "row(uncertainty_pct, 20, 0.45, 30, 0.39, 40, 0.34, 50, 0.30, 60, 0.27)/(K*d)"),
        ("Ti", "row(uncertainty_pct, 20, 11, 30, 12, 40, 13, 50, 14, 60, 15)*d"),
    ],
    when: "PI for a stated uncertainty of gain and dead time.",
    limits: "The table is used as printed: rows only.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-ogawa.toml"),
    law: by_formula,
};
