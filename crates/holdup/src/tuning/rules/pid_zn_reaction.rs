//! Ziegler-Nichols PID from the reaction curve.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1.2/(K*d)`, `Ti = 2*d`, `Td = 0.5*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! As the reference that everybody knows; for load rejection where little robustness is accepted.
//!
//! # Limits
//! Sensitivity peak 3.5, gain margin 1.41, phase margin 31°: a dead time 45 % longer makes the loop unstable. The
//! derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc*K*d` = 1.2; `Ti/d` = 2; `Td/d` = 0.5.
//!
//! # Reference
//! Ziegler, Nichols (1942), Optimum settings for automatic controllers, Trans. ASME 64.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-zn-reaction",
    name: "Ziegler-Nichols PID from the reaction curve",
    authors: "Ziegler, Nichols",
    year: 1942,
    citation: "Optimum settings for automatic controllers, Trans. ASME 64",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.2/(K*d)"), ("Ti", "2*d"), ("Td", "0.5*d")],
    when: "As the reference that everybody knows; for load rejection where little robustness is accepted.",
    limits: "Sensitivity peak 3.5, gain margin 1.41, phase margin 31°: a dead time 45 % longer makes the loop \
             unstable. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github gmxavier/turu, turu.py, commit 14911e3c (a transcription of O'Dwyer's handbook of 2009); \
             MathWorks utTuningStepResponse.m, integrating branch",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-zn-reaction.toml"),
    law: by_formula,
};
