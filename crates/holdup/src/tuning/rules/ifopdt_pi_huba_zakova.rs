//! Huba-Zakova PI with a triple real pole.
//!
//! # Applies to
//! The integrator with lag T and dead time, `K·e^(−d·s)/(s·(T·s + 1))`.
//!
//! # Formula
//! `x1 = row(d_over_T, 0.5, 0.193, 1, 0.207, 2, 0.219)`, `x2 = row(d_over_T, 0.5, 3.717, 1, 3.386, 2, 3.127)`,
//! `Kc = 2*x1/(K*(T + d))`, `Ti = 2*x2*(T + d)`. Nothing is interpolated; between rows the nearest one is taken.
//! Recomputing the triple root of `Ti*s^2*(1 + T*s) + K*Kc*(1 + Ti*s)*exp(-d*s)` gives every printed digit of the
//! six numbers (mpmath 1.3.0, findroot on the second derivative).
//!
//! # Parameters
//! `d_over_T`, default the row nearest to d/T: row of the table, dead time over lag (0.5, 1 or 2).
//!
//! # When
//! Load rejection without oscillation on an integrator with lag, robust; derivative action is not wanted.
//!
//! # Limits
//! Three rows only. Sensitivity peak 1.43, 1.52, 1.60 at d/T = 0.5, 1, 2. Some transcriptions multiply by d instead
//! of T + d: that is another, wrong rule.
//!
//! # Published values
//! `Kc*K*(T + d)/2` = 0.193 (d/T = 0.5); `Ti/(T + d)/2` = 3.717; `Kc*K*(T + d)/2` = 0.207 (d/T = 1);
//! `Ti/(T + d)/2` = 3.386; `Kc*K*(T + d)/2` = 0.219 (d/T = 2); `Ti/(T + d)/2` = 3.127.
//!
//! # Reference
//! Huba, Zakova (2003), by way of O'Dwyer.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pi-huba-zakova",
    name: "Huba-Zakova PI with a triple real pole",
    authors: "Huba, Zakova",
    year: 2003,
    citation: "by way of O'Dwyer",
    structure: "PI",
    process: Applies::IntegratingWithLag,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "d_over_T",
        Unit::Ratio,
        Default::Formula("near(d/T, 0.5, 0.5, 1, 1, 2, 2)"),
        "row of the table: dead time over lag",
    )
    .range("0.5 | 1 | 2")],
    formula: &[
        ("x1", "row(d_over_T, 0.5, 0.193, 1, 0.207, 2, 0.219)"),
        ("x2", "row(d_over_T, 0.5, 3.717, 1, 3.386, 2, 3.127)"),
        ("Kc", "2*x1/(K*(T + d))"),
        ("Ti", "2*x2*(T + d)"),
    ],
    when: "Load rejection without oscillation on an integrator with lag, robust; derivative action is not \
           wanted.",
    limits: "Three rows only. Sensitivity peak 1.43, 1.52, 1.60 at d/T = 0.5, 1, 2. Some transcriptions \
             multiply by d instead of T + d: that is another, wrong rule.",
    validity: &[("d/T", "0.5..2")],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner, a C# transcription of O'Dwyer's tables, \
             Methods/TunningMethods/FOLIPDModelTunningMethods, commit 59b8950a; the triple root derived again \
             here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pi-huba-zakova.toml"),
    law: by_formula,
};
