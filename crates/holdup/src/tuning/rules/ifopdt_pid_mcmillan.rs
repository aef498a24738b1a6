//! `McMillan` PID.
//!
//! # Applies to
//! The integrator with lag T and dead time.
//!
//! # Formula
//! - `B = 1 + (T/d)^0.65`
//! - `Kc = 1.111*T/(K*d^2)/B^2`
//! - `Ti = 2*d*B`
//! - `Td = Ti/4`
//!
//! # Parameters
//! None.
//!
//! # When
//! PID where the lag matters.
//!
//! # Limits
//! One toolbox omits the square of the bracket.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! `McMillan` (1984), Tuning and Control Loop Performance, ISA.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pid-mcmillan",
    name: "McMillan PID",
    authors: "McMillan",
    year: 1984,
    citation: "Tuning and Control Loop Performance, ISA",
    structure: "PID",
    process: Applies::IntegratingWithLag,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("B", "1 + (T/d)^0.65"), ("Kc", "1.111*T/(K*d^2)/B^2"), ("Ti", "2*d*B"), ("Td", "Ti/4")],
    when: "PID where the lag matters.",
    limits: "One toolbox omits the square of the bracket.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub 'foipdt.m - PD and PID Parameters for FOIPDT Models' (Xue/Chen/Atherton book code)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pid-mcmillan.toml"),
    law: by_formula,
};
