//! SIMC PID for an integrator with lag.
//!
//! # Applies to
//! The integrator with lag T and dead time, `K·e^(−d·s)/(s·(T·s + 1))`.
//!
//! # Formula
//! `Kc = 1/(K*(tau_c + d))`, `Ti = 4*(tau_c + d)`, `Td = T`. Series form: the lead cancels the lag, and the loop is
//! that of pi-simc on the plain integrator.
//!
//! # Parameters
//! `tau_c` [s], default d: closed-loop time constant, advised at least d.
//!
//! # When
//! The everyday choice for an integrator with lag.
//!
//! # Limits
//! `tau_c` below d is less robust than the author recommends. The derivative is unfiltered in the source: a lag
//! much longer than the dead time makes it a large noise gain.
//!
//! # Published values
//! `sensitivity_peak` = 1.7; `sensitivity_peak` = 1.70 (K = 2, d = 3, T = 7).
//!
//! # Reference
//! Skogestad (2003), Simple analytic rules for model reduction and PID controller tuning, J. Process Control 13,
//! 291-309.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pid-simc",
    name: "SIMC PID for an integrator with lag",
    authors: "Skogestad",
    year: 2003,
    citation: "Simple analytic rules for model reduction and PID controller tuning, J. Process Control 13, \
               291-309",
    structure: "PID",
    process: Applies::IntegratingWithLag,
    form: Form::Series,
    parameters: &[Parameter::new("tau_c", Unit::Second, Default::Formula("d"), "closed-loop time constant")
        .advised(">= d")
        .asks(Property::ClosedLoopTimeConstant)],
    formula: &[("Kc", "1/(K*(tau_c + d))"), ("Ti", "4*(tau_c + d)"), ("Td", "T")],
    when: "The everyday choice for an integrator with lag.",
    limits: "tau_c below d is less robust than the author recommends. The derivative is unfiltered in the \
             source: a lag much longer than the dead time makes it a large noise gain.",
    validity: &[],
    provenance: Provenance::RetrievedAndMemory,
    source: "public code on GitHub (pidtools \"Metody\"); memory (Skogestad 2003)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pid-simc.toml"),
    law: by_formula,
};
