//! Chien-Hrones-Reswick PID, load, no overshoot.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.95/(K*d)`, `Ti = 2.38*d`, `Td = 0.42*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Load rejection with moderate robustness; the milder of the two CHR rules for loads.
//!
//! # Limits
//! The 0 % of its name holds for self-regulating processes: here the response to a load crosses over (IAE 3.20 K
//! d^2, integral of the error 2.51 K d^2). Sensitivity peak 2.23, gain margin 1.87, phase margin 33°. The original
//! table prints Ti = 2.4 d: the rule here is that of the transcription read, 2.38 d. The derivative is unfiltered
//! in the source.
//!
//! # Published values
//! `Kc*K*d` = 0.95; `Ti/d` = 2.38; `Td/d` = 0.42.
//!
//! # Reference
//! Chien, Hrones, Reswick (1952), On the automatic control of generalized passive systems, Trans. ASME 74.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-chr-reg0",
    name: "Chien-Hrones-Reswick PID, load, no overshoot",
    authors: "Chien, Hrones, Reswick",
    year: 1952,
    citation: "On the automatic control of generalized passive systems, Trans. ASME 74",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.95/(K*d)"), ("Ti", "2.38*d"), ("Td", "0.42*d")],
    when: "Load rejection with moderate robustness; the milder of the two CHR rules for loads.",
    limits: "The 0 % of its name holds for self-regulating processes: here the response to a load crosses over \
             (IAE 3.20 K d^2, integral of the error 2.51 K d^2). Sensitivity peak 2.23, gain margin 1.87, \
             phase margin 33°. The original table prints Ti = 2.4 d: the rule here is that of the \
             transcription read, 2.38 d. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "MathWorks utTuningStepResponse.m, integrating branch (public code on GitHub)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-chr-reg0.toml"),
    law: by_formula,
};
