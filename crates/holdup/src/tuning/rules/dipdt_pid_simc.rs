//! SIMC PID double integrator (series).
//!
//! # Applies to
//! The double integrator with dead time.
//!
//! # Formula
//! - `Kc = 1/(4*K*(tau_c + d)^2)`
//! - `Ti = 4*(tau_c + d)`
//! - `Td = 4*(tau_c + d)`
//!
//! # Parameters
//! `tau_c` [s], default d: closed-loop time constant (range > 0, advised >= d).
//!
//! # When
//! The everyday choice for a double integrator, for a series controller.
//!
//! # Limits
//! The derivative is unfiltered in the source. The loop is conditionally stable: it has a lower gain margin.
//!
//! # Published values
//! `Ms` = 1.96.
//!
//! # Reference
//! Skogestad (2003), J. Process Control 13, 291-309.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "dipdt-pid-simc",
    name: "SIMC PID double integrator (series)",
    authors: "Skogestad",
    year: 2003,
    citation: "J. Process Control 13, 291-309",
    structure: "PID",
    process: Applies::DoubleIntegrating,
    form: Form::Series,
    parameters: &[Parameter::new("tau_c", Unit::Second, Default::Formula("d"), "closed-loop time constant")
        .range("> 0")
        .advised(">= d")
        .asks(Property::ClosedLoopTimeConstant)],
    formula: &[("Kc", "1/(4*K*(tau_c + d)^2)"), ("Ti", "4*(tau_c + d)"), ("Td", "4*(tau_c + d)")],
    when: "The everyday choice for a double integrator, for a series controller.",
    limits: "The derivative is unfiltered in the source. The loop is conditionally stable: it has a lower gain margin.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (comment quoting Skogestad & Grimholt 2012 Table 1)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/dipdt-pid-simc.toml"),
    law: by_formula,
};
