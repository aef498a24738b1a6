//! Wang-Cluett PID, zeta=1.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1/(K*d*(0.5080*beta + 0.6208))`, `Ti = d*(1.9885*beta + 1.2235)`, `Td = d/(1.0043*beta + 1.8194)`.
//!
//! # Parameters
//! `beta`, default 4.0: closed-loop time constant over dead time (range > 0, advised 1..20).
//!
//! # When
//! A smooth PID whose speed is one number; damping ratio 1.
//!
//! # Limits
//! Checked stable and well behaved for beta from 1 to 20. The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc` = 1.2416; `Ti` = 55.065; `Td` = 1.028; `Kc` = 1.53572; `Ti` = 43.134; `Td` = 1.24164; `load_ise` = 20.41;
//! `load_iae` = 44.2 — DIFFERENCE, see the values file.
//!
//! # Reference
//! Wang, Cluett (1997), Tuning PID controllers for integrating processes, IEE Proc. Control Theory Appl. 144,
//! 385-392.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-wang-cluett-z1",
    name: "Wang-Cluett PID, zeta=1",
    authors: "Wang, Cluett",
    year: 1997,
    citation: "Tuning PID controllers for integrating processes, IEE Proc. Control Theory Appl. 144, 385-392",
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
        ("Kc", "1/(K*d*(0.5080*beta + 0.6208))"),
        ("Ti", "d*(1.9885*beta + 1.2235)"),
        ("Td", "d/(1.0043*beta + 1.8194)"),
    ],
    when: "A smooth PID whose speed is one number; damping ratio 1.",
    limits: "Checked stable and well behaved for beta from 1 to 20. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "numbers checked against kadam-2017.tex Table 1",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-wang-cluett-z1.toml"),
    law: by_formula,
};
