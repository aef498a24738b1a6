//! Chien-Hrones-Reswick, P, 0% overshoot, slope form.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.3/(K*d)`.
//!
//! # Parameters
//! None.
//!
//! # When
//! P control that must not overshoot and has robustness to spare.
//!
//! # Limits
//! Slower than needed: 0.368/(K d) does not overshoot either (`p-mrdp`). The paper is about processes with a lag; this
//! is its limit for a pure slope. P control leaves a lasting error under load.
//!
//! # Published values
//! `Kc*K*d` = 0.3; `100*overshoot` = 0.
//!
//! # Reference
//! Chien, Hrones, Reswick (1952), On the automatic control of generalized passive systems, Trans. ASME 74, 175-185.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "p-chr-servo0",
    name: "Chien-Hrones-Reswick, P, 0% overshoot, slope form",
    authors: "Chien, Hrones, Reswick",
    year: 1952,
    citation: "On the automatic control of generalized passive systems, Trans. ASME 74, 175-185",
    structure: "P",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.3/(K*d)")],
    when: "P control that must not overshoot and has robustness to spare.",
    limits: "Slower than needed: 0.368/(K d) does not overshoot either (p-mrdp). The paper is about \
             processes with a lag; this is its limit for a pure slope. P control leaves a lasting error \
             under load.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: utTuningStepResponse.m of MathWorks, integrating branch",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/p-chr-servo0.toml"),
    law: by_formula,
};
