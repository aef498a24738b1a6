//! Taguchi-Araki PID with two degrees of freedom.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1.253/(K*d)`, `Ti = 2.388*d`, `Td = 0.4137*d`, `b = 0.3358`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Fast load rejection where the proportional action shall see only a third of a setpoint step.
//!
//! # Limits
//! Sensitivity peak 3.5, gain margin 1.42, phase margin 28°. From memory: no source was read. The weight of the
//! derivative action on the setpoint, which the source has too, did not come here and stays 1. The derivative is
//! unfiltered in the source.
//!
//! # Published values
//! No value is published with it that could be checked.
//!
//! # Reference
//! Taguchi, Araki (2000), Two-degree-of-freedom PID controllers, IFAC Workshop on Digital Control PID'00.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-taguchi-araki",
    name: "Taguchi-Araki PID with two degrees of freedom",
    authors: "Taguchi, Araki",
    year: 2000,
    citation: "Two-degree-of-freedom PID controllers, IFAC Workshop on Digital Control PID'00",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.253/(K*d)"), ("Ti", "2.388*d"), ("Td", "0.4137*d"), ("b", "0.3358")],
    when: "Fast load rejection where the proportional action shall see only a third of a setpoint step.",
    limits: "Sensitivity peak 3.5, gain margin 1.42, phase margin 28°. From memory: no source was read. The \
             weight of the derivative action on the setpoint, which the source has too, did not come here and \
             stays 1. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory: no source was read",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-taguchi-araki.toml"),
    law: by_formula,
};
