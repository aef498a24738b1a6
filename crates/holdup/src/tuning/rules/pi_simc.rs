//! SIMC, PI: Skogestad's closed-loop time constant `tau_c`.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1/(K*(tau_c + d))`, `Ti = 4*(tau_c + d)`
//!
//! # Parameters
//! `tau_c` [s], default d: closed-loop time constant; larger is smoother.
//!
//! # When
//! The everyday choice for level and other integrating loops.
//!
//! # Limits
//! `tau_c` below d is less robust than the author recommends. One commercial toolbox prints the integrating
//! case with wrong dimensions (`1/2/K/L/L`).
//!
//! # Published values
//! Gain margin 2.96, phase margin 46.9°, `M_s` 1.70, `M_t` 1.3, delay margin 1.59 d at the default.
//!
//! # Reference
//! S. Skogestad, Simple analytic rules for model reduction and PID controller tuning, J. Process Control 13
//! (2003) 291–309.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-simc",
    name: "SIMC, PI for integrating",
    authors: "Skogestad",
    year: 2003,
    citation: "Simple analytic rules for model reduction and PID controller tuning, J. Process Control 13, 291-309",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new("tau_c", Unit::Second, Default::Formula("d"), "closed-loop time constant")
        .advised(">= d")
        .asks(Property::ClosedLoopTimeConstant)],
    formula: &[("Kc", "1/(K*(tau_c + d))"), ("Ti", "4*(tau_c + d)")],
    when: "The everyday choice for level and other integrating loops.",
    limits: "tau_c below d is less robust than the author recommends. One commercial toolbox prints the integrating \
             case with wrong dimensions (1/2/K/L/L).",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (pidtools \"Metody\", section on integrating processes)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-simc.toml"),
    law: by_formula,
};
