//! Kappa-tau PID for sensitivity peak 2.0, coefficients from memory.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `tau = 1`, `Kc = 8.6*exp(-7.1*tau + 5.4*tau^2)/(K*d)`, `Ti = d*exp(3.3*tau - 2.33*tau^2)`,
//! `Td = 0.38*d*exp(0.056*tau - 0.6*tau^2)`. tau = d/(d + T) is 1 on an integrator without lag.
//!
//! # Parameters
//! None.
//!
//! # When
//! Not to be used: kept to show what is wrong with it. pid-callender-1 and pid-mrdp really have sensitivity peak
//! 2.0.
//!
//! # Limits
//! The sensitivity peak is 15.6, not 2.0: the remembered coefficients do not belong to this rule, or not to tau =
//! 1. Gain margin 1.09, phase margin 6°.
//!
//! # Published values
//! `sensitivity_peak` = 2.0 — DIFFERENCE, see the values file.
//!
//! # Reference
//! Astrom, Hagglund (1995), PID Controllers: Theory, Design, and Tuning, ISA.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-kappatau-20",
    name: "Kappa-tau PID for sensitivity peak 2.0, coefficients from memory",
    authors: "Astrom, Hagglund",
    year: 1995,
    citation: "PID Controllers: Theory, Design, and Tuning, ISA",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[
        ("tau", "1"),
        ("Kc", "8.6*exp(-7.1*tau + 5.4*tau^2)/(K*d)"),
        ("Ti", "d*exp(3.3*tau - 2.33*tau^2)"),
        ("Td", "0.38*d*exp(0.056*tau - 0.6*tau^2)"),
    ],
    when: "Not to be used: kept to show what is wrong with it. pid-callender-1 and pid-mrdp really have \
           sensitivity peak 2.0.",
    limits: "The sensitivity peak is 15.6, not 2.0: the remembered coefficients do not belong to this rule, or \
             not to tau = 1. Gain margin 1.09, phase margin 6°.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory: no source was read",
    status: Status::Wrong(
        "asked for a sensitivity peak of 2.0 it gives 15.6: the coefficients, which are from memory, cannot be \
         right",
    ),
    values: include_str!("../../../tests/rules/pid-kappatau-20.toml"),
    law: by_formula,
};
