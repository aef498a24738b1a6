//! Chidambaram-Sree 2003 PID.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1.2346/(K*d)`
//! - `Ti = 4.5*d`
//! - `Td = 0.45*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Fast load rejection where robustness may be spent.
//!
//! # Limits
//! The derivative is unfiltered in the source. Sensitivity peak 3.8. From memory, no source was read.
//!
//! # Published values
//! `Kc` = 4.066; `Ti` = 27; `Td` = 2.7.
//!
//! # Reference
//! Chidambaram, Padma Sree (2003), A simple method of tuning PID controllers for integrator/dead-time
//! processes, Comput. Chem. Eng. 27, 211-215.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-chidambaram-sree2003",
    name: "Chidambaram-Sree 2003 PID",
    authors: "Chidambaram, Padma Sree",
    year: 2003,
    citation: "A simple method of tuning PID controllers for integrator/dead-time processes, Comput. Chem. Eng. 27, 211-215",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.2346/(K*d)"), ("Ti", "4.5*d"), ("Td", "0.45*d")],
    when: "Fast load rejection where robustness may be spent.",
    limits: "The derivative is unfiltered in the source. Sensitivity peak 3.8. From memory, no source was read.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-chidambaram-sree2003.toml"),
    law: by_formula,
};
