//! Poulin-Pomerleau PI, ITAE of a load at the process output.
//!
//! # Applies to
//! The integrator with lag T and dead time, `K·e^(−d·s)/(s·(T·s + 1))`.
//!
//! # Formula
//! `x1 = row(d_over_T, 0.2, 5.0728, 0.4, 4.9688, 0.6, 4.8983, 0.8, 4.8218, 1, 4.7839, 1.2, 4.7565, 1.4, 4.7293,
//! 1.6, 4.7107, 1.8, 4.7837, 2, 4.6837)`, `x2 = row(d_over_T, 0.2, 0.5231, 0.4, 0.5237, 0.6, 0.5241, 0.8, 0.5245,
//! 1, 0.5249, 1.2, 0.5250, 1.4, 0.5252, 1.6, 0.5254, 1.8, 0.5256, 2, 0.5257)`,
//! `Kc = x2/(K*(T + d))*sqrt(1 + T^2/(x1*(T + d)^2))`, `Ti = x1*(T + d)`. Nothing is interpolated; between rows the
//! nearest one is taken.
//!
//! # Parameters
//! `d_over_T`, default the row nearest to d/T: row of the table, dead time over lag (0.2, 0.4, … 2).
//!
//! # When
//! An integrator with lag under a PI whose setpoint steps and output disturbances matter more than loads at its
//! input.
//!
//! # Limits
//! For d/T from 0.2 to 2. The row d/T = 1.8 prints x1 = 4.7837 between 4.7107 and 4.6837, likely a misprint for
//! about 4.696; it is used as printed. Sensitivity peak 1.81, phase margin 38° at T = d. From a secondary
//! transcription.
//!
//! # Published values
//! `Ti/(T + d)` = 5.0728 (d/T = 0.2); `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5231; `Ti/(T + d)` = 4.9688
//! (d/T = 0.4); `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5237; `Ti/(T + d)` = 4.8983 (d/T = 0.6);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5241; `Ti/(T + d)` = 4.8218 (d/T = 0.8);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5245; `Ti/(T + d)` = 4.7839 (d/T = 1);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5249; `Ti/(T + d)` = 4.7565 (d/T = 1.2);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5250; `Ti/(T + d)` = 4.7293 (d/T = 1.4);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5252; `Ti/(T + d)` = 4.7107 (d/T = 1.6);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5254; `Ti/(T + d)` = 4.7837 (d/T = 1.8);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5256; `Ti/(T + d)` = 4.6837 (d/T = 2);
//! `Kc*K*(T + d)/sqrt(1 + T^2/(Ti*(T + d)))` = 0.5257.
//!
//! # Reference
//! Poulin, Pomerleau (1996), PID tuning for integrating and unstable processes, IEE Proc. Control Theory Appl. 143,
//! 429-435.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pi-poulin-output",
    name: "Poulin-Pomerleau PI, ITAE of a load at the process output",
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
            "row(d_over_T, 0.2, 5.0728, 0.4, 4.9688, 0.6, 4.8983, 0.8, 4.8218, 1, 4.7839, 1.2, 4.7565, 1.4, \
                4.7293, 1.6, 4.7107, 1.8, 4.7837, 2, 4.6837)",
        ),
        (
            "x2",
            "row(d_over_T, 0.2, 0.5231, 0.4, 0.5237, 0.6, 0.5241, 0.8, 0.5245, 1, 0.5249, 1.2, 0.5250, 1.4, \
                0.5252, 1.6, 0.5254, 1.8, 0.5256, 2, 0.5257)",
        ),
        ("Kc", "x2/(K*(T + d))*sqrt(1 + T^2/(x1*(T + d)^2))"),
        ("Ti", "x1*(T + d)"),
    ],
    when: "An integrator with lag under a PI whose setpoint steps and output disturbances matter more than \
           loads at its input.",
    limits: "For d/T from 0.2 to 2. The row d/T = 1.8 prints x1 = 4.7837 between 4.7107 and 4.6837, likely a \
             misprint for about 4.696; it is used as printed. Sensitivity peak 1.81, phase margin 38° at T = \
             d. From a secondary transcription.",
    validity: &[("d/T", "0.2..2")],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner, a C# transcription of O'Dwyer's tables, \
             Methods/TunningMethods/FOLIPDModelTunningMethods, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pi-poulin-output.toml"),
    law: by_formula,
};
