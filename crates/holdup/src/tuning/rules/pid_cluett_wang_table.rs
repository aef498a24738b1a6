//! Cluett-Wang PID table by closed-loop time constant.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = row(tcl_over_d, 1, 0.9588, 2, 0.6232, 3, 0.4668, 4, 0.3752, 5, 0.3144, 6, 0.2709)/(K*d)`,
//! `Ti = row(tcl_over_d, 1, 3.0425, 2, 5.2586, 3, 7.2291, 4, 9.1925, 5, 11.1637, 6, 13.1416)*d`,
//! `Td = row(tcl_over_d, 1, 0.3912, 2, 0.2632, 3, 0.2058, 4, 0.1702, 5, 0.1453, 6, 0.1269)*d`.
//!
//! # Parameters
//! `tcl_over_d`, default 3: row of the table, closed-loop time constant over dead time (1, 2, 3, 4, 5 or 6).
//!
//! # When
//! A PID from sharp (row 1) to very smooth (row 6) in six printed steps; rows 2 to 4 are the robust middle.
//!
//! # Limits
//! Only the printed rows: nothing is interpolated. The derivative times are from memory, gains and integral times
//! from a transcription. Sensitivity peak 2.26, 1.66, 1.47, 1.37, 1.30, 1.26 for rows 1 to 6. The derivative is
//! unfiltered in the source.
//!
//! # Published values
//! `Kc*K*d` = 0.9588 (row 1); `Ti/d` = 3.0425; `Td/d` = 0.3912; `Kc*K*d` = 0.6232 (row 2); `Ti/d` = 5.2586;
//! `Td/d` = 0.2632; `Kc*K*d` = 0.4668 (row 3); `Ti/d` = 7.2291; `Td/d` = 0.2058; `Kc*K*d` = 0.3752 (row 4);
//! `Ti/d` = 9.1925; `Td/d` = 0.1702; `Kc*K*d` = 0.3144 (row 5); `Ti/d` = 11.1637; `Td/d` = 0.1453; `Kc*K*d` =
//! 0.2709 (row 6); `Ti/d` = 13.1416; `Td/d` = 0.1269.
//!
//! # Reference
//! Cluett, Wang (1997), New tuning rules for PID control, Pulp & Paper Canada 98(6).

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-cluett-wang-table",
    name: "Cluett-Wang PID table by closed-loop time constant",
    authors: "Cluett, Wang",
    year: 1997,
    citation: "New tuning rules for PID control, Pulp & Paper Canada 98(6)",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "tcl_over_d",
        Unit::Ratio,
        Default::Number(3.0),
        "row: closed-loop time constant over dead time",
    )
    .range("1 | 2 | 3 | 4 | 5 | 6")],
    formula: &[
        ("Kc", "row(tcl_over_d, 1, 0.9588, 2, 0.6232, 3, 0.4668, 4, 0.3752, 5, 0.3144, 6, 0.2709)/(K*d)"),
        ("Ti", "row(tcl_over_d, 1, 3.0425, 2, 5.2586, 3, 7.2291, 4, 9.1925, 5, 11.1637, 6, 13.1416)*d"),
        ("Td", "row(tcl_over_d, 1, 0.3912, 2, 0.2632, 3, 0.2058, 4, 0.1702, 5, 0.1453, 6, 0.1269)*d"),
    ],
    when: "A PID from sharp (row 1) to very smooth (row 6) in six printed steps; rows 2 to 4 are the robust \
           middle.",
    limits: "Only the printed rows: nothing is interpolated. The derivative times are from memory, gains and \
             integral times from a transcription. Sensitivity peak 2.26, 1.66, 1.47, 1.37, 1.30, 1.26 for rows \
             1 to 6. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::RetrievedAndMemory,
    source: "github WKolaj/S7_PID-Tuner, a C# transcription of O'Dwyer's tables, \
             Methods/TunningMethods/IPDModelTunningMethods, commit 59b8950a (Kc, Ti); memory (Td)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-cluett-wang-table.toml"),
    law: by_formula,
};
