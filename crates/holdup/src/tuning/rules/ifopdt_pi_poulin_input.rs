//! Poulin-Pomerleau ITAE PI, input load.
//!
//! # Applies to
//! The integrator with lag T and dead time.
//!
//! # Formula
//! - `x1 = near(d/T, 0.2, 3.9465, 0.4, 3.9981, 0.6, 4.0397, 0.8, 4.0397, 1, 4.0397, 1.2, 4.0337, 1.4, 4.0278, 1.6, 4.0278, 1.8, 4.0218, 2, 4.0099)`
//! - `x2 = near(d/T, 0.2, 0.5320, 0.4, 0.5315, 0.6, 0.5311, 0.8, 0.5311, 1, 0.5311, 1.2, 0.5312, 1.4, 0.5312, 1.6, 0.5312, 1.8, 0.5313, 2, 0.5314)`
//! - `Kc = x2/(K*(T + d))*sqrt(1 + T^2/(x1*(T + d)^2))`
//! - `Ti = x1*(T + d)`
//!
//! # Parameters
//! None.
//!
//! # When
//! Load rejection by least ITAE.
//!
//! # Limits
//! The printed row nearest to d/T is used; outside 0.2 to 2 the last row.
//!
//! # Published values
//! `Ti/(T + d)` = 4.0397; `Ti/(T + d)` = 3.9981.
//!
//! # Reference
//! Poulin, Pomerleau (1996), IEE Proc. CTA 143.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pi-poulin-input",
    name: "Poulin-Pomerleau ITAE PI, input load",
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
            "near(d/T, 0.2, 3.9465, 0.4, 3.9981, 0.6, 4.0397, 0.8, 4.0397, 1, 4.0397, 1.2, 4.0337, 1.4, 4.0278, 1.6, 4.0278, 1.8, 4.0218, 2, 4.0099)",
        ),
        (
            "x2",
            "near(d/T, 0.2, 0.5320, 0.4, 0.5315, 0.6, 0.5311, 0.8, 0.5311, 1, 0.5311, 1.2, 0.5312, 1.4, 0.5312, 1.6, 0.5312, 1.8, 0.5313, 2, 0.5314)",
        ),
        ("Kc", "x2/(K*(T + d))*sqrt(1 + T^2/(x1*(T + d)^2))"),
        ("Ti", "x1*(T + d)"),
    ],
    when: "Load rejection by least ITAE.",
    limits: "The printed row nearest to d/T is used; outside 0.2 to 2 the last row.",
    validity: &[("d/T", "0.2..2")],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner, Methods/TunningMethods/FOLIPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pi-poulin-input.toml"),
    law: by_formula,
};
