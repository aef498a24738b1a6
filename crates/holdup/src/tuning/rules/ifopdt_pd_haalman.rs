//! Haalman-type PD (lag cancelled).
//!
//! # Applies to
//! The integrator with lag T and dead time.
//!
//! # Formula
//! - `Kc = 2/(3*K*d)`
//! - `Td = T`
//!
//! # Parameters
//! None.
//!
//! # When
//! The lag is cancelled; what remains is P control of the plain integrator.
//!
//! # Limits
//! The derivative is unfiltered. A load leaves a lasting error.
//!
//! # Published values
//! `Ms` = 1.9.
//!
//! # Reference
//! Haalman; Xue & Chen (1965), Control Engineering 12 (1965) 71-73; Xue/Chen/Atherton.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pd-haalman",
    name: "Haalman-type PD (lag cancelled)",
    authors: "Haalman; Xue & Chen",
    year: 1965,
    citation: "Control Engineering 12 (1965) 71-73; Xue/Chen/Atherton",
    structure: "PD",
    process: Applies::IntegratingWithLag,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "2/(3*K*d)"), ("Td", "T")],
    when: "The lag is cancelled; what remains is P control of the plain integrator.",
    limits: "The derivative is unfiltered. A load leaves a lasting error.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub 'foipdt.m - PD and PID Parameters for FOIPDT Models' (Xue/Chen/Atherton book code)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pd-haalman.toml"),
    law: by_formula,
};
