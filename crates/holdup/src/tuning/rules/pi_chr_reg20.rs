//! Chien-Hrones-Reswick load 20% overshoot, PI, slope form.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.7/(K*d)`, `Ti = 2.3*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Only to compare with: `pi-chr-reg0` of the same authors is the usable one.
//!
//! # Limits
//! Gain margin 1.66, phase margin 16 deg, `M_s` 4.08, a setpoint step overshoots by 94 %.
//!
//! # Published values
//! None: the formula is from memory and no number of the paper was retrieved.
//!
//! # Reference
//! Chien, Hrones, Reswick (1952), Trans. ASME 74, 175-185. From memory: no source was read.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-chr-reg20",
    name: "Chien-Hrones-Reswick load 20% overshoot, PI, slope form",
    authors: "Chien, Hrones, Reswick",
    year: 1952,
    citation: "Trans. ASME 74, 175-185",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.7/(K*d)"), ("Ti", "2.3*d")],
    when: "Only to compare with: pi-chr-reg0 of the same authors is the usable one.",
    limits: "Gain margin 1.66, phase margin 16 deg, M_s 4.08, a setpoint step overshoots by 94 %.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "none retrieved",
    status: Status::History("from memory without a source, and nearly undamped (M_s 4.1)"),
    values: include_str!("../../../tests/rules/pi-chr-reg20.toml"),
    law: by_formula,
};
