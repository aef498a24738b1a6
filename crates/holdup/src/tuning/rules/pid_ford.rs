//! Ford 1953 PID.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1.48/(K*d)`
//! - `Ti = 2*d`
//! - `Td = 0.37*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field.
//!
//! # Limits
//! The derivative is unfiltered in the source. Sensitivity peak 5.9. From memory, no source was read.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Ford (1953), R.L. Ford, The determination of the optimum process-controller settings, Proc. IEE 101
//! (1953-54) (via O'Dwyer).

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-ford",
    name: "Ford 1953 PID",
    authors: "Ford",
    year: 1953,
    citation: "R.L. Ford, The determination of the optimum process-controller settings, Proc. IEE 101 (1953-54) (via O'Dwyer)",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.48/(K*d)"), ("Ti", "2*d"), ("Td", "0.37*d")],
    when: "As history of the field.",
    limits: "The derivative is unfiltered in the source. Sensitivity peak 5.9. From memory, no source was read.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::History("sensitivity peak 5.9"),
    values: include_str!("../../../tests/rules/pid-ford.toml"),
    law: by_formula,
};
