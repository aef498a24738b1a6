//! IMC PID (Seborg row O).
//!
//! # Applies to
//! The integrator with lag T and dead time.
//!
//! # Formula
//! - `Kc = (2*tau_c + T + d)/(K*(tau_c + d)^2)`
//! - `Ti = 2*tau_c + T + d`
//! - `Td = (2*tau_c + d)*T/(2*tau_c + T + d)`
//!
//! # Parameters
//! `tau_c` [s], default sqrt(10)*d: closed-loop time constant (range > 0, advised >= 2*d).
//!
//! # When
//! PID whose speed is one time.
//!
//! # Limits
//! The derivative is unfiltered in the source. From memory, no source was read.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Chien, Fruehauf (1990), Chem. Eng. Prog. 86(10); Seborg Table 12.1 row O.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pid-imc-o",
    name: "IMC PID (Seborg row O)",
    authors: "Chien, Fruehauf",
    year: 1990,
    citation: "Chem. Eng. Prog. 86(10); Seborg Table 12.1 row O",
    structure: "PID",
    process: Applies::IntegratingWithLag,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "tau_c",
        Unit::Second,
        Default::Formula("sqrt(10)*d"),
        "closed-loop time constant",
    )
    .range("> 0")
    .advised(">= 2*d")
    .asks(Property::ClosedLoopTimeConstant)],
    formula: &[
        ("Kc", "(2*tau_c + T + d)/(K*(tau_c + d)^2)"),
        ("Ti", "2*tau_c + T + d"),
        ("Td", "(2*tau_c + d)*T/(2*tau_c + T + d)"),
    ],
    when: "PID whose speed is one time.",
    limits: "The derivative is unfiltered in the source. From memory, no source was read.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pid-imc-o.toml"),
    law: by_formula,
};
