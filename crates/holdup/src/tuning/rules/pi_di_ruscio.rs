//! Di Ruscio prescribed delay margin PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `f = (1 + sqrt(1 + 4/c^2))/2`
//! - `a = atan(c*sqrt(f))/sqrt(f)`
//! - `Kc = a/((delta + 1)*K*d)`
//! - `Ti = (c/a)*(delta + 1)*d`
//!
//! # Parameters
//! `delta`, default 1.6: delay margin over dead time (range > 0); `c`, default 4.0: product K Kc Ti (range >
//! 0, advised 1.5..4).
//!
//! # When
//! PI with a stated delay margin.
//!
//! # Limits
//! The expression of a in c is derived here; the abstract that was read gives the form and says that a is
//! constant in c.
//!
//! # Published values
//! `DM/d` = 1.600000; `Kc*K*Ti` = 2.38.
//!
//! # Reference
//! Di Ruscio (2010), On tuning PI controllers for integrating plus time delay systems, Modeling,
//! Identification and Control 31(4) 145-164.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-di-ruscio",
    name: "Di Ruscio prescribed delay margin PI",
    authors: "Di Ruscio",
    year: 2010,
    citation: "On tuning PI controllers for integrating plus time delay systems, Modeling, Identification and Control 31(4) 145-164",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[
        Parameter::new("delta", Unit::Ratio, Default::Number(1.6), "delay margin over dead time")
            .range("> 0")
            .asks(Property::RelativeDelayMargin),
        Parameter::new("c", Unit::Ratio, Default::Number(4.0), "product K Kc Ti")
            .range("> 0")
            .advised("1.5..4"),
    ],
    formula: &[
        ("f", "(1 + sqrt(1 + 4/c^2))/2"),
        ("a", "atan(c*sqrt(f))/sqrt(f)"),
        ("Kc", "a/((delta + 1)*K*d)"),
        ("Ti", "(c/a)*(delta + 1)*d"),
    ],
    when: "PI with a stated delay margin.",
    limits: "The expression of a in c is derived here; the abstract that was read gives the form and says that a is constant in c.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "retrieved (abstract with formulas): https://www.oalib.com/downloadEndnote/2457412, original http://www.mic-journal.no/PDF/2010/MIC-2010-4-3.pdf; derived here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-di-ruscio.toml"),
    law: by_formula,
};
