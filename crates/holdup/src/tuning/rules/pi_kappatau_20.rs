//! Kappa-tau step response PI, Ms=2.0, at tau=1.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.81*exp(-1.1*tau + 0.76*tau^2)*tau/(K*d)`, `Ti = 3.4*d*exp(0.28*tau - 0.0089*tau^2)`,
//! `b = 0.78*exp(-1.9*tau + 1.2*tau^2)`. The general form is for a lag as well: `a = K*(d + T)`, `tau = d/(d + T)`, so
//! `K*(d + T)` is written `K*d/tau`; this process has tau = 1.
//!
//! # Parameters
//! `tau`, default 1: normalised dead time d/(d + T), 1 for the plain integrator (must be > 0 and <= 1).
//!
//! # When
//! Fast load rejection with a setpoint weight: `M_s` 2.07, yet a setpoint step overshoots by only 2 %.
//!
//! # Limits
//! A fit over many processes with lag, at the edge of its range: `M_s` is 2.07 instead of 2.0. From memory.
//!
//! # Published values
//! `sensitivity_peak` = 2.0; `b` = 0.38733653695729947.
//!
//! # Reference
//! Astrom, Hagglund (1995), PID Controllers: Theory, Design and Tuning, 2nd ed., ISA, tables for integrating
//! processes. From memory: no source was read.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-kappatau-20",
    name: "Kappa-tau step response PI, Ms=2.0, at tau=1",
    authors: "Astrom, Hagglund",
    year: 1995,
    citation: "PID Controllers: Theory, Design and Tuning, 2nd ed., ISA, tables for integrating processes",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "tau",
        Unit::Ratio,
        Default::Number(1.0),
        "normalised dead time d/(d + T), 1 for the plain integrator",
    )
    .range("> 0 and <= 1")],
    formula: &[
        ("Kc", "0.81*exp(-1.1*tau + 0.76*tau^2)*tau/(K*d)"),
        ("Ti", "3.4*d*exp(0.28*tau - 0.0089*tau^2)"),
        ("b", "0.78*exp(-1.9*tau + 1.2*tau^2)"),
    ],
    when: "Fast load rejection with a setpoint weight: M_s 2.07, yet a setpoint step overshoots by only 2 \
           %.",
    limits: "A fit over many processes with lag, at the edge of its range: M_s is 2.07 instead of 2.0. \
             From memory.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "none retrieved",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-kappatau-20.toml"),
    law: by_formula,
};
