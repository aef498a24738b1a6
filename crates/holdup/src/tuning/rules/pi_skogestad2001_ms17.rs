//! Skogestad 2001 optimum for Ms=1.7, PI (as transcribed).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.404/(K*d)`
//! - `Ti = 7*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Never: use pi-maxki-ms with Ms = 1.7.
//!
//! # Limits
//! As transcribed its integral time is 7 d; the optimum with the sensitivity peak 1.7 has 4.597 d.
//!
//! # Published values
//! `Ms` = 1.7.
//!
//! # Reference
//! Skogestad (2001), Probably the best simple PID tuning rules in the world, `AIChE` Annual Meeting, Reno
//! 2001 (row as in O'Dwyer).

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-skogestad2001-ms17",
    name: "Skogestad 2001 optimum for Ms=1.7, PI (as transcribed)",
    authors: "Skogestad",
    year: 2001,
    citation: "Probably the best simple PID tuning rules in the world, AIChE Annual Meeting, Reno 2001 (row as in O'Dwyer)",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.404/(K*d)"), ("Ti", "7*d")],
    when: "Never: use pi-maxki-ms with Ms = 1.7.",
    limits: "As transcribed its integral time is 7 d; the optimum with the sensitivity peak 1.7 has 4.597 d.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Wrong(
        "the transcription prints Ti = 7 d; the optimum at sensitivity peak 1.7 has Ti = 4.597 d (pi-maxki-ms)",
    ),
    values: include_str!("../../../tests/rules/pi-skogestad2001-ms17.toml"),
    law: by_formula,
};
