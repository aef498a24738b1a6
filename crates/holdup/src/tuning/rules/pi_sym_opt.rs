//! Symmetrical optimum PI (lag lumped into d), extended form.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1/(sqrt(beta)*K*d)`
//! - `Ti = beta*d`
//!
//! # Parameters
//! `beta`, default 4.0: ratio of integral time to dead time (range > 1, advised 4..16).
//!
//! # When
//! Drives and motion, where it comes from.
//!
//! # Limits
//! From memory, no source was read. The dead time stands for the sum of small time constants.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Kessler; Preitl, Precup (1999), C. Kessler 1958; Preitl-Precup extended symmetrical optimum, Automatica 35
//! (1999) 1731-1736.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-sym-opt",
    name: "Symmetrical optimum PI (lag lumped into d), extended form",
    authors: "Kessler; Preitl, Precup",
    year: 1999,
    citation: "C. Kessler 1958; Preitl-Precup extended symmetrical optimum, Automatica 35 (1999) 1731-1736",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "beta",
        Unit::Ratio,
        Default::Number(4.0),
        "ratio of integral time to dead time",
    )
    .range("> 1")
    .advised("4..16")],
    formula: &[("Kc", "1/(sqrt(beta)*K*d)"), ("Ti", "beta*d")],
    when: "Drives and motion, where it comes from.",
    limits: "From memory, no source was read. The dead time stands for the sum of small time constants.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-sym-opt.toml"),
    law: by_formula,
};
