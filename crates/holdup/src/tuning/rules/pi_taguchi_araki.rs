//! Taguchi-Araki 2DOF PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.7662/(K*d)`
//! - `Ti = 4.091*d`
//! - `b = 0.319`
//!
//! # Parameters
//! None.
//!
//! # When
//! Load rejection with a weighted setpoint.
//!
//! # Limits
//! From memory, no source was read.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Taguchi, Araki (2000), Two-degree-of-freedom PID controllers - their functions and optimal tuning, IFAC
//! PID'00.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-taguchi-araki",
    name: "Taguchi-Araki 2DOF PI",
    authors: "Taguchi, Araki",
    year: 2000,
    citation: "Two-degree-of-freedom PID controllers - their functions and optimal tuning, IFAC PID'00",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.7662/(K*d)"), ("Ti", "4.091*d"), ("b", "0.319")],
    when: "Load rejection with a weighted setpoint.",
    limits: "From memory, no source was read.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-taguchi-araki.toml"),
    law: by_formula,
};
