//! Luyben 1996 PID, series with 0.1 derivative filter.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.46*pi/(2*K*d)`
//! - `Ti = 2.2*4*d`
//! - `Td = 0.16*4*d`
//! - `Tf = 0.1*Td`
//!
//! # Parameters
//! None.
//!
//! # When
//! Robust PID with a filtered lead.
//!
//! # Limits
//! From memory, no source was read.
//!
//! # Published values
//! `Mt` = 1.259.
//!
//! # Reference
//! Luyben (1996), Tuning proportional-integral-derivative controllers for integrator/deadtime processes, Ind.
//! Eng. Chem. Res. 35, 3480-3483.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-luyben1996",
    name: "Luyben 1996 PID, series with 0.1 derivative filter",
    authors: "Luyben",
    year: 1996,
    citation: "Tuning proportional-integral-derivative controllers for integrator/deadtime processes, Ind. Eng. Chem. Res. 35, 3480-3483",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::SeriesOutputFilter,
    parameters: &[],
    formula: &[("Kc", "0.46*pi/(2*K*d)"), ("Ti", "2.2*4*d"), ("Td", "0.16*4*d"), ("Tf", "0.1*Td")],
    when: "Robust PID with a filtered lead.",
    limits: "From memory, no source was read.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-luyben1996.toml"),
    law: by_formula,
};
