//! Chien-Hrones-Reswick PID, load, 20 % overshoot.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1.2/(K*d)`, `Ti = 2*d`, `Td = 0.42*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Fast load rejection where little robustness is accepted.
//!
//! # Limits
//! The 20 % of its name are those of self-regulating processes. Sensitivity peak 3.18, gain margin 1.49, phase
//! margin 26°: a dead time 38 % longer makes the loop unstable. The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc*K*d` = 1.2; `Ti/d` = 2; `Td/d` = 0.42.
//!
//! # Reference
//! Chien, Hrones, Reswick (1952), On the automatic control of generalized passive systems, Trans. ASME 74.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-chr-reg20",
    name: "Chien-Hrones-Reswick PID, load, 20 % overshoot",
    authors: "Chien, Hrones, Reswick",
    year: 1952,
    citation: "On the automatic control of generalized passive systems, Trans. ASME 74",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.2/(K*d)"), ("Ti", "2*d"), ("Td", "0.42*d")],
    when: "Fast load rejection where little robustness is accepted.",
    limits: "The 20 % of its name are those of self-regulating processes. Sensitivity peak 3.18, gain margin \
             1.49, phase margin 26°: a dead time 38 % longer makes the loop unstable. The derivative is \
             unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github gmxavier/turu, turu.py, commit 14911e3c (a transcription of O'Dwyer's handbook of 2009), \
             there named moros_oppelt",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-chr-reg20.toml"),
    law: by_formula,
};
