//! Kappa-tau PID Ms=1.4 at tau=1 (memory).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 5.6*exp(-8.8*tau + 6.8*tau^2)*tau/(K*d)`
//! - `Ti = 1.1*d*exp(6.7*tau - 4.4*tau^2)`
//! - `Td = 1.7*d*exp(-6.4*tau + 2.0*tau^2)`
//!
//! # Parameters
//! `tau`, default 1.0: dead time over dead time plus lag (range > 0 and <= 1).
//!
//! # When
//! Never.
//!
//! # Limits
//! The derivative is unfiltered in the source. From memory, and its stated sensitivity peak 1.4 does not come
//! out at tau = 1: it is 2.24.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Astrom, Hagglund (1995), PID Controllers (ISA 1995).

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-kappatau-14",
    name: "Kappa-tau PID Ms=1.4 at tau=1 (memory)",
    authors: "Astrom, Hagglund",
    year: 1995,
    citation: "PID Controllers (ISA 1995)",
    structure: "PID",
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
        ("Kc", "5.6*exp(-8.8*tau + 6.8*tau^2)*tau/(K*d)"),
        ("Ti", "1.1*d*exp(6.7*tau - 4.4*tau^2)"),
        ("Td", "1.7*d*exp(-6.4*tau + 2.0*tau^2)"),
    ],
    when: "Never.",
    limits: "The derivative is unfiltered in the source. From memory, and its stated sensitivity peak 1.4 does not come out at tau = 1: it is 2.24.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Wrong("from memory, and its stated sensitivity peak 1.4 does not come out: it is 2.24"),
    values: include_str!("../../../tests/rules/pid-kappatau-14.toml"),
    law: by_formula,
};
