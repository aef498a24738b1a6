//! PD with a triple real pole for the double integrator.
//!
//! # Applies to
//! The double integrator with dead time, `K·e^(−d·s)/s²`.
//!
//! # Formula
//! `Kc = 2*(sqrt(2) - 1)*exp(sqrt(2) - 2)/((3 + 2*sqrt(2))*K*d^2)`, `Td = (3 + 2*sqrt(2))*d`. A triple root of
//! `s^2*exp(d*s) + K*Kc*(1 + Td*s)`: its second derivative vanishes at `s*d = sqrt(2) - 2`. It is the loop of
//! pi-mrdp on the plain integrator.
//!
//! # Parameters
//! None.
//!
//! # When
//! Setpoint steps of a double integrator without oscillation at the fastest triple real pole.
//!
//! # Limits
//! A load D at the process input leaves a lasting error of D/Kc. Sensitivity peak 1.70, gain margin 3.13, phase
//! margin 43°; at setpoint weight 1 the large derivative makes a setpoint step overshoot. The derivative is
//! unfiltered.
//!
//! # Published values
//! `Kc*K*d^2` = 0.079; `Kc*Td*K*d` = 0.461; `Kc*K*d^2` = 0.0791223; `decay_rate*d` = 0.586.
//!
//! # Reference
//! Huba (1999), M. Huba and others, dynamical classes of PID control: double integrator with dead time.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "dipdt-pd-mrdp",
    name: "PD with a triple real pole for the double integrator",
    authors: "Huba",
    year: 1999,
    citation: "M. Huba and others, dynamical classes of PID control: double integrator with dead time",
    structure: "PD",
    process: Applies::DoubleIntegrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[
        ("Kc", "2*(sqrt(2) - 1)*exp(sqrt(2) - 2)/((3 + 2*sqrt(2))*K*d^2)"),
        ("Td", "(3 + 2*sqrt(2))*d"),
    ],
    when: "Setpoint steps of a double integrator without oscillation at the fastest triple real pole.",
    limits: "A load D at the process input leaves a lasting error of D/Kc. Sensitivity peak 1.70, gain margin \
             3.13, phase margin 43°; at setpoint weight 1 the large derivative makes a setpoint step \
             overshoot. The derivative is unfiltered.",
    validity: &[],
    provenance: Provenance::MemoryRederived,
    source: "memory (no source was read); derived again here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/dipdt-pd-mrdp.toml"),
    law: by_formula,
};
