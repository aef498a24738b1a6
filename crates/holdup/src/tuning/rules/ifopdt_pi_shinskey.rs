//! Shinskey PI for an integrator with lag.
//!
//! # Applies to
//! The integrator with lag T and dead time, `K·e^(−d·s)/(s·(T·s + 1))`.
//!
//! # Formula
//! `Kc = 0.556/(K*(T + d))`, `Ti = 3.7*(T + d)`.
//!
//! # Parameters
//! None.
//!
//! # When
//! An integrator with lag where derivative action is not wanted; fast against loads.
//!
//! # Limits
//! The lag is counted as dead time: slow where T is much longer than d. Sensitivity peak 2.15, 2.03, 1.85 and phase
//! margin 31°, 32°, 34° at T = 0.2 d, d, 5 d.
//!
//! # Published values
//! No published value came with the transcription.
//!
//! # Reference
//! Shinskey (1994), Feedback Controllers for the Process Industries, by way of O'Dwyer.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pi-shinskey",
    name: "Shinskey PI for an integrator with lag",
    authors: "Shinskey",
    year: 1994,
    citation: "Feedback Controllers for the Process Industries, by way of O'Dwyer",
    structure: "PI",
    process: Applies::IntegratingWithLag,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.556/(K*(T + d))"), ("Ti", "3.7*(T + d)")],
    when: "An integrator with lag where derivative action is not wanted; fast against loads.",
    limits: "The lag is counted as dead time: slow where T is much longer than d. Sensitivity peak 2.15, 2.03, \
             1.85 and phase margin 31°, 32°, 34° at T = 0.2 d, d, 5 d.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner, a C# transcription of O'Dwyer's tables, \
             Methods/TunningMethods/FOLIPDModelTunningMethods, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pi-shinskey.toml"),
    law: by_formula,
};
