//! Huba-Zakova PI, triple real pole.
//!
//! # Applies to
//! The integrator with lag T and dead time.
//!
//! # Formula
//! - `x1 = near(d/T, 0.5, 0.193, 1, 0.207, 2, 0.219)`
//! - `x2 = near(d/T, 0.5, 3.717, 1, 3.386, 2, 3.127)`
//! - `Kc = 2*x1/(K*(T + d))`
//! - `Ti = 2*x2*(T + d)`
//!
//! # Parameters
//! None.
//!
//! # When
//! A triple real pole.
//!
//! # Limits
//! The printed row nearest to d/T is used; the exact triple root is not computed.
//!
//! # Published values
//! `Kc*K*(T + d)/2` = 0.207; `Ti/(T + d)/2` = 3.386.
//!
//! # Reference
//! Huba, Zakova (2003), via O'Dwyer.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pi-huba-zakova",
    name: "Huba-Zakova PI, triple real pole",
    authors: "Huba, Zakova",
    year: 2003,
    citation: "via O'Dwyer",
    structure: "PI",
    process: Applies::IntegratingWithLag,
    form: Form::Ideal,
    parameters: &[],
    formula: &[
        ("x1", "near(d/T, 0.5, 0.193, 1, 0.207, 2, 0.219)"),
        ("x2", "near(d/T, 0.5, 3.717, 1, 3.386, 2, 3.127)"),
        ("Kc", "2*x1/(K*(T + d))"),
        ("Ti", "2*x2*(T + d)"),
    ],
    when: "A triple real pole.",
    limits: "The printed row nearest to d/T is used; the exact triple root is not computed.",
    validity: &[("d/T", "0.5..2")],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner, Methods/TunningMethods/FOLIPDModelTunningMethods/*.cs, commit 59b8950a; derived here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pi-huba-zakova.toml"),
    law: by_formula,
};
