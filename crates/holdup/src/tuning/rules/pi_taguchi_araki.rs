//! Taguchi-Araki 2DOF PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.7662/(K*d)`, `Ti = 4.091*d`, `b = 0.319`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Fast load rejection (load IAE 5.3 K d^2) and a setpoint step without overshoot, by the setpoint weight.
//!
//! # Limits
//! Little robustness: gain margin 1.80, phase margin 27 deg, `M_s` 2.82. From memory.
//!
//! # Published values
//! None: the formula is from memory and no number of the paper was retrieved.
//!
//! # Reference
//! Taguchi, Araki (2000), Two-degree-of-freedom PID controllers - their functions and optimal tuning, IFAC Workshop
//! PID 2000. From memory: no source was read.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-taguchi-araki",
    name: "Taguchi-Araki 2DOF PI",
    authors: "Taguchi, Araki",
    year: 2000,
    citation: "Two-degree-of-freedom PID controllers - their functions and optimal tuning, IFAC Workshop \
               PID 2000",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.7662/(K*d)"), ("Ti", "4.091*d"), ("b", "0.319")],
    when: "Fast load rejection (load IAE 5.3 K d^2) and a setpoint step without overshoot, by the \
           setpoint weight.",
    limits: "Little robustness: gain margin 1.80, phase margin 27 deg, M_s 2.82. From memory.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "none retrieved",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-taguchi-araki.toml"),
    law: by_formula,
};
