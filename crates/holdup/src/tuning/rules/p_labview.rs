//! NI `LabVIEW` PID toolkit, P (0% / some overshoot).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = variant/(K*d)`.
//!
//! # Parameters
//! `variant`, default 0.26: loop gain K Kc d: 0.26 for no overshoot, 0.44 for some (one of 0.26, 0.44).
//!
//! # When
//! Careful P control: no overshoot by default, about 1 % with the other variant.
//!
//! # Limits
//! The default lies well below the gain at which overshoot begins, 0.368/(K d), so it is slow. P control leaves a
//! lasting error under load.
//!
//! # Published values
//! `Kc*K*d` = 0.26; `100*overshoot` = 0; `Kc*K*d` = 0.44 at `variant = 0.44`.
//!
//! # Reference
//! National Instruments (2001), `LabVIEW` PID Control Toolset manual, via O'Dwyer 2009.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "p-labview",
    name: "NI LabVIEW PID toolkit, P (0% / some overshoot)",
    authors: "National Instruments",
    year: 2001,
    citation: "LabVIEW PID Control Toolset manual, via O'Dwyer 2009",
    structure: "P",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "variant",
        Unit::Ratio,
        Default::Number(0.26),
        "loop gain K Kc d: 0.26 for no overshoot, 0.44 for some",
    )
    .range("0.26 | 0.44")],
    formula: &[("Kc", "variant/(K*d)")],
    when: "Careful P control: no overshoot by default, about 1 % with the other variant.",
    limits: "The default lies well below the gain at which overshoot begins, 0.368/(K d), so it is slow. \
             P control leaves a lasting error under load.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/p-labview.toml"),
    law: by_formula,
};
