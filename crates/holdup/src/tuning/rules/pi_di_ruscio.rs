//! Di Ruscio prescribed delay margin PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `f = (1 + sqrt(1 + 4/c^2))/2`, `a = atan(c*sqrt(f))/sqrt(f)`, `Kc = a/((delta + 1)*K*d)`,
//! `Ti = (c/a)*(delta + 1)*d`.
//!
//! # Parameters
//! `delta`, default 1.6: relative delay margin: extra dead time over d.
//! `c`, default 4: product K Kc Ti; smaller is faster and less damped (advised 1.5..4). Not to be mistaken for a
//! setpoint weight.
//!
//! # When
//! The dead time may grow: the relative delay margin delta is met exactly for every c.
//!
//! # Limits
//! Only the delay margin is chosen; c = K Kc Ti sets the damping (4 as SIMC, 2.38 as Ziegler-Nichols). The expression
//! of a is derived here: the abstract that was read says that it depends on c alone.
//!
//! # Published values
//! `Kc*K*Ti` = 2.38 at `c = 2.38`; `delay_margin_s/d` = 1.6; `delay_margin_s/d` = 1.6 at `c = 2.38`;
//! `delay_margin_s/d` = 0.5 at `c = 1.5`, `delta = 0.5`.
//!
//! # Reference
//! Di Ruscio (2010), On tuning PI controllers for integrating plus time delay systems, Modeling, Identification and
//! Control 31(4), 145-164.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-di-ruscio",
    name: "Di Ruscio prescribed delay margin PI",
    authors: "Di Ruscio",
    year: 2010,
    citation: "On tuning PI controllers for integrating plus time delay systems, Modeling, Identification \
               and Control 31(4), 145-164",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[
        Parameter::new(
            "delta",
            Unit::Ratio,
            Default::Number(1.6),
            "relative delay margin: extra dead time over d",
        )
        .asks(Property::RelativeDelayMargin),
        Parameter::new(
            "c",
            Unit::Ratio,
            Default::Number(4.0),
            "product K Kc Ti; smaller is faster and less damped",
        )
        .advised("1.5..4"),
    ],
    formula: &[
        ("f", "(1 + sqrt(1 + 4/c^2))/2"),
        ("a", "atan(c*sqrt(f))/sqrt(f)"),
        ("Kc", "a/((delta + 1)*K*d)"),
        ("Ti", "(c/a)*(delta + 1)*d"),
    ],
    when: "The dead time may grow: the relative delay margin delta is met exactly for every c.",
    limits: "Only the delay margin is chosen; c = K Kc Ti sets the damping (4 as SIMC, 2.38 as \
             Ziegler-Nichols). The expression of a is derived here: the abstract that was read says that \
             it depends on c alone.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "abstract with formulas at oalib.com (MIC 2010-4-3); the expression of a derived here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-di-ruscio.toml"),
    law: by_formula,
};
