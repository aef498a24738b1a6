//! Tyreus-Luyben PID (ultimate).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = pi/(2*2.2*K*d)`
//! - `Ti = 2.2*4*d`
//! - `Td = 4*d/6.3`
//!
//! # Parameters
//! None.
//!
//! # When
//! Robust PID from an ultimate-cycle test.
//!
//! # Limits
//! The derivative is unfiltered in the source.
//!
//! # Published values
//! `pi/2/(Kc*K*d)` = 2.2; `Ti/(4*d)` = 2.2; `4*d/Td` = 6.3.
//!
//! # Reference
//! Tyreus, Luyben; Luyben (1997), Luyben & Luyben, Essentials of Process Control (1997); Ku/2.2, 2.2 Pu,
//! Pu/6.3.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-tyreus-luyben",
    name: "Tyreus-Luyben PID (ultimate)",
    authors: "Tyreus, Luyben; Luyben",
    year: 1997,
    citation: "Luyben & Luyben, Essentials of Process Control (1997); Ku/2.2, 2.2 Pu, Pu/6.3",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "pi/(2*2.2*K*d)"), ("Ti", "2.2*4*d"), ("Td", "4*d/6.3")],
    when: "Robust PID from an ultimate-cycle test.",
    limits: "The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "https://pages.mtu.edu/~tbco/cm416/znmethod.pdf",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-tyreus-luyben.toml"),
    law: by_formula,
};
