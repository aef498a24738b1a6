//! Callender-Hartree-Porter PID, first criterion.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.749/(K*d)`, `Ti = 2.734*d`, `Td = 0.303*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Load rejection with an oscillation that is gone after one period; the oldest rule here, and still a sound one.
//!
//! # Limits
//! From memory: no source was read, but the decay and the period that are remembered with it are reproduced.
//! Sensitivity peak 2.00, gain margin 2.42, phase margin 32°. The derivative is unfiltered in the source.
//!
//! # Published values
//! `decay_ratio` = 0.015; `period_s/d` = 10.5.
//!
//! # Reference
//! Callender, Hartree, Porter (1936), Time-lag in a control system, Phil. Trans. R. Soc. A 235.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-callender-1",
    name: "Callender-Hartree-Porter PID, first criterion",
    authors: "Callender, Hartree, Porter",
    year: 1936,
    citation: "Time-lag in a control system, Phil. Trans. R. Soc. A 235",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.749/(K*d)"), ("Ti", "2.734*d"), ("Td", "0.303*d")],
    when: "Load rejection with an oscillation that is gone after one period; the oldest rule here, and still a \
           sound one.",
    limits: "From memory: no source was read, but the decay and the period that are remembered with it are \
             reproduced. Sensitivity peak 2.00, gain margin 2.42, phase margin 32°. The derivative is \
             unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory: no source was read (O'Dwyer)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-callender-1.toml"),
    law: by_formula,
};
