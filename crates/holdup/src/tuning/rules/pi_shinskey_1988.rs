//! Shinskey min-IAE load, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.9259/(K*d)`, `Ti = 4*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Load rejection above all: load IAE 4.9 K d^2, close to the least that PI control can have.
//!
//! # Limits
//! No robustness: gain margin 1.48, phase margin 21 deg, `M_s` 3.90, a setpoint step overshoots by 86 %. Written in
//! the source as a proportional band of 108 K d %. From memory.
//!
//! # Published values
//! `Kc*K*d` = 0.9259; `Ti/d` = 4.0.
//!
//! # Reference
//! Shinskey (1988), Process Control Systems, 3rd ed.. From memory: no source was read.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-shinskey-1988",
    name: "Shinskey min-IAE load, PI",
    authors: "Shinskey",
    year: 1988,
    citation: "Process Control Systems, 3rd ed.",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.9259/(K*d)"), ("Ti", "4*d")],
    when: "Load rejection above all: load IAE 4.9 K d^2, close to the least that PI control can have.",
    limits: "No robustness: gain margin 1.48, phase margin 21 deg, M_s 3.90, a setpoint step overshoots \
             by 86 %. Written in the source as a proportional band of 108 K d %. From memory.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "none retrieved",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-shinskey-1988.toml"),
    law: by_formula,
};
