//! Improved SIMC PID, integrating.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1/(K*(tau_c + d))`, `Ti = 4*(tau_c + d)`, `Td = d/3`.
//!
//! # Parameters
//! `tau_c` [s], default d/2: closed-loop time constant, advised at least d/2.
//!
//! # When
//! SIMC with derivative action, the everyday PID: as robust as pi-simc, with 9/16 of its integral error after a
//! load.
//!
//! # Limits
//! At the default the sensitivity peak is 1.73 and the gain margin 2.58; at `tau_c` = d 1.46 and 3.47. Series form.
//! The derivative is unfiltered in the source.
//!
//! # Published values
//! No published value came with the transcription: settings follow the formula, the margins are computed.
//!
//! # Reference
//! Grimholt, Skogestad (2018), Optimal PI and PID control of first-order plus delay processes and evaluation of the
//! original and improved SIMC rules, J. Process Control 70, 36-46.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-isimc",
    name: "Improved SIMC PID, integrating",
    authors: "Grimholt, Skogestad",
    year: 2018,
    citation: "Optimal PI and PID control of first-order plus delay processes and evaluation of the original \
               and improved SIMC rules, J. Process Control 70, 36-46",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Series,
    parameters: &[Parameter::new(
        "tau_c",
        Unit::Second,
        Default::Formula("d/2"),
        "closed-loop time constant",
    )
    .advised(">= d/2")
    .asks(Property::ClosedLoopTimeConstant)],
    formula: &[("Kc", "1/(K*(tau_c + d))"), ("Ti", "4*(tau_c + d)"), ("Td", "d/3")],
    when: "SIMC with derivative action, the everyday PID: as robust as pi-simc, with 9/16 of its integral \
           error after a load.",
    limits: "At the default the sensitivity peak is 1.73 and the gain margin 2.58; at tau_c = d 1.46 and 3.47. \
             Series form. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (pidtools \"Metody\", sections SIMC, iSIMC, Lambda/IMC, averaging level)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-isimc.toml"),
    law: by_formula,
};
