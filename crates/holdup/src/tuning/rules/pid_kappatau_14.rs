//! Kappa-tau PID for sensitivity peak 1.4, coefficients from memory.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `tau = 1`, `Kc = 5.6*exp(-8.8*tau + 6.8*tau^2)/(K*d)`, `Ti = 1.1*d*exp(6.7*tau - 4.4*tau^2)`,
//! `Td = 1.7*d*exp(-6.4*tau + 2*tau^2)`. tau = d/(d + T) is 1 on an integrator without lag.
//!
//! # Parameters
//! None.
//!
//! # When
//! Not to be used: kept to show what is wrong with it. pid-amigo by the same authors really has sensitivity peak
//! 1.4.
//!
//! # Limits
//! The sensitivity peak is 2.24, not 1.4: the remembered coefficients do not belong to this rule, or not to tau =
//! 1. Td comes out at 0.02 d, which is no derivative action.
//!
//! # Published values
//! `sensitivity_peak` = 1.4 — DIFFERENCE, see the values file.
//!
//! # Reference
//! Astrom, Hagglund (1995), PID Controllers: Theory, Design, and Tuning, ISA.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-kappatau-14",
    name: "Kappa-tau PID for sensitivity peak 1.4, coefficients from memory",
    authors: "Astrom, Hagglund",
    year: 1995,
    citation: "PID Controllers: Theory, Design, and Tuning, ISA",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[
        ("tau", "1"),
        ("Kc", "5.6*exp(-8.8*tau + 6.8*tau^2)/(K*d)"),
        ("Ti", "1.1*d*exp(6.7*tau - 4.4*tau^2)"),
        ("Td", "1.7*d*exp(-6.4*tau + 2*tau^2)"),
    ],
    when: "Not to be used: kept to show what is wrong with it. pid-amigo by the same authors really has \
           sensitivity peak 1.4.",
    limits: "The sensitivity peak is 2.24, not 1.4: the remembered coefficients do not belong to this rule, or \
             not to tau = 1. Td comes out at 0.02 d, which is no derivative action.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory: no source was read",
    status: Status::Wrong(
        "asked for a sensitivity peak of 1.4 it gives 2.24: the coefficients, which are from memory, cannot be \
         right",
    ),
    values: include_str!("../../../tests/rules/pid-kappatau-14.toml"),
    law: by_formula,
};
