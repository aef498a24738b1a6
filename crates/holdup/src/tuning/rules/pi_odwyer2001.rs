//! O'Dwyer 2001 gain/phase margin PI (as transcribed).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = row(row, 1, 0.558, 2, 0.484, 3, 0.458, 4, 0.357, 5, 0.305)/(K*d)`
//! - `Ti = row(row, 1, 1.4, 2, 1.55, 3, 3.35, 4, 4.3, 5, 12.15)*d`
//!
//! # Parameters
//! `row`, default 3: row of the table, in the printed order (range 1 | 2 | 3 | 4 | 5).
//!
//! # When
//! Never.
//!
//! # Limits
//! As transcribed the stated margins do not come out: row 3, stated (3, 59.9°), has gain margin 2.89 and
//! phase margin 30.3°.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! O'Dwyer (2001), PI and PID controller tuning rule design ... constant gain and phase margins.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-odwyer2001",
    name: "O'Dwyer 2001 gain/phase margin PI (as transcribed)",
    authors: "O'Dwyer",
    year: 2001,
    citation: "PI and PID controller tuning rule design ... constant gain and phase margins",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "row",
        Unit::Ratio,
        Default::Number(3.0),
        "row of the table, in the printed order",
    )
    .range("1 | 2 | 3 | 4 | 5")],
    formula: &[
        ("Kc", "row(row, 1, 0.558, 2, 0.484, 3, 0.458, 4, 0.357, 5, 0.305)/(K*d)"),
        ("Ti", "row(row, 1, 1.4, 2, 1.55, 3, 3.35, 4, 4.3, 5, 12.15)*d"),
    ],
    when: "Never.",
    limits: "As transcribed the stated margins do not come out: row 3, stated (3, 59.9°), has gain margin 2.89 and phase margin 30.3°.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Wrong(
        "as transcribed its margins are not the stated ones: row 3, stated (3, 59.9°), has 2.89 and 30.3°",
    ),
    values: include_str!("../../../tests/rules/pi-odwyer2001.toml"),
    law: by_formula,
};
