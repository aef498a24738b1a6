//! Kappa-tau step response PI, Ms=1.4, at tau=1 (pure IPDT).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.41*exp(-0.23*tau + 0.019*tau^2)*tau/(K*d)`
//! - `Ti = 5.7*d*exp(1.7*tau - 0.69*tau^2)`
//! - `b = 0.6012992041288681`
//!
//! # Parameters
//! `tau`, default 1.0: dead time over dead time plus lag (range > 0 and <= 1).
//!
//! # When
//! Robust PI: sensitivity peak 1.4 at tau = 1.
//!
//! # Limits
//! From memory, no source was read. tau = d/(d + T) is 1 for the plain integrator; K (d + T) is written K
//! d/tau.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Astrom, Hagglund (1995), PID Controllers (ISA 1995), integrating-process tables: a=Kv(L+T), tau=L/(L+T);
//! f=a0 exp(a1 tau + a2 tau^2).

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-kappatau-14",
    name: "Kappa-tau step response PI, Ms=1.4, at tau=1 (pure IPDT)",
    authors: "Astrom, Hagglund",
    year: 1995,
    citation: "PID Controllers (ISA 1995), integrating-process tables: a=Kv(L+T), tau=L/(L+T); f=a0 exp(a1 tau + a2 tau^2)",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "tau",
        Unit::Ratio,
        Default::Number(1.0),
        "dead time over dead time plus lag",
    )
    .range("> 0 and <= 1")],
    formula: &[
        ("Kc", "0.41*exp(-0.23*tau + 0.019*tau^2)*tau/(K*d)"),
        ("Ti", "5.7*d*exp(1.7*tau - 0.69*tau^2)"),
        ("b", "0.6012992041288681"),
    ],
    when: "Robust PI: sensitivity peak 1.4 at tau = 1.",
    limits: "From memory, no source was read. tau = d/(d + T) is 1 for the plain integrator; K (d + T) is written K d/tau.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-kappatau-14.toml"),
    law: by_formula,
};
