//! Poulin-Pomerleau ultimate cycle PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.34*pi/(2*K*d)`
//! - `Ti = 1.04*4*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Load rejection, from an ultimate-cycle test.
//!
//! # Limits
//! From memory, no source was read.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Poulin, Pomerleau (1999), PI settings for integrating processes based on ultimate cycle information, IEEE
//! Trans. CST 7(4).

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-poulin-1999",
    name: "Poulin-Pomerleau ultimate cycle PI",
    authors: "Poulin, Pomerleau",
    year: 1999,
    citation: "PI settings for integrating processes based on ultimate cycle information, IEEE Trans. CST 7(4)",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.34*pi/(2*K*d)"), ("Ti", "1.04*4*d")],
    when: "Load rejection, from an ultimate-cycle test.",
    limits: "From memory, no source was read.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-poulin-1999.toml"),
    law: by_formula,
};
