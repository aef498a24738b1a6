//! Wang-Cluett PID, zeta=0.707.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1/(K*d*(0.7138*beta + 0.3904))`, `Ti = d*(1.4020*beta + 1.2076)`, `Td = d/(1.4167*beta + 1.6999)`.
//!
//! # Parameters
//! `beta`, default 4.0: closed-loop time constant over dead time (range > 0, advised 1..20).
//!
//! # When
//! A smooth PID whose speed is one number; damping ratio 0.707.
//!
//! # Limits
//! Checked stable for beta from 1 to 20. The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc*K*d*(0.7138*beta + 0.3904)` = 1.0000; `damping_ratio` = 0.707 — DIFFERENCE, see
//! the values file.
//!
//! # Reference
//! Wang, Cluett (1997), IEE Proc. Control Theory Appl. 144, 385-392.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-wang-cluett-z0707",
    name: "Wang-Cluett PID, zeta=0.707",
    authors: "Wang, Cluett",
    year: 1997,
    citation: "IEE Proc. Control Theory Appl. 144, 385-392",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "beta",
        Unit::Ratio,
        Default::Number(4.0),
        "closed-loop time constant over dead time",
    )
    .range("> 0")
    .advised("1..20")],
    formula: &[
        ("Kc", "1/(K*d*(0.7138*beta + 0.3904))"),
        ("Ti", "d*(1.4020*beta + 1.2076)"),
        ("Td", "d/(1.4167*beta + 1.6999)"),
    ],
    when: "A smooth PID whose speed is one number; damping ratio 0.707.",
    limits: "Checked stable for beta from 1 to 20. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "numbers checked against kadam-2017.tex Table 1",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-wang-cluett-z0707.toml"),
    law: by_formula,
};
