//! Shinskey PI for lag + integrator.
//!
//! # Applies to
//! The integrator with lag T and dead time.
//!
//! # Formula
//! - `Kc = 0.556/(K*(T + d))`
//! - `Ti = 3.7*(T + d)`
//!
//! # Parameters
//! None.
//!
//! # When
//! PI where the lag is about as long as the dead time.
//!
//! # Limits
//! Nothing beyond what the margins show.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Shinskey (1994), Feedback Controllers for the Process Industries, via O'Dwyer.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pi-shinskey",
    name: "Shinskey PI for lag + integrator",
    authors: "Shinskey",
    year: 1994,
    citation: "Feedback Controllers for the Process Industries, via O'Dwyer",
    structure: "PI",
    process: Applies::IntegratingWithLag,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.556/(K*(T + d))"), ("Ti", "3.7*(T + d)")],
    when: "PI where the lag is about as long as the dead time.",
    limits: "Nothing beyond what the margins show.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner, Methods/TunningMethods/FOLIPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pi-shinskey.toml"),
    law: by_formula,
};
