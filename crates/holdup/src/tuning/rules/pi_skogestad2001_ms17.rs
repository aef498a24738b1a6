//! Skogestad 2001 optimum for Ms=1.7, PI (as transcribed).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.404/(K*d)`, `Ti = 7*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Never: use `pi-maxki-ms` with Ms = 1.7.
//!
//! # Limits
//! The transcription repeats the Ti of its row for 1.4. The optimum for `M_s` 1.7 at this gain is Ti = 4.6 d (4.597
//! d).
//!
//! # Published values
//! `sensitivity_peak` = 1.7 (DIFFERENCE, see the values file).
//!
//! # Reference
//! Skogestad (2001), Probably the best simple PID tuning rules in the world, `AIChE` Annual Meeting, Reno 2001.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-skogestad2001-ms17",
    name: "Skogestad 2001 optimum for Ms=1.7, PI (as transcribed)",
    authors: "Skogestad",
    year: 2001,
    citation: "Probably the best simple PID tuning rules in the world, AIChE Annual Meeting, Reno 2001",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.404/(K*d)"), ("Ti", "7*d")],
    when: "Never: use pi-maxki-ms with Ms = 1.7.",
    limits: "The transcription repeats the Ti of its row for 1.4. The optimum for M_s 1.7 at this gain is \
             Ti = 4.6 d (4.597 d).",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Wrong(
        "with Ti = 7 d as transcribed the sensitivity peak is 1.56, not 1.7; Ti = 4.6 d is right \
             (pi-maxki-ms with Ms = 1.7)",
    ),
    values: include_str!("../../../tests/rules/pi-skogestad2001-ms17.toml"),
    law: by_formula,
};
