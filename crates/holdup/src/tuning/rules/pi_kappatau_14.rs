//! Kappa-tau step response PI, Ms=1.4, at tau=1 (pure IPDT).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.41*exp(-0.23*tau + 0.019*tau^2)*tau/(K*d)`, `Ti = 5.7*d*exp(1.7*tau - 0.69*tau^2)`,
//! `b = 0.33*exp(2.5*tau - 1.9*tau^2)`. The general form is for a lag as well: `a = K*(d + T)`, `tau = d/(d + T)`, so
//! `K*(d + T)` is written `K*d/tau`; this process has tau = 1.
//!
//! # Parameters
//! `tau`, default 1: normalised dead time d/(d + T), 1 for the plain integrator (must be > 0 and <= 1).
//!
//! # When
//! Robust control (`M_s` 1.38) with a setpoint weight that takes the overshoot away.
//!
//! # Limits
//! A fit over many processes with lag, at the edge of its range. Slow: load IAE 47 K d^2. From memory; its design
//! condition holds, which speaks for the numbers.
//!
//! # Published values
//! `sensitivity_peak` = 1.4; `b` = 0.6012992041288681.
//!
//! # Reference
//! Astrom, Hagglund (1995), PID Controllers: Theory, Design and Tuning, 2nd ed., ISA, tables for integrating
//! processes. From memory: no source was read.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-kappatau-14",
    name: "Kappa-tau step response PI, Ms=1.4, at tau=1 (pure IPDT)",
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
        ("Kc", "0.41*exp(-0.23*tau + 0.019*tau^2)*tau/(K*d)"),
        ("Ti", "5.7*d*exp(1.7*tau - 0.69*tau^2)"),
        ("b", "0.33*exp(2.5*tau - 1.9*tau^2)"),
    ],
    when: "Robust control (M_s 1.38) with a setpoint weight that takes the overshoot away.",
    limits: "A fit over many processes with lag, at the edge of its range. Slow: load IAE 47 K d^2. From \
             memory; its design condition holds, which speaks for the numbers.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "none retrieved",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-kappatau-14.toml"),
    law: by_formula,
};
