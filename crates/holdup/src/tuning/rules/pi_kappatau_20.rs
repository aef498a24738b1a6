//! Kappa-tau step response PI, Ms=2.0, at tau=1.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.81*exp(-1.1*tau + 0.76*tau^2)*tau/(K*d)`
//! - `Ti = 3.4*d*exp(0.28*tau - 0.0089*tau^2)`
//! - `b = 0.38733653695729947`
//!
//! # Parameters
//! `tau`, default 1.0: dead time over dead time plus lag (range > 0 and <= 1).
//!
//! # When
//! Fast PI: sensitivity peak 2.0 at tau = 1.
//!
//! # Limits
//! From memory, no source was read. tau = d/(d + T) is 1 for the plain integrator; K (d + T) is written K
//! d/tau.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Astrom, Hagglund (1995), PID Controllers (ISA 1995).

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-kappatau-20",
    name: "Kappa-tau step response PI, Ms=2.0, at tau=1",
    authors: "Astrom, Hagglund",
    year: 1995,
    citation: "PID Controllers (ISA 1995)",
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
        ("Kc", "0.81*exp(-1.1*tau + 0.76*tau^2)*tau/(K*d)"),
        ("Ti", "3.4*d*exp(0.28*tau - 0.0089*tau^2)"),
        ("b", "0.38733653695729947"),
    ],
    when: "Fast PI: sensitivity peak 2.0 at tau = 1.",
    limits: "From memory, no source was read. tau = d/(d + T) is 1 for the plain integrator; K (d + T) is written K d/tau.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-kappatau-20.toml"),
    law: by_formula,
};
