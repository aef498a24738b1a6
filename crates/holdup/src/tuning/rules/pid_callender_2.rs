//! Callender-Hartree-Porter PID, second criterion.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1.066/(K*d)`, `Ti = 1.418*d`, `Td = 0.47*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Not to be used: kept to show what is wrong with it. Take pid-callender-1, whose stated behaviour is reproduced.
//!
//! # Limits
//! Integral action is far too fast: phase margin 20°, sensitivity peak 2.93, dominant damping 0.28; an oscillation
//! keeps 16 % of its height each period of 6.6 d. The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc*K*d` = 1.066; `Ti/d` = 1.418; `Td/d` = 0.47.
//!
//! # Reference
//! Callender, Hartree, Porter (1936), Time-lag in a control system, Phil. Trans. R. Soc. A 235.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-callender-2",
    name: "Callender-Hartree-Porter PID, second criterion",
    authors: "Callender, Hartree, Porter",
    year: 1936,
    citation: "Time-lag in a control system, Phil. Trans. R. Soc. A 235",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.066/(K*d)"), ("Ti", "1.418*d"), ("Td", "0.47*d")],
    when: "Not to be used: kept to show what is wrong with it. Take pid-callender-1, whose stated behaviour is \
           reproduced.",
    limits: "Integral action is far too fast: phase margin 20°, sensitivity peak 2.93, dominant damping 0.28; \
             an oscillation keeps 16 % of its height each period of 6.6 d. The derivative is unfiltered in the \
             source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github gmxavier/turu, turu.py, commit 14911e3c (a transcription of O'Dwyer's handbook of 2009)",
    status: Status::Wrong(
        "its integral time of 1.418 d leaves a phase margin of 20° and a dominant damping of 0.28, which \
         contradicts the behaviour its source states",
    ),
    values: include_str!("../../../tests/rules/pid-callender-2.toml"),
    law: by_formula,
};
