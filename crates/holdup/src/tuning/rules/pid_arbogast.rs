//! Arbogast-Cooper-Rice PID with derivative filter, load.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.447/(K*d)`, `Ti = 7.528*d`, `Td = 0.189*d`, `Tf = 0.636*Td`. The filter acts on the derivative action
//! only.
//!
//! # Parameters
//! None.
//!
//! # When
//! A smooth, robust PID with a filtered derivative: level and inventory loops with noise.
//!
//! # Limits
//! Slow to remove a load: close to a PI. Sensitivity peak 1.47, gain margin 3.67, phase margin 52°. From a
//! secondary transcription.
//!
//! # Published values
//! `Kc*K*d` = 0.447; `Ti/d` = 7.528; `Td/d` = 0.189; `Tf/Td` = 0.636.
//!
//! # Reference
//! Arbogast, Cooper, Rice (2007), Model-based tuning methods for PID controllers; Arbogast, Cooper, Extension of
//! IMC tuning correlations for non-self regulating (integrating) processes, ISA Trans. 46, 303-311.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-arbogast",
    name: "Arbogast-Cooper-Rice PID with derivative filter, load",
    authors: "Arbogast, Cooper, Rice",
    year: 2007,
    citation: "Model-based tuning methods for PID controllers; Arbogast, Cooper, Extension of IMC tuning \
               correlations for non-self regulating (integrating) processes, ISA Trans. 46, 303-311",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.447/(K*d)"), ("Ti", "7.528*d"), ("Td", "0.189*d"), ("Tf", "0.636*Td")],
    when: "A smooth, robust PID with a filtered derivative: level and inventory loops with noise.",
    limits: "Slow to remove a load: close to a PI. Sensitivity peak 1.47, gain margin 3.67, phase margin 52°. \
             From a secondary transcription.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner, a C# transcription of O'Dwyer's tables, \
             Methods/TunningMethods/IPDModelTunningMethods, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-arbogast.toml"),
    law: by_formula,
};
