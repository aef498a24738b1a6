//! SIMC PID (series).
//!
//! # Applies to
//! The integrator with lag T and dead time.
//!
//! # Formula
//! - `Kc = 1/(K*(tau_c + d))`
//! - `Ti = 4*(tau_c + d)`
//! - `Td = T`
//!
//! # Parameters
//! `tau_c` [s], default d: closed-loop time constant (range > 0, advised >= d).
//!
//! # When
//! The everyday choice, for a series controller: the lag is cancelled.
//!
//! # Limits
//! The derivative is unfiltered in the source.
//!
//! # Published values
//! `Ms` = 1.7.
//!
//! # Reference
//! Skogestad (2003), J. Process Control 13, 291-309.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pid-simc",
    name: "SIMC PID (series)",
    authors: "Skogestad",
    year: 2003,
    citation: "J. Process Control 13, 291-309",
    structure: "PID",
    process: Applies::IntegratingWithLag,
    form: Form::Series,
    parameters: &[Parameter::new("tau_c", Unit::Second, Default::Formula("d"), "closed-loop time constant")
        .range("> 0")
        .advised(">= d")
        .asks(Property::ClosedLoopTimeConstant)],
    formula: &[("Kc", "1/(K*(tau_c + d))"), ("Ti", "4*(tau_c + d)"), ("Td", "T")],
    when: "The everyday choice, for a series controller: the lag is cancelled.",
    limits: "The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::RetrievedAndMemory,
    source: "memory; public code on GitHub (pidtools 'Metody', sections SIMC, iSIMC, Lambda/IMC, averaging level)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pid-simc.toml"),
    law: by_formula,
};
