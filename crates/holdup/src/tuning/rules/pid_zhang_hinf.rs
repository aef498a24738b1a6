//! H-infinity PID with first-order filter.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `D = 3*lam^2 + 1.5*lam*d + 0.25*d^2`
//! - `Ti = 3*lam + d`
//! - `Kc = Ti/(K*D)`
//! - `Td = (d/2)*(3*lam + d/2)/(3*lam + d)`
//! - `Tf = lam^3/D`
//!
//! # Parameters
//! `lam` [s], default 2*d: closed-loop time constant (range > 0, advised >= d).
//!
//! # When
//! PID with a filter on its whole output, whose speed is one time.
//!
//! # Limits
//! From memory, derived again here. lam = d gives the sensitivity peak 2.29, 1.5 d gives 1.80.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Zhang, Xu, Sun (1999), Quantitative performance design for integrating processes with time delay,
//! Automatica 35, 719-723.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-zhang-hinf",
    name: "H-infinity PID with first-order filter",
    authors: "Zhang, Xu, Sun",
    year: 1999,
    citation: "Quantitative performance design for integrating processes with time delay, Automatica 35, 719-723",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::IdealOutputFilter,
    parameters: &[Parameter::new("lam", Unit::Second, Default::Formula("2*d"), "closed-loop time constant")
        .range("> 0")
        .advised(">= d")
        .asks(Property::ClosedLoopTimeConstant)],
    formula: &[
        ("D", "3*lam^2 + 1.5*lam*d + 0.25*d^2"),
        ("Ti", "3*lam + d"),
        ("Kc", "Ti/(K*D)"),
        ("Td", "(d/2)*(3*lam + d/2)/(3*lam + d)"),
        ("Tf", "lam^3/D"),
    ],
    when: "PID with a filter on its whole output, whose speed is one time.",
    limits: "From memory, derived again here. lam = d gives the sensitivity peak 2.29, 1.5 d gives 1.80.",
    validity: &[],
    provenance: Provenance::MemoryRederived,
    source: "memory; derived here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-zhang-hinf.toml"),
    law: by_formula,
};
