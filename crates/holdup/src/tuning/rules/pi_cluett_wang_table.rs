//! Cluett-Wang 1997 table used as PI (as transcribed).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = row(tcl_over_d, 1, 0.9588, 2, 0.6232, 3, 0.4668, 4, 0.3752, 5, 0.3144, 6, 0.2709)/(K*d)`
//! - `Ti = row(tcl_over_d, 1, 3.0425, 2, 5.2586, 3, 7.2291, 4, 9.1925, 5, 11.1637, 6, 13.1416)*d`
//!
//! # Parameters
//! `tcl_over_d`, default 3: closed-loop time constant over dead time (range 1 | 2 | 3 | 4 | 5 | 6).
//!
//! # When
//! Never: use the PID table.
//!
//! # Limits
//! It is a PID table without its derivative column.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Cluett, Wang (1997), New tuning rules for PID control, Pulp & Paper Canada 98(6) T52-55.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-cluett-wang-table",
    name: "Cluett-Wang 1997 table used as PI (as transcribed)",
    authors: "Cluett, Wang",
    year: 1997,
    citation: "New tuning rules for PID control, Pulp & Paper Canada 98(6) T52-55",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "tcl_over_d",
        Unit::Ratio,
        Default::Number(3.0),
        "closed-loop time constant over dead time",
    )
    .range("1 | 2 | 3 | 4 | 5 | 6")],
    formula: &[
        ("Kc", "row(tcl_over_d, 1, 0.9588, 2, 0.6232, 3, 0.4668, 4, 0.3752, 5, 0.3144, 6, 0.2709)/(K*d)"),
        ("Ti", "row(tcl_over_d, 1, 3.0425, 2, 5.2586, 3, 7.2291, 4, 9.1925, 5, 11.1637, 6, 13.1416)*d"),
    ],
    when: "Never: use the PID table.",
    limits: "It is a PID table without its derivative column.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Wrong("a PID table without its derivative column (pid-cluett-wang-table)"),
    values: include_str!("../../../tests/rules/pi-cluett-wang-table.toml"),
    law: by_formula,
};
