//! SIMC PID for the double integrator.
//!
//! # Applies to
//! The double integrator with dead time, `K·e^(−d·s)/s²`.
//!
//! # Formula
//! `Kc = 1/(4*K*(tau_c + d)^2)`, `Ti = 4*(tau_c + d)`, `Td = 4*(tau_c + d)`. Series form.
//!
//! # Parameters
//! `tau_c` [s], default d: closed-loop time constant, advised at least d.
//!
//! # When
//! The everyday choice for a double integrator: positioning, attitude, a tank after a tank.
//!
//! # Limits
//! Conditionally stable: a gain below 0.165 of the nominal makes the loop unstable too, so a saturating actuator
//! can. Gain margin 2.76, phase margin 33°. `tau_c` below d is less robust than the author recommends. The
//! derivative is unfiltered in the source.
//!
//! # Published values
//! `sensitivity_peak` = 1.96.
//!
//! # Reference
//! Skogestad (2003), Simple analytic rules for model reduction and PID controller tuning, J. Process Control 13,
//! 291-309.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "dipdt-pid-simc",
    name: "SIMC PID for the double integrator",
    authors: "Skogestad",
    year: 2003,
    citation: "Simple analytic rules for model reduction and PID controller tuning, J. Process Control 13, \
               291-309",
    structure: "PID",
    process: Applies::DoubleIntegrating,
    form: Form::Series,
    parameters: &[Parameter::new("tau_c", Unit::Second, Default::Formula("d"), "closed-loop time constant")
        .advised(">= d")
        .asks(Property::ClosedLoopTimeConstant)],
    formula: &[("Kc", "1/(4*K*(tau_c + d)^2)"), ("Ti", "4*(tau_c + d)"), ("Td", "4*(tau_c + d)")],
    when: "The everyday choice for a double integrator: positioning, attitude, a tank after a tank.",
    limits: "Conditionally stable: a gain below 0.165 of the nominal makes the loop unstable too, so a \
             saturating actuator can. Gain margin 2.76, phase margin 33°. tau_c below d is less robust than \
             the author recommends. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (comment quoting Skogestad, Grimholt 2012, Table 1)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/dipdt-pid-simc.toml"),
    law: by_formula,
};
