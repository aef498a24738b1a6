//! Sree-Chidambaram PID.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.896/(K*d)`, `Ti = 2.5*d`, `Td = 0.5*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Fast load rejection where robustness may be spent.
//!
//! # Limits
//! Aggressive: a setpoint step overshoots by about half. The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc` = 2.95; `Ti` = 15; `Td` = 3; `load_iae` = 6.526 — DIFFERENCE, see the values file.
//!
//! # Reference
//! Padma Sree, Chidambaram (2006), Control of Unstable Systems, Narosa/Alpha Science (2006), as used in the
//! kadam-2017.tex.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-sree-chidambaram",
    name: "Sree-Chidambaram PID",
    authors: "Padma Sree, Chidambaram",
    year: 2006,
    citation: "Control of Unstable Systems, Narosa/Alpha Science (2006), as used in the kadam-2017.tex",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.896/(K*d)"), ("Ti", "2.5*d"), ("Td", "0.5*d")],
    when: "Fast load rejection where robustness may be spent.",
    limits: "Aggressive: a setpoint step overshoots by about half. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "numbers checked against kadam-2017.tex Table 1; kadam-2017.tex",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-sree-chidambaram.toml"),
    law: by_formula,
};
