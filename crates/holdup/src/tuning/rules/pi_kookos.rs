//! Kookos-Lygeros-Arvanitis gain/phase margin, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = row(row, 1, 0.942, 2, 0.698, 3, 0.491, 4, 0.384)/(K*d)`
//! - `Ti = row(row, 1, 4.510, 2, 4.098, 3, 6.942, 4, 18.710)*d`
//!
//! # Parameters
//! `row`, default 3: row of the table, in the printed order (range 1 | 2 | 3 | 4).
//!
//! # When
//! PI with stated gain and phase margin.
//!
//! # Limits
//! Rows: (1.5, 22.5°), (2, 30°), (3, 45°), (4, 60°). pi-gpm-exact meets any feasible pair.
//!
//! # Published values
//! `GM` = 1.5; `PM_deg` = 22.5; `GM` = 2.0; `PM_deg` = 30.0; `GM` = 3.0; `PM_deg` = 45.0; `GM` = 4.0;
//! `PM_deg` = 60.0.
//!
//! # Reference
//! Kookos, Lygeros, Arvanitis (1999), On-line PI controller tuning for integrator/dead time processes,
//! European J. Control 5, 19-31.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-kookos",
    name: "Kookos-Lygeros-Arvanitis gain/phase margin, PI",
    authors: "Kookos, Lygeros, Arvanitis",
    year: 1999,
    citation: "On-line PI controller tuning for integrator/dead time processes, European J. Control 5, 19-31",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "row",
        Unit::Ratio,
        Default::Number(3.0),
        "row of the table, in the printed order",
    )
    .range("1 | 2 | 3 | 4")],
    formula: &[
        ("Kc", "row(row, 1, 0.942, 2, 0.698, 3, 0.491, 4, 0.384)/(K*d)"),
        ("Ti", "row(row, 1, 4.510, 2, 4.098, 3, 6.942, 4, 18.710)*d"),
    ],
    when: "PI with stated gain and phase margin.",
    limits: "Rows: (1.5, 22.5°), (2, 30°), (3, 45°), (4, 60°). pi-gpm-exact meets any feasible pair.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-kookos.toml"),
    law: by_formula,
};
