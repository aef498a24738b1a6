//! Ali-Majhi PID (ISE with Nyquist slope constraint).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1.03/(K*d)`, `Ti = 3.17*d`, `Td = 0.49*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Fast load rejection where robustness may be spent.
//!
//! # Limits
//! Aggressive: a setpoint step overshoots by about 70 %. The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc` = 3.39; `Ti` = 19.02; `Td` = 2.94.
//!
//! # Reference
//! Ali, Majhi (2010), PID controller tuning for integrating processes, ISA Transactions 49, 70-78.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-ali-majhi",
    name: "Ali-Majhi PID (ISE with Nyquist slope constraint)",
    authors: "Ali, Majhi",
    year: 2010,
    citation: "PID controller tuning for integrating processes, ISA Transactions 49, 70-78",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.03/(K*d)"), ("Ti", "3.17*d"), ("Td", "0.49*d")],
    when: "Fast load rejection where robustness may be spent.",
    limits: "Aggressive: a setpoint step overshoots by about 70 %. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "numbers checked against kadam-2017.tex Table 1; kadam-2017.tex",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-ali-majhi.toml"),
    law: by_formula,
};
