//! Arbogast-Cooper-Rice PID with filter, load.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.447/(K*d)`
//! - `Ti = 7.528*d`
//! - `Td = 0.189*d`
//! - `Tf = 0.636*Td`
//!
//! # Parameters
//! None.
//!
//! # When
//! Robust PID with a filtered derivative.
//!
//! # Limits
//! Its filter is part of the rule: 0.636 Td, on the derivative only.
//!
//! # Published values
//! `Kc*K*d` = 0.447; `Ti/d` = 7.528; `Td/d` = 0.189.
//!
//! # Reference
//! Arbogast, Cooper, Rice (2007), Model-based tuning methods for PID controllers, BIG (2006/7); Arbogast &
//! Cooper, Extension of IMC tuning correlations for non-self regulating processes, ISA Trans. 46 (2007)
//! 303-311.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-arbogast",
    name: "Arbogast-Cooper-Rice PID with filter, load",
    authors: "Arbogast, Cooper, Rice",
    year: 2007,
    citation: "Model-based tuning methods for PID controllers, BIG (2006/7); Arbogast & Cooper, Extension of IMC tuning correlations for non-self regulating processes, ISA Trans. 46 (2007) 303-311",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.447/(K*d)"), ("Ti", "7.528*d"), ("Td", "0.189*d"), ("Tf", "0.636*Td")],
    when: "Robust PID with a filtered derivative.",
    limits: "Its filter is part of the rule: 0.636 Td, on the derivative only.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-arbogast.toml"),
    law: by_formula,
};
