//! P, double real dominant pole (critical damping).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = exp(-1)/(K*d)`.
//!
//! # Parameters
//! None.
//!
//! # When
//! The fastest P control whose setpoint step does not overshoot.
//!
//! # Limits
//! At this gain two real poles meet at -1/d, so the smallest rise of the gain makes the loop oscillate (heavily
//! damped). P control leaves a lasting error under load.
//!
//! # Published values
//! `Kc*K*d` = 0.368; `100*overshoot` = 0.
//!
//! # Reference
//! Viteckova; Huba (1999), M. Viteckova, Seeking of PI and PID controllers by desired model method (1999); M. Huba, J.
//! Process Control 23 (2013).

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "p-mrdp",
    name: "P, double real dominant pole (critical damping)",
    authors: "Viteckova; Huba",
    year: 1999,
    citation: "M. Viteckova, Seeking of PI and PID controllers by desired model method (1999); M. Huba, \
               J. Process Control 23 (2013)",
    structure: "P",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "exp(-1)/(K*d)")],
    when: "The fastest P control whose setpoint step does not overshoot.",
    limits: "At this gain two real poles meet at -1/d, so the smallest rise of the gain makes the loop \
             oscillate (heavily damped). P control leaves a lasting error under load.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook; derived again \
             here: Kc K d e^(-s d) + s d has a double zero",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/p-mrdp.toml"),
    law: by_formula,
};
