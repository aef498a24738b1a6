//! Averaging (smooth) level PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = Kc_max`, `Ti = 4/(K*Kc)`.
//!
//! # Parameters
//! `Kc_max` [input/output unit], default 0.25/(K*d): largest move of the manipulated variable over largest allowed
//! excursion.
//!
//! # When
//! A buffer tank that shall use its volume: the least gain that keeps the level within its limits moves the outflow
//! least.
//!
//! # Limits
//! The gain is the largest valve move over the largest allowed excursion, from the plant and not from the model; the
//! default is only a quiet example (`M_s` 1.27). Without dead time the damping ratio is 1; slow, load IAE 64 K d^2 at
//! the default.
//!
//! # Published values
//! `K*Kc*Ti` = 4 at `Kc_max = 0.1`.
//!
//! # Reference
//! Skogestad (2006), Tuning for smooth PID control with acceptable disturbance rejection, Ind. Eng. Chem. Res. 45,
//! 7817-7822.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-averaging",
    name: "Averaging (smooth) level PI",
    authors: "Skogestad",
    year: 2006,
    citation: "Tuning for smooth PID control with acceptable disturbance rejection, Ind. Eng. Chem. Res. \
               45, 7817-7822",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "Kc_max",
        Unit::Gain,
        Default::Formula("0.25/(K*d)"),
        "largest move of the manipulated variable over largest allowed excursion",
    )],
    formula: &[("Kc", "Kc_max"), ("Ti", "4/(K*Kc)")],
    when: "A buffer tank that shall use its volume: the least gain that keeps the level within its limits \
           moves the outflow least.",
    limits: "The gain is the largest valve move over the largest allowed excursion, from the plant and \
             not from the model; the default is only a quiet example (M_s 1.27). Without dead time the \
             damping ratio is 1; slow, load IAE 64 K d^2 at the default.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (pidtools \"Metody\", averaging level); README of the smooth tunings \
             at folk.ntnu.no/skoge",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-averaging.toml"),
    law: by_formula,
};
