//! Poulin-Pomerleau PI, ITAE of a load at the process input.
//!
//! # Applies to
//! The integrator with lag T and dead time, `K·e^(−d·s)/(s·(T·s + 1))`.
//!
//! # Formula
//! `x1 = row(d_over_T, 0.2, 3.9465, 0.4, 3.9981, 0.6, 4.0397, 0.8, 4.0397, 1, 4.0397, 1.2, 4.0337, 1.4, 4.0278,
//! 1.6, 4.0278, 1.8, 4.0218, 2, 4.0099)`, `x2 = row(d_over_T, 0.2, 0.5320, 0.4, 0.5315, 0.6, 0.5311, 0.8, 0.5311,
//! 1, 0.5311, 1.2, 0.5312, 1.4, 0.5312, 1.6, 0.5312, 1.8, 0.5313, 2, 0.5314)`,
//! `Kc = x2/(K*(T + d))*sqrt(1 + T^2/(x1*(T + d)^2))`, `Ti = x1*(T + d)`. Nothing is interpolated; between rows the
//! nearest one is taken.
//!
//! # Parameters
//! `d_over_T`, default the row nearest to d/T: row of the table, dead time over lag (0.2, 0.4, … 2).
//!
//! # When
//! An integrator with lag where a PI must remove loads at its input fast and derivative action is not wanted.
//!
//! # Limits
//! For d/T from 0.2 to 2; its row for no lag is the rule for the plain integrator, pi-poulin-input. Sensitivity
//! peak 1.93, phase margin 34° at T = d. From a secondary transcription.
//!
//! # Published values
//! `Ti/(T + d)` = 3.9465 (d/T = 0.2); `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5320; `Ti/(T + d)` = 3.9981
//! (d/T = 0.4); `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5315; `Ti/(T + d)` = 4.0397 (d/T = 0.6);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5311; `Ti/(T + d)` = 4.0397 (d/T = 0.8);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5311; `Ti/(T + d)` = 4.0397 (d/T = 1);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5311; `Ti/(T + d)` = 4.0337 (d/T = 1.2);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5312; `Ti/(T + d)` = 4.0278 (d/T = 1.4);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5312; `Ti/(T + d)` = 4.0278 (d/T = 1.6);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5312; `Ti/(T + d)` = 4.0218 (d/T = 1.8);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5313; `Ti/(T + d)` = 4.0099 (d/T = 2);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5314.
//!
//! # Reference
//! Poulin, Pomerleau (1996), PID tuning for integrating and unstable processes, IEE Proc. Control Theory Appl. 143,
//! 429-435.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pi-poulin-input",
    name: "Poulin-Pomerleau PI, ITAE of a load at the process input",
    authors: "Poulin, Pomerleau",
    year: 1996,
    citation: "PID tuning for integrating and unstable processes, IEE Proc. Control Theory Appl. 143, 429-435",
    structure: "PI",
    process: Applies::IntegratingWithLag,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "d_over_T",
        Unit::Ratio,
        Default::Formula(
            "near(d/T, 0.2, 0.2, 0.4, 0.4, 0.6, 0.6, 0.8, 0.8, 1, 1, 1.2, 1.2, 1.4, 1.4, 1.6, 1.6, \
                         1.8, 1.8, 2, 2)",
        ),
        "row of the table: dead time over lag",
    )
    .range("0.2 | 0.4 | 0.6 | 0.8 | 1 | 1.2 | 1.4 | 1.6 | 1.8 | 2")],
    formula: &[
        (
            "x1",
            "row(d_over_T, 0.2, 3.9465, 0.4, 3.9981, 0.6, 4.0397, 0.8, 4.0397, 1, 4.0397, 1.2, 4.0337, 1.4, \
                4.0278, 1.6, 4.0278, 1.8, 4.0218, 2, 4.0099)",
        ),
        (
            "x2",
            "row(d_over_T, 0.2, 0.5320, 0.4, 0.5315, 0.6, 0.5311, 0.8, 0.5311, 1, 0.5311, 1.2, 0.5312, 1.4, \
                0.5312, 1.6, 0.5312, 1.8, 0.5313, 2, 0.5314)",
        ),
        ("Kc", "x2/(K*(T + d))*sqrt(1 + T^2/(x1*(T + d)^2))"),
        ("Ti", "x1*(T + d)"),
    ],
    when: "An integrator with lag where a PI must remove loads at its input fast and derivative action is not \
           wanted.",
    limits: "For d/T from 0.2 to 2; its row for no lag is the rule for the plain integrator, pi-poulin-input. \
             Sensitivity peak 1.93, phase margin 34° at T = d. From a secondary transcription.",
    validity: &[("d/T", "0.2..2")],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner, a C# transcription of O'Dwyer's tables, \
             Methods/TunningMethods/FOLIPDModelTunningMethods, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pi-poulin-input.toml"),
    law: by_formula,
};
