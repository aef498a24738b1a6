//! PD with prescribed delay margin, double integrator.
//!
//! # Applies to
//! The double integrator with dead time.
//!
//! # Formula
//! - `f = (1 + sqrt(1 + 4/c^2))/2`
//! - `a = atan(c*sqrt(f))/sqrt(f)`
//! - `Td = (c/a)*(delta + 1)*d`
//! - `Kc = a/((delta + 1)*d)/(K*Td)`
//!
//! # Parameters
//! `delta`, default 1.6: delay margin over dead time (range > 0); `c`, default 4.0: product of the PI rule it
//! comes from (range > 0, advised 1.5..4).
//!
//! # When
//! PD with a stated delay margin.
//!
//! # Limits
//! Derived here; the paper's title only was read.
//!
//! # Published values
//! `DM/d` = 1.600000.
//!
//! # Reference
//! Dalen, Di Ruscio (2017), Tuning PD and PID controllers for double integrating plus time delay systems, MIC
//! 38(2).

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "dipdt-pd-dalen-di-ruscio",
    name: "PD with prescribed delay margin, double integrator",
    authors: "Dalen, Di Ruscio",
    year: 2017,
    citation: "Tuning PD and PID controllers for double integrating plus time delay systems, MIC 38(2)",
    structure: "PD",
    process: Applies::DoubleIntegrating,
    form: Form::Ideal,
    parameters: &[
        Parameter::new("delta", Unit::Ratio, Default::Number(1.6), "delay margin over dead time")
            .range("> 0")
            .asks(Property::RelativeDelayMargin),
        Parameter::new("c", Unit::Ratio, Default::Number(4.0), "product of the PI rule it comes from")
            .range("> 0")
            .advised("1.5..4"),
    ],
    formula: &[
        ("f", "(1 + sqrt(1 + 4/c^2))/2"),
        ("a", "atan(c*sqrt(f))/sqrt(f)"),
        ("Td", "(c/a)*(delta + 1)*d"),
        ("Kc", "a/((delta + 1)*d)/(K*Td)"),
    ],
    when: "PD with a stated delay margin.",
    limits: "Derived here; the paper's title only was read.",
    validity: &[],
    provenance: Provenance::Derived,
    source: "derived here; title https://sciencedocbox.com/amp/73763630-Physics/Tuning-pd-and-pid-controllers-for-double-integrating-plus-time-delay-systems.html (paper parameterisation not retrieved)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/dipdt-pd-dalen-di-ruscio.toml"),
    law: by_formula,
};
