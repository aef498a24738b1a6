//! Skogestad 2001 optimum for Ms=2.0, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.49/(K*d)`
//! - `Ti = 3.77*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Fast PI with the sensitivity peak 2.
//!
//! # Limits
//! Nothing beyond what the margins show.
//!
//! # Published values
//! `Ms` = 2.0.
//!
//! # Reference
//! Skogestad (2001), Probably the best simple PID tuning rules in the world, `AIChE` Annual Meeting, Reno
//! 2001 (row as in O'Dwyer).

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-skogestad2001-ms20",
    name: "Skogestad 2001 optimum for Ms=2.0, PI",
    authors: "Skogestad",
    year: 2001,
    citation: "Probably the best simple PID tuning rules in the world, AIChE Annual Meeting, Reno 2001 (row as in O'Dwyer)",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.49/(K*d)"), ("Ti", "3.77*d")],
    when: "Fast PI with the sensitivity peak 2.",
    limits: "Nothing beyond what the margins show.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-skogestad2001-ms20.toml"),
    law: by_formula,
};
