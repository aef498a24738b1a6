//! Wolfe 1951, PI, decay ratio 0.4.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.6/(K*d)`
//! - `Ti = 2.78*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field.
//!
//! # Limits
//! Its stated decay ratio 0.4 does not come out: it is 0.08.
//!
//! # Published values
//! `Kc*K*d` = 0.6; `Ti/d` = 2.78.
//!
//! # Reference
//! Wolfe (1951), W.A. Wolfe, Controller settings for optimum control, Trans. ASME 73, 413-418.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-wolfe-1",
    name: "Wolfe 1951, PI, decay ratio 0.4",
    authors: "Wolfe",
    year: 1951,
    citation: "W.A. Wolfe, Controller settings for optimum control, Trans. ASME 73, 413-418",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.6/(K*d)"), ("Ti", "2.78*d")],
    when: "As history of the field.",
    limits: "Its stated decay ratio 0.4 does not come out: it is 0.08.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::History(
        "its stated decay ratio 0.4 does not come out of the transcribed settings: it is 0.08",
    ),
    values: include_str!("../../../tests/rules/pi-wolfe-1.toml"),
    law: by_formula,
};
