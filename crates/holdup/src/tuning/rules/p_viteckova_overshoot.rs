//! P for a prescribed set-point overshoot.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = row(overshoot_pct, 0, 0.368, 5, 0.514, 10, 0.581, 15, 0.641, 20, 0.696, 25, 0.748, 30, 0.801, 35, 0.853, 40,
//! 0.906, 45, 0.957, 50, 1.008)/(K*d)`.
//!
//! # Parameters
//! `overshoot_pct` [%], default 15: overshoot of a setpoint step (one of 0, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50).
//!
//! # When
//! P control of a level or position whose overshoot is the requirement.
//!
//! # Limits
//! Rows as printed, nothing between them. Exact up to 35 %; the rows for 40, 45 and 50 % overshoot by 0.6 to 0.8
//! points more. P control leaves a lasting error under load.
//!
//! # Published values
//! `Kc*K*d` and the overshoot of every row; the overshoot of the rows for 40, 45 and 50 % is a DIFFERENCE (see the
//! values file).
//!
//! # Reference
//! Viteckova (1999), desired model method (inverse dynamics), table as in O'Dwyer 2009.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "p-viteckova-overshoot",
    name: "P for a prescribed set-point overshoot",
    authors: "Viteckova",
    year: 1999,
    citation: "desired model method (inverse dynamics), table as in O'Dwyer 2009",
    structure: "P",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "overshoot_pct",
        Unit::Percent,
        Default::Number(15.0),
        "overshoot of a setpoint step",
    )
    .range("0 | 5 | 10 | 15 | 20 | 25 | 30 | 35 | 40 | 45 | 50")
    .asks(Property::Overshoot)],
    formula: &[(
        "Kc",
        "row(overshoot_pct, 0, 0.368, 5, 0.514, 10, 0.581, 15, 0.641, 20, 0.696, 25, 0.748, 30, \
                 0.801, 35, 0.853, 40, 0.906, 45, 0.957, 50, 1.008)/(K*d)",
    )],
    when: "P control of a level or position whose overshoot is the requirement.",
    limits: "Rows as printed, nothing between them. Exact up to 35 %; the rows for 40, 45 and 50 % \
             overshoot by 0.6 to 0.8 points more. P control leaves a lasting error under load.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/p-viteckova-overshoot.toml"),
    law: by_formula,
};
