//! Direct synthesis for disturbance, PID with 2nd-order filter (1/1 Pade).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `eta = 3*lam + d`
//! - `D = 3*lam^2 + 3*lam*d + 0.5*d^2`
//! - `Kc = (eta + 0.5*d)/(K*D)`
//! - `Ti = eta + 0.5*d`
//! - `Td = 0.5*d*eta/(eta + 0.5*d)`
//! - `a1 = (lam^3 + 1.5*lam^2*d)/D`
//! - `a2 = 0.5*lam^3*d/D`
//!
//! # Parameters
//! `lam` [s], default 1.5*d: closed-loop time constant (range > 0, advised >= d).
//!
//! # When
//! Load rejection by direct synthesis, with a second-order filter on the output.
//!
//! # Limits
//! Derived here on a 1/1 approximation of the dead time; the paper's own formulas were not read.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Seshagiri Rao, Rao, Padma Sree (family) (2009), Direct synthesis-based controller design for integrating
//! processes with time delay, J. Franklin Inst. 346, 38-56 (structure; formula rederived here).

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-ds-disturbance",
    name: "Direct synthesis for disturbance, PID with 2nd-order filter (1/1 Pade)",
    authors: "Seshagiri Rao, Rao, Padma Sree (family)",
    year: 2009,
    citation: "Direct synthesis-based controller design for integrating processes with time delay, J. Franklin Inst. 346, 38-56 (structure; formula rederived here)",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::IdealOutputFilter,
    parameters: &[Parameter::new(
        "lam",
        Unit::Second,
        Default::Formula("1.5*d"),
        "closed-loop time constant",
    )
    .range("> 0")
    .advised(">= d")
    .asks(Property::ClosedLoopTimeConstant)],
    formula: &[
        ("eta", "3*lam + d"),
        ("D", "3*lam^2 + 3*lam*d + 0.5*d^2"),
        ("Kc", "(eta + 0.5*d)/(K*D)"),
        ("Ti", "eta + 0.5*d"),
        ("Td", "0.5*d*eta/(eta + 0.5*d)"),
        ("a1", "(lam^3 + 1.5*lam^2*d)/D"),
        ("a2", "0.5*lam^3*d/D"),
    ],
    when: "Load rejection by direct synthesis, with a second-order filter on the output.",
    limits: "Derived here on a 1/1 approximation of the dead time; the paper's own formulas were not read.",
    validity: &[],
    provenance: Provenance::Derived,
    source: "derived here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-ds-disturbance.toml"),
    law: by_formula,
};
