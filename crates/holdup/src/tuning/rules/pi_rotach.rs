//! Rotach, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.75/(K*d)`, `Ti = 2.41*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Only to compare with: quarter-decay tuning.
//!
//! # Limits
//! Gain margin 1.58, phase margin 16 deg, `M_s` 4.21, a setpoint step overshoots by 96 %. From memory; its decay
//! holds.
//!
//! # Published values
//! `1 - decay_ratio` = 0.75.
//!
//! # Reference
//! Rotach (1995), Automation tuning of PID controllers (via O'Dwyer). From memory: no source was read.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-rotach",
    name: "Rotach, PI",
    authors: "Rotach",
    year: 1995,
    citation: "Automation tuning of PID controllers (via O'Dwyer)",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.75/(K*d)"), ("Ti", "2.41*d")],
    when: "Only to compare with: quarter-decay tuning.",
    limits: "Gain margin 1.58, phase margin 16 deg, M_s 4.21, a setpoint step overshoots by 96 %. From \
             memory; its decay holds.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "none retrieved",
    status: Status::History("a quarter-decay loop with hardly any robustness (M_s 4.2)"),
    values: include_str!("../../../tests/rules/pi-rotach.toml"),
    law: by_formula,
};
