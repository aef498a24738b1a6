//! Hazebroek-van der Waerden min-ISE, PI (as transcribed).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1.5/(K*d)`, `Ti = 5.56*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Never: the loop is unstable.
//!
//! # Limits
//! P control alone is unstable from Kc = 1.571/(K d) on, and integral action needs more distance: these settings have
//! a gain margin of 0.957.
//!
//! # Published values
//! `Kc*K*d` = 1.5; `Ti/d` = 5.56; `unstable_poles` = 0 (DIFFERENCE, see the values file).
//!
//! # Reference
//! Hazebroek, van der Waerden (1950), Trans. ASME 72, 309-322.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-hazebroek",
    name: "Hazebroek-van der Waerden min-ISE, PI (as transcribed)",
    authors: "Hazebroek, van der Waerden",
    year: 1950,
    citation: "Trans. ASME 72, 309-322",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.5/(K*d)"), ("Ti", "5.56*d")],
    when: "Never: the loop is unstable.",
    limits: "P control alone is unstable from Kc = 1.571/(K d) on, and integral action needs more \
             distance: these settings have a gain margin of 0.957.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Wrong("the loop is unstable: the gain is 4 % above the stability limit"),
    values: include_str!("../../../tests/rules/pi-hazebroek.toml"),
    law: by_formula,
};
