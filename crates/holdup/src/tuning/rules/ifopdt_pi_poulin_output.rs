//! Poulin-Pomerleau ITAE PI, output load.
//!
//! # Applies to
//! The integrator with lag T and dead time.
//!
//! # Formula
//! - `x1 = near(d/T, 0.2, 5.0728, 0.4, 4.9688, 0.6, 4.8983, 0.8, 4.8218, 1, 4.7839, 1.2, 4.7565, 1.4, 4.7293, 1.6, 4.7107, 1.8, 4.7837, 2, 4.6837)`
//! - `x2 = near(d/T, 0.2, 0.5231, 0.4, 0.5237, 0.6, 0.5241, 0.8, 0.5245, 1, 0.5249, 1.2, 0.5250, 1.4, 0.5252, 1.6, 0.5254, 1.8, 0.5256, 2, 0.5257)`
//! - `Kc = x2/(K*(T + d))*sqrt(1 + T^2/(x1*(T + d)^2))`
//! - `Ti = x1*(T + d)`
//!
//! # Parameters
//! None.
//!
//! # When
//! Setpoint steps and output loads by least ITAE.
//!
//! # Limits
//! The printed row nearest to d/T is used; outside 0.2 to 2 the last row. Row 1.8 of x1, 4.7837, is out of
//! step with its neighbours and probably a misprint.
//!
//! # Published values
//! `Ti/(T + d)` = 4.7839; `Ti/(T + d)` = 4.9688.
//!
//! # Reference
//! Poulin, Pomerleau (1996), IEE Proc. CTA 143.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pi-poulin-output",
    name: "Poulin-Pomerleau ITAE PI, output load",
    authors: "Poulin, Pomerleau",
    year: 1996,
    citation: "IEE Proc. CTA 143",
    structure: "PI",
    process: Applies::IntegratingWithLag,
    form: Form::Ideal,
    parameters: &[],
    formula: &[
        (
            "x1",
            "near(d/T, 0.2, 5.0728, 0.4, 4.9688, 0.6, 4.8983, 0.8, 4.8218, 1, 4.7839, 1.2, 4.7565, 1.4, 4.7293, 1.6, 4.7107, 1.8, 4.7837, 2, 4.6837)",
        ),
        (
            "x2",
            "near(d/T, 0.2, 0.5231, 0.4, 0.5237, 0.6, 0.5241, 0.8, 0.5245, 1, 0.5249, 1.2, 0.5250, 1.4, 0.5252, 1.6, 0.5254, 1.8, 0.5256, 2, 0.5257)",
        ),
        ("Kc", "x2/(K*(T + d))*sqrt(1 + T^2/(x1*(T + d)^2))"),
        ("Ti", "x1*(T + d)"),
    ],
    when: "Setpoint steps and output loads by least ITAE.",
    limits: "The printed row nearest to d/T is used; outside 0.2 to 2 the last row. Row 1.8 of x1, 4.7837, is out of step with its neighbours and probably a misprint.",
    validity: &[("d/T", "0.2..2")],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner, Methods/TunningMethods/FOLIPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pi-poulin-output.toml"),
    law: by_formula,
};
