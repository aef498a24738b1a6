//! Cluett-Wang 1997 table used as PI (as transcribed).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `ratio = TCL/d`, `Kc = row(ratio, 1, 0.9588, 2, 0.6232, 3, 0.4668, 4, 0.3752, 5, 0.3144, 6, 0.2709)/(K*d)`,
//! `Ti = row(ratio, 1, 3.0425, 2, 5.2586, 3, 7.2291, 4, 9.1925, 5, 11.1637, 6, 13.1416)*d`. `ratio` is the parameter,
//! whose name has a stroke in it.
//!
//! # Parameters
//! `TCL/d`, default 3: closed-loop time constant over dead time (one of 1, 2, 3, 4, 5, 6).
//!
//! # When
//! Never: the table belongs to a PID, whose derivative the transcription has dropped (`pid-wang-cluett-z1`).
//!
//! # Limits
//! Without its derivative the tight rows lose their damping: at TCL/d = 1 gain margin 1.34, phase margin 14 deg and
//! `M_s` 5.33. One transcription prints 0.3114 for 0.3144.
//!
//! # Published values
//! `Kc*K*d` and `Ti/d` of the six rows; the gain of row 5 is a DIFFERENCE (see the values file).
//!
//! # Reference
//! Cluett, Wang (1997), New tuning rules for PID control, Pulp & Paper Canada 98(6), T52-55.

use crate::model::Process;
use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Provenance, RuleError, Status, Tuning, Unit, Values,
    from_settings,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-cluett-wang-table",
    name: "Cluett-Wang 1997 table used as PI (as transcribed)",
    authors: "Cluett, Wang",
    year: 1997,
    citation: "New tuning rules for PID control, Pulp & Paper Canada 98(6), T52-55",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "TCL/d",
        Unit::Ratio,
        Default::Number(3.0),
        "closed-loop time constant over dead time",
    )
    .range("1 | 2 | 3 | 4 | 5 | 6")],
    formula: &[
        ("ratio", "TCL/d"),
        ("Kc", "row(ratio, 1, 0.9588, 2, 0.6232, 3, 0.4668, 4, 0.3752, 5, 0.3144, 6, 0.2709)/(K*d)"),
        ("Ti", "row(ratio, 1, 3.0425, 2, 5.2586, 3, 7.2291, 4, 9.1925, 5, 11.1637, 6, 13.1416)*d"),
    ],
    when: "Never: the table belongs to a PID, whose derivative the transcription has dropped \
           (pid-wang-cluett-z1).",
    limits: "Without its derivative the tight rows lose their damping: at TCL/d = 1 gain margin 1.34, \
             phase margin 14 deg and M_s 5.33. One transcription prints 0.3114 for 0.3144.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Wrong(
        "a table of PID settings used without its derivative: at TCL/d = 1 the sensitivity peak is \
             5.3",
    ),
    values: include_str!("../../../tests/rules/pi-cluett-wang-table.toml"),
    law: tune,
};

fn tune(entry: &'static Entry, _: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let mut values = values.clone();
    values.keep("ratio", values.get("TCL/d")?);
    // A formula would read the name of the parameter as a quotient: the first line is the one above.
    for (name, formula) in &entry.formula[1..] {
        values.compute(name, formula)?;
    }
    from_settings(entry, &values)
}
