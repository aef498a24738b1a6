//! Taguchi-Araki 2DOF PID.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1.253/(K*d)`
//! - `Ti = 2.388*d`
//! - `Td = 0.4137*d`
//! - `b = 0.3358`
//!
//! # Parameters
//! None.
//!
//! # When
//! Load rejection with a weighted setpoint.
//!
//! # Limits
//! The derivative is unfiltered in the source. From memory, no source was read.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Taguchi, Araki (2000), IFAC PID'00.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-taguchi-araki",
    name: "Taguchi-Araki 2DOF PID",
    authors: "Taguchi, Araki",
    year: 2000,
    citation: "IFAC PID'00",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.253/(K*d)"), ("Ti", "2.388*d"), ("Td", "0.4137*d"), ("b", "0.3358")],
    when: "Load rejection with a weighted setpoint.",
    limits: "The derivative is unfiltered in the source. From memory, no source was read.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-taguchi-araki.toml"),
    law: by_formula,
};
