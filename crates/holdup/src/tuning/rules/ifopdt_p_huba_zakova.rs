//! Huba-Zakova P, double real pole.
//!
//! # Applies to
//! The integrator with lag T and dead time.
//!
//! # Formula
//! - `r = sqrt(d^2 + 4*T^2)`
//! - `Kc = d^2/(2*T + r)/(K*d^2*exp((2*T + d - r)/(2*T)))`
//!
//! # Parameters
//! None.
//!
//! # When
//! P control without overshoot: a double real pole.
//!
//! # Limits
//! A load leaves a lasting error. r - 2 T is written d^2/(r + 2 T), which does not cancel.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Huba, Zakova (2003), via O'Dwyer.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-p-huba-zakova",
    name: "Huba-Zakova P, double real pole",
    authors: "Huba, Zakova",
    year: 2003,
    citation: "via O'Dwyer",
    structure: "P",
    process: Applies::IntegratingWithLag,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("r", "sqrt(d^2 + 4*T^2)"), ("Kc", "d^2/(2*T + r)/(K*d^2*exp((2*T + d - r)/(2*T)))")],
    when: "P control without overshoot: a double real pole.",
    limits: "A load leaves a lasting error. r - 2 T is written d^2/(r + 2 T), which does not cancel.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner, Methods/TunningMethods/FOLIPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-p-huba-zakova.toml"),
    law: by_formula,
};
