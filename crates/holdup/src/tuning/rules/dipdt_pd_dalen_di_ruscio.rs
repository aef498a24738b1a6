//! PD with prescribed delay margin for the double integrator.
//!
//! # Applies to
//! The double integrator with dead time, `K·e^(−d·s)/s²`.
//!
//! # Formula
//! `f = (1 + sqrt(1 + 4/c^2))/2`, `a = atan(c*sqrt(f))/sqrt(f)`, `Td = c/a*(delta + 1)*d`,
//! `Kc = a/((delta + 1)*d)/(K*Td)`. With `c = K*Kc*Td^2` the gain crossover is `c*sqrt(f)/Td` and its phase margin
//! `atan(c*sqrt(f))` less the dead time: the formula sets the delay margin to `delta*d` exactly.
//!
//! # Parameters
//! `delta`, default 1.6: delay margin over dead time.
//! `c`, default 4: K·Kc·Td², the shape of the loop, advised from 1.5 to 4.
//!
//! # When
//! A double integrator whose dead time is uncertain: says how much more dead time it must bear.
//!
//! # Limits
//! A load D at the process input leaves a lasting error of D/Kc. The parameters are derived here: those of the
//! paper did not come here, only its title and its property. Sensitivity peak 1.70 at the defaults, gain margin
//! 2.98, phase margin 47°. The derivative is unfiltered.
//!
//! # Published values
//! `delay_margin_s/d` = 1.600 (default); `delay_margin_s/d` = 1.000 (delta = 1, c = 1.5, K = 0.3, d = 2);
//! `K*Kc*Td^2` = 4.000.
//!
//! # Reference
//! Dalen, Di Ruscio (2017), Tuning PD and PID controllers for double integrating plus time delay systems, Modeling,
//! Identification and Control 38(2).

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "dipdt-pd-dalen-di-ruscio",
    name: "PD with prescribed delay margin for the double integrator",
    authors: "Dalen, Di Ruscio",
    year: 2017,
    citation: "Tuning PD and PID controllers for double integrating plus time delay systems, Modeling, \
               Identification and Control 38(2)",
    structure: "PD",
    process: Applies::DoubleIntegrating,
    form: Form::Ideal,
    parameters: &[
        Parameter::new("delta", Unit::Ratio, Default::Number(1.6), "delay margin over dead time")
            .asks(Property::RelativeDelayMargin),
        Parameter::new("c", Unit::Ratio, Default::Number(4.0), "shape of the loop, K*Kc*Td^2")
            .advised("1.5..4"),
    ],
    formula: &[
        ("f", "(1 + sqrt(1 + 4/c^2))/2"),
        ("a", "atan(c*sqrt(f))/sqrt(f)"),
        ("Td", "c/a*(delta + 1)*d"),
        ("Kc", "a/((delta + 1)*d)/(K*Td)"),
    ],
    when: "A double integrator whose dead time is uncertain: says how much more dead time it must bear.",
    limits: "A load D at the process input leaves a lasting error of D/Kc. The parameters are derived here: \
             those of the paper did not come here, only its title and its property. Sensitivity peak 1.70 at \
             the defaults, gain margin 2.98, phase margin 47°. The derivative is unfiltered.",
    validity: &[],
    provenance: Provenance::Derived,
    source: "derived here; title from \
             https://sciencedocbox.com/amp/73763630-Physics/Tuning-pd-and-pid-controllers-for-double-integrating-plus-time-delay-systems.html",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/dipdt-pd-dalen-di-ruscio.toml"),
    law: by_formula,
};
