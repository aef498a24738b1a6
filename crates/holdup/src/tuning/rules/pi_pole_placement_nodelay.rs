//! PI pole placement ignoring dead time (regulator of the I+PI structure).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 2*zeta*w0/K`, `Ti = 2*zeta/w0`.
//!
//! # Parameters
//! `zeta`, default 0.707: damping ratio of the loop without dead time (advised 0.5..1).
//! `w0` [rad/s], default 0.25/d: natural frequency of the loop without dead time (advised <= 0.35/d).
//!
//! # When
//! A slow loop with a stated natural frequency and damping: w0 well below 1/d.
//!
//! # Limits
//! The dead time is ignored, so the damping is not the one asked for unless w0 is far below 0.25/d. At the default
//! `M_s` is 1.54 and a setpoint step overshoots by 34 %; at 0.35/d `M_s` is 1.95. The gains of the paper were not
//! read; the formula is that of the toolbox.
//!
//! # Published values
//! None: no number was retrieved.
//!
//! # Reference
//! Kadam; `MathWorks` pidtune-era tool (2019), S. D. Kadam, An I + PI controller structure for integrating processes
//! with dead-time, arXiv 1908.09250; `MathWorks` `utPolePlacement`.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-pole-placement-nodelay",
    name: "PI pole placement ignoring dead time (regulator of the I+PI structure)",
    authors: "Kadam; MathWorks pidtune-era tool",
    year: 2019,
    citation: "S. D. Kadam, An I + PI controller structure for integrating processes with dead-time, \
               arXiv 1908.09250; MathWorks utPolePlacement",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[
        Parameter::new(
            "zeta",
            Unit::Ratio,
            Default::Number(0.707),
            "damping ratio of the loop without dead time",
        )
        .advised("0.5..1")
        .asks(Property::DampingRatio),
        Parameter::new(
            "w0",
            Unit::RadianPerSecond,
            Default::Formula("0.25/d"),
            "natural frequency of the loop without dead time",
        )
        .advised("<= 0.35/d"),
    ],
    formula: &[("Kc", "2*zeta*w0/K"), ("Ti", "2*zeta/w0")],
    when: "A slow loop with a stated natural frequency and damping: w0 well below 1/d.",
    limits: "The dead time is ignored, so the damping is not the one asked for unless w0 is far below \
             0.25/d. At the default M_s is 1.54 and a setpoint step overshoots by 34 %; at 0.35/d M_s is \
             1.95. The gains of the paper were not read; the formula is that of the toolbox.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "abstract and introduction of arXiv 1908.09250; formula of public code on GitHub: \
             utTuningStepResponse.m of MathWorks, integrating branch",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-pole-placement-nodelay.toml"),
    law: by_formula,
};
