//! Improved SIMC PID on IPDT (series, Td=d/3).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1/(K*(tau_c + d))`
//! - `Ti = 4*(tau_c + d)`
//! - `Td = d/3`
//!
//! # Parameters
//! `tau_c` [s], default d/2: closed-loop time constant (range > 0, advised >= d/2).
//!
//! # When
//! SIMC with derivative action against the dead time, for a series controller.
//!
//! # Limits
//! The derivative is unfiltered in the source. `tau_c` below d/2 is less robust than the authors recommend.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Grimholt, Skogestad (2018), Optimal PI and PID control of first-order plus delay processes and evaluation
//! of the original and improved SIMC rules, J. Process Control 70, 36-46.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-isimc",
    name: "Improved SIMC PID on IPDT (series, Td=d/3)",
    authors: "Grimholt, Skogestad",
    year: 2018,
    citation: "Optimal PI and PID control of first-order plus delay processes and evaluation of the original and improved SIMC rules, J. Process Control 70, 36-46",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Series,
    parameters: &[Parameter::new(
        "tau_c",
        Unit::Second,
        Default::Formula("d/2"),
        "closed-loop time constant",
    )
    .range("> 0")
    .advised(">= d/2")
    .asks(Property::ClosedLoopTimeConstant)],
    formula: &[("Kc", "1/(K*(tau_c + d))"), ("Ti", "4*(tau_c + d)"), ("Td", "d/3")],
    when: "SIMC with derivative action against the dead time, for a series controller.",
    limits: "The derivative is unfiltered in the source. tau_c below d/2 is less robust than the authors recommend.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (pidtools 'Metody', sections SIMC, iSIMC, Lambda/IMC, averaging level)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-isimc.toml"),
    law: by_formula,
};
