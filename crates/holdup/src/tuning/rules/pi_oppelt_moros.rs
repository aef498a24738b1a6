//! Oppelt (Moros 1999) reaction curve, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.8/(K*d)`, `Ti = 3*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Only to compare with.
//!
//! # Limits
//! Gain margin 1.61, phase margin 20 deg, `M_s` 3.63, a setpoint step overshoots by 87 %.
//!
//! # Published values
//! `Kc*K*d` = 0.8; `Ti/d` = 3.0.
//!
//! # Reference
//! Oppelt; Moros (1999), via O'Dwyer 2009.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-oppelt-moros",
    name: "Oppelt (Moros 1999) reaction curve, PI",
    authors: "Oppelt; Moros",
    year: 1999,
    citation: "via O'Dwyer 2009",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.8/(K*d)"), ("Ti", "3*d")],
    when: "Only to compare with.",
    limits: "Gain margin 1.61, phase margin 20 deg, M_s 3.63, a setpoint step overshoots by 87 %.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: turu.py, a transcription of O'Dwyer's handbook",
    status: Status::History("nearly undamped (M_s 3.6), of the Ziegler-Nichols kind"),
    values: include_str!("../../../tests/rules/pi-oppelt-moros.toml"),
    law: by_formula,
};
