//! Poulin-Pomerleau ultimate cycle PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Ku = pi/(2*K*d)`, `Pu = 4*d`, `Kc = 0.34*Ku`, `Ti = 1.04*Pu`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Where an ultimate-cycle (relay) experiment is what is known: a quick PI, load IAE 8.1 K d^2.
//!
//! # Limits
//! `M_s` 2.01, phase margin 34 deg, a setpoint step overshoots by 49 %. From memory.
//!
//! # Published values
//! None: the formula is from memory and no number of the paper was retrieved.
//!
//! # Reference
//! Poulin, Pomerleau (1999), PI settings for integrating processes based on ultimate cycle information, IEEE Trans.
//! Control Systems Technology 7(4). From memory: no source was read.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-poulin-1999",
    name: "Poulin-Pomerleau ultimate cycle PI",
    authors: "Poulin, Pomerleau",
    year: 1999,
    citation: "PI settings for integrating processes based on ultimate cycle information, IEEE Trans. \
               Control Systems Technology 7(4)",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Ku", "pi/(2*K*d)"), ("Pu", "4*d"), ("Kc", "0.34*Ku"), ("Ti", "1.04*Pu")],
    when: "Where an ultimate-cycle (relay) experiment is what is known: a quick PI, load IAE 8.1 K d^2.",
    limits: "M_s 2.01, phase margin 34 deg, a setpoint step overshoots by 49 %. From memory.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "none retrieved",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-poulin-1999.toml"),
    law: by_formula,
};
