//! IMC PID for an integrator with lag.
//!
//! # Applies to
//! The integrator with lag T and dead time, `K·e^(−d·s)/(s·(T·s + 1))`.
//!
//! # Formula
//! `Kc = (2*tau_c + T + d)/(K*(tau_c + d)^2)`, `Ti = 2*tau_c + T + d`, `Td = (2*tau_c + d)*T/(2*tau_c + T + d)`. It
//! cancels the lag: the loop is that of a PI on the plain integrator whatever T is.
//!
//! # Parameters
//! `tau_c` [s], default sqrt(10)·d: closed-loop time constant, advised at least 2·d.
//!
//! # When
//! A smooth PID for an integrator with lag whose speed is one time constant.
//!
//! # Limits
//! From memory: no source was read. `tau_c` below 2 d is not robust: the sensitivity peak is 1.58 at the default,
//! 1.95 at 2 d and 3.29 at d, for every T. The derivative is unfiltered in the source.
//!
//! # Published values
//! No published value came with it; its margins do not depend on T.
//!
//! # Reference
//! Chien, Fruehauf (1990), Consider IMC tuning to improve controller performance, Chem. Eng. Prog. 86(10); Seborg,
//! Edgar, Mellichamp, Table 12.1, row O.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pid-imc-o",
    name: "IMC PID for an integrator with lag",
    authors: "Chien, Fruehauf",
    year: 1990,
    citation: "Consider IMC tuning to improve controller performance, Chem. Eng. Prog. 86(10); Seborg, Edgar, \
               Mellichamp, Table 12.1, row O",
    structure: "PID",
    process: Applies::IntegratingWithLag,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "tau_c",
        Unit::Second,
        Default::Formula("sqrt(10)*d"),
        "closed-loop time constant",
    )
    .advised(">= 2*d")
    .asks(Property::ClosedLoopTimeConstant)],
    formula: &[
        ("Kc", "(2*tau_c + T + d)/(K*(tau_c + d)^2)"),
        ("Ti", "2*tau_c + T + d"),
        ("Td", "(2*tau_c + d)*T/(2*tau_c + T + d)"),
    ],
    when: "A smooth PID for an integrator with lag whose speed is one time constant.",
    limits: "From memory: no source was read. tau_c below 2 d is not robust: the sensitivity peak is 1.58 at \
             the default, 1.95 at 2 d and 3.29 at d, for every T. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory: no source was read",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pid-imc-o.toml"),
    law: by_formula,
};
