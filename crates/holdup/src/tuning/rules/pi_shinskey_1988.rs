//! Shinskey min-IAE load, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.9259/(K*d)`
//! - `Ti = 4*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Least integrated error after a load, robustness aside.
//!
//! # Limits
//! Proportional band 108 K d. From memory, no source was read.
//!
//! # Published values
//! `Kc*K*d` = 0.9259; `Ti/d` = 4.0.
//!
//! # Reference
//! Shinskey (1988), Process Control Systems, 3rd ed..

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-shinskey-1988",
    name: "Shinskey min-IAE load, PI",
    authors: "Shinskey",
    year: 1988,
    citation: "Process Control Systems, 3rd ed.",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.9259/(K*d)"), ("Ti", "4*d")],
    when: "Least integrated error after a load, robustness aside.",
    limits: "Proportional band 108 K d. From memory, no source was read.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-shinskey-1988.toml"),
    law: by_formula,
};
