//! Averaging (smooth) level PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = Kc_max`
//! - `Ti = 4/(K*Kc)`
//!
//! # Parameters
//! `Kc_max` [input/output unit], default 0.25/(K*d): largest valve move over largest allowed excursion (range
//! > 0).
//!
//! # When
//! Buffer tanks: use the volume, move the valve little.
//!
//! # Limits
//! The gain is the largest valve move over the largest allowed excursion; the default only shows the form.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Skogestad (2006), Tuning for smooth PID control with acceptable disturbance rejection, Ind. Eng. Chem.
//! Res. 45, 7817-7822.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-averaging",
    name: "Averaging (smooth) level PI",
    authors: "Skogestad",
    year: 2006,
    citation: "Tuning for smooth PID control with acceptable disturbance rejection, Ind. Eng. Chem. Res. 45, 7817-7822",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "Kc_max",
        Unit::Gain,
        Default::Formula("0.25/(K*d)"),
        "largest valve move over largest allowed excursion",
    )],
    formula: &[("Kc", "Kc_max"), ("Ti", "4/(K*Kc)")],
    when: "Buffer tanks: use the volume, move the valve little.",
    limits: "The gain is the largest valve move over the largest allowed excursion; the default only shows the form.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (pidtools 'Metody', sections SIMC, iSIMC, Lambda/IMC, averaging level); https://folk.ntnu.no/skoge/publications/2003/tuningPID/smooth_tunings/README.txt",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-averaging.toml"),
    law: by_formula,
};
