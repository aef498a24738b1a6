//! Poulin-Pomerleau ITAE, input step load, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.5327/(K*d)`
//! - `Ti = 3.8853*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Load rejection with a resonance peak of 5 dB.
//!
//! # Limits
//! Nothing beyond what the margins show.
//!
//! # Published values
//! `Kc*K*d` = 0.5327; `Ti/d` = 3.8853; `Mt` = 1.78.
//!
//! # Reference
//! Poulin, Pomerleau (1996), PID tuning for integrating and unstable processes, IEE Proc. Control Theory
//! Appl. 143, 429-435.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-poulin-input",
    name: "Poulin-Pomerleau ITAE, input step load, PI",
    authors: "Poulin, Pomerleau",
    year: 1996,
    citation: "PID tuning for integrating and unstable processes, IEE Proc. Control Theory Appl. 143, 429-435",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.5327/(K*d)"), ("Ti", "3.8853*d")],
    when: "Load rejection with a resonance peak of 5 dB.",
    limits: "Nothing beyond what the margins show.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-poulin-input.toml"),
    law: by_formula,
};
