//! Callender-Hartree-Porter PID, criterion 1.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.749/(K*d)`
//! - `Ti = 2.734*d`
//! - `Td = 0.303*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field.
//!
//! # Limits
//! The derivative is unfiltered in the source. From memory, no source was read.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Callender, Hartree, Porter (1936), Phil. Trans. R. Soc. A 235.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-callender-1",
    name: "Callender-Hartree-Porter PID, criterion 1",
    authors: "Callender, Hartree, Porter",
    year: 1936,
    citation: "Phil. Trans. R. Soc. A 235",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.749/(K*d)"), ("Ti", "2.734*d"), ("Td", "0.303*d")],
    when: "As history of the field.",
    limits: "The derivative is unfiltered in the source. From memory, no source was read.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-callender-1.toml"),
    law: by_formula,
};
