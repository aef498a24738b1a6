//! Poulin-Pomerleau ITAE, output step load, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.5264/(K*d)`
//! - `Ti = 4.5804*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Rejection of steps at the output, and setpoint steps.
//!
//! # Limits
//! Nothing beyond what the margins show.
//!
//! # Published values
//! `Kc*K*d` = 0.5264; `Ti/d` = 4.5804.
//!
//! # Reference
//! Poulin, Pomerleau (1996), IEE Proc. Control Theory Appl. 143.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-poulin-output",
    name: "Poulin-Pomerleau ITAE, output step load, PI",
    authors: "Poulin, Pomerleau",
    year: 1996,
    citation: "IEE Proc. Control Theory Appl. 143",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.5264/(K*d)"), ("Ti", "4.5804*d")],
    when: "Rejection of steps at the output, and setpoint steps.",
    limits: "Nothing beyond what the margins show.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-poulin-output.toml"),
    law: by_formula,
};
