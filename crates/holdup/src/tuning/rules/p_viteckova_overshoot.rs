//! P for a prescribed set-point overshoot.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = row(overshoot_pct, 0, 0.368, 5, 0.514, 10, 0.581, 15, 0.641, 20, 0.696, 25, 0.748, 30, 0.801, 35, 0.853, 40, 0.906, 45, 0.957, 50, 1.008)/(K*d)`
//!
//! # Parameters
//! `overshoot_pct` [%], default 15: overshoot of a setpoint step (range 0 | 5 | 10 | 15 | 20 | 25 | 30 | 35 |
//! 40 | 45 | 50).
//!
//! # When
//! A P control with a stated overshoot of a setpoint step.
//!
//! # Limits
//! The table is used as printed: rows only. A load leaves a lasting error.
//!
//! # Published values
//! `Kc*K*d` = 0.368; `Kc*K*d` = 0.514; `Kc*K*d` = 0.581; `Kc*K*d` = 0.641; `Kc*K*d` = 0.696; `Kc*K*d` =
//! 0.748; `Kc*K*d` = 0.801; `Kc*K*d` = 0.853; `Kc*K*d` = 0.906; `Kc*K*d` = 0.957; `Kc*K*d` = 1.008.
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
        "row(overshoot_pct, 0, 0.368, 5, 0.514, 10, 0.581, 15, 0.641, 20, 0.696, 25, 0.748, 30, 0.801, 35, 0.853, 40, 0.906, 45, 0.957, 50, 1.008)/(K*d)",
    )],
    when: "A P control with a stated overshoot of a setpoint step.",
    limits: "The table is used as printed: rows only. A load leaves a lasting error.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/p-viteckova-overshoot.toml"),
    law: by_formula,
};
