//! Poulin-Pomerleau ITAE, output step load, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.5264/(K*d)`, `Ti = 4.5804*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Steps at the process output, which is to say setpoint steps, and still brisk under load.
//!
//! # Limits
//! `M_s` 1.93, phase margin 37 deg, a setpoint step overshoots by 45 %. Read in a transcription, not in the paper.
//!
//! # Published values
//! `Kc*K*d` = 0.5264; `Ti/d` = 4.5804.
//!
//! # Reference
//! Poulin, Pomerleau (1996), IEE Proc. Control Theory Appl. 143, 429-435.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-poulin-output",
    name: "Poulin-Pomerleau ITAE, output step load, PI",
    authors: "Poulin, Pomerleau",
    year: 1996,
    citation: "IEE Proc. Control Theory Appl. 143, 429-435",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.5264/(K*d)"), ("Ti", "4.5804*d")],
    when: "Steps at the process output, which is to say setpoint steps, and still brisk under load.",
    limits: "M_s 1.93, phase margin 37 deg, a setpoint step overshoots by 45 %. Read in a transcription, \
             not in the paper.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-poulin-output.toml"),
    law: by_formula,
};
