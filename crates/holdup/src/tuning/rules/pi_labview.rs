//! NI `LabVIEW` PI, some overshoot / little overshoot.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = variant/(K*d)`
//! - `Ti = 5.33*d`
//!
//! # Parameters
//! `variant`, default 0.4: 0.4 for some overshoot, 0.24 for little (range 0.4 | 0.24).
//!
//! # When
//! PI as one commercial toolkit sets it.
//!
//! # Limits
//! Nothing beyond what the margins show.
//!
//! # Published values
//! `Kc*K*d` = 0.4; `Ti/d` = 5.33.
//!
//! # Reference
//! National Instruments (2001), `LabVIEW` PID Control Toolset, via O'Dwyer.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-labview",
    name: "NI LabVIEW PI, some overshoot / little overshoot",
    authors: "National Instruments",
    year: 2001,
    citation: "LabVIEW PID Control Toolset, via O'Dwyer",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "variant",
        Unit::Ratio,
        Default::Number(0.4),
        "0.4 for some overshoot, 0.24 for little",
    )
    .range("0.4 | 0.24")],
    formula: &[("Kc", "variant/(K*d)"), ("Ti", "5.33*d")],
    when: "PI as one commercial toolkit sets it.",
    limits: "Nothing beyond what the margins show.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-labview.toml"),
    law: by_formula,
};
