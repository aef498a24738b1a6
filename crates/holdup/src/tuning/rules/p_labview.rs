//! NI `LabVIEW` PID toolkit, P (0% / some overshoot).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = variant/(K*d)`
//!
//! # Parameters
//! `variant`, default 0.26: 0.26 for no overshoot, 0.44 for some (range 0.26 | 0.44).
//!
//! # When
//! A P control as one commercial toolkit sets it.
//!
//! # Limits
//! A load leaves a lasting error.
//!
//! # Published values
//! `Kc*K*d` = 0.26.
//!
//! # Reference
//! National Instruments (2001), `LabVIEW` PID Control Toolset manual, via O'Dwyer 2009.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "p-labview",
    name: "NI LabVIEW PID toolkit, P (0% / some overshoot)",
    authors: "National Instruments",
    year: 2001,
    citation: "LabVIEW PID Control Toolset manual, via O'Dwyer 2009",
    structure: "P",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "variant",
        Unit::Ratio,
        Default::Number(0.26),
        "0.26 for no overshoot, 0.44 for some",
    )
    .range("0.26 | 0.44")],
    formula: &[("Kc", "variant/(K*d)")],
    when: "A P control as one commercial toolkit sets it.",
    limits: "A load leaves a lasting error.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/p-labview.toml"),
    law: by_formula,
};
