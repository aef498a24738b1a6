//! PI pole placement ignoring dead time (regulator of the I+PI structure).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 2*zeta*w0/K`
//! - `Ti = 2*zeta/w0`
//!
//! # Parameters
//! `zeta`, default 0.707: damping ratio (range > 0, advised 0.5..1); `w0`, default 0.25/d: natural frequency
//! (range > 0, advised <= 0.35/d).
//!
//! # When
//! Slow loops, where the dead time may be ignored.
//!
//! # Limits
//! It ignores the dead time: w0 above 0.35/d is not what was placed. The gain formulas of arXiv:1908.09250
//! were not read again.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Kadam; `MathWorks` pidtune-era tool (2019), S.D. Kadam, An I + PI controller structure for integrating
//! processes with dead-time, arXiv:1908.09250; `MathWorks` utPolePlacement.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-pole-placement-nodelay",
    name: "PI pole placement ignoring dead time (regulator of the I+PI structure)",
    authors: "Kadam; MathWorks pidtune-era tool",
    year: 2019,
    citation: "S.D. Kadam, An I + PI controller structure for integrating processes with dead-time, arXiv:1908.09250; MathWorks utPolePlacement",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[
        Parameter::new("zeta", Unit::Ratio, Default::Number(0.707), "damping ratio")
            .range("> 0")
            .advised("0.5..1")
            .asks(Property::DampingRatio),
        Parameter::new("w0", Unit::RadianPerSecond, Default::Formula("0.25/d"), "natural frequency")
            .range("> 0")
            .advised("<= 0.35/d"),
    ],
    formula: &[("Kc", "2*zeta*w0/K"), ("Ti", "2*zeta/w0")],
    when: "Slow loops, where the dead time may be ignored.",
    limits: "It ignores the dead time: w0 above 0.35/d is not what was placed. The gain formulas of arXiv:1908.09250 were not read again.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "https://ar5iv.labs.arxiv.org/html/1908.09250 (abstract and introduction only); public code on GitHub (MathWorks utTuningStepResponse.m, integrating branch)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-pole-placement-nodelay.toml"),
    law: by_formula,
};
