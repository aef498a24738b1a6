//! McMillan PID for an integrator with lag.
//!
//! # Applies to
//! The integrator with lag T and dead time, `K·e^(−d·s)/(s·(T·s + 1))`.
//!
//! # Formula
//! `Kc = 1.111*T/(K*d^2)/(1 + (T/d)^0.65)^2`, `Ti = 2*d*(1 + (T/d)^0.65)`, `Td = Ti/4`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Integrators with a lag of about the dead time, where a slow oscillation after a load is accepted.
//!
//! # Limits
//! Poorly damped: dominant damping 0.29 and phase margin 28° at T = d, 0.17 and 18° at T = 0.2 d, 0.21 and 22° at
//! T = 5 d, while the gain margin is 5.9 or more: the gain is low for its integral time. One public toolbox omits
//! the square of the bracket. The derivative is unfiltered in the source.
//!
//! # Published values
//! No published value came with the code.
//!
//! # Reference
//! McMillan (1984), Tuning and Control Loop Performance, ISA.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pid-mcmillan",
    name: "McMillan PID for an integrator with lag",
    authors: "McMillan",
    year: 1984,
    citation: "Tuning and Control Loop Performance, ISA",
    structure: "PID",
    process: Applies::IntegratingWithLag,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.111*T/(K*d^2)/(1 + (T/d)^0.65)^2"), ("Ti", "2*d*(1 + (T/d)^0.65)"), ("Td", "Ti/4")],
    when: "Integrators with a lag of about the dead time, where a slow oscillation after a load is accepted.",
    limits: "Poorly damped: dominant damping 0.29 and phase margin 28° at T = d, 0.17 and 18° at T = 0.2 d, \
             0.21 and 22° at T = 5 d, while the gain margin is 5.9 or more: the gain is low for its integral \
             time. One public toolbox omits the square of the bracket. The derivative is unfiltered in the \
             source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: foipdt.m, PD and PID settings for FOIPDT models (Xue, Chen, Atherton, book \
             code)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pid-mcmillan.toml"),
    law: by_formula,
};
