//! Hazebroek-van der Waerden min-ISE, PI (as transcribed).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1.5/(K*d)`
//! - `Ti = 5.56*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Never.
//!
//! # Limits
//! As transcribed the loop is unstable.
//!
//! # Published values
//! `Kc*K*d` = 1.5; `Ti/d` = 5.56.
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
    when: "Never.",
    limits: "As transcribed the loop is unstable.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Wrong("as transcribed the loop is unstable: two poles in the right half plane"),
    values: include_str!("../../../tests/rules/pi-hazebroek.toml"),
    law: by_formula,
};
