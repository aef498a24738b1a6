//! Chien-Hrones-Reswick load 0% overshoot, PI, slope form.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.6/(K*d)`, `Ti = 4*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Load rejection with little oscillation: decay ratio 0.015.
//!
//! # Limits
//! Gain margin 2.29, phase margin 32 deg, `M_s` 2.21; the 0 % is about the load response, a setpoint step overshoots
//! by 55 %. The paper is about processes with a lag; this is its limit for a pure slope.
//!
//! # Published values
//! `Kc*K*d` = 0.6; `Ti/d` = 4.0.
//!
//! # Reference
//! Chien, Hrones, Reswick (1952), Trans. ASME 74, 175-185.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-chr-reg0",
    name: "Chien-Hrones-Reswick load 0% overshoot, PI, slope form",
    authors: "Chien, Hrones, Reswick",
    year: 1952,
    citation: "Trans. ASME 74, 175-185",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.6/(K*d)"), ("Ti", "4*d")],
    when: "Load rejection with little oscillation: decay ratio 0.015.",
    limits: "Gain margin 2.29, phase margin 32 deg, M_s 2.21; the 0 % is about the load response, a \
             setpoint step overshoots by 55 %. The paper is about processes with a lag; this is its limit \
             for a pure slope.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: utTuningStepResponse.m of MathWorks, integrating branch",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-chr-reg0.toml"),
    law: by_formula,
};
