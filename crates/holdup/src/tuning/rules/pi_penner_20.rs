//! Penner, max closed-loop gain 2.0, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.8/(K*d)`, `Ti = 5.9*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Fast load rejection: load IAE 7.4 K d^2, `M_t` 2.0.
//!
//! # Limits
//! `M_s` 2.67, gain margin 1.81, a setpoint step overshoots by 59 %. From memory; its design condition holds.
//!
//! # Published values
//! `complementary_sensitivity_peak` = 2.0.
//!
//! # Reference
//! Penner (1988), Tuning rules for a PI controller, Proc. ISA (via O'Dwyer). From memory: no source was read.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-penner-20",
    name: "Penner, max closed-loop gain 2.0, PI",
    authors: "Penner",
    year: 1988,
    citation: "Tuning rules for a PI controller, Proc. ISA (via O'Dwyer)",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.8/(K*d)"), ("Ti", "5.9*d")],
    when: "Fast load rejection: load IAE 7.4 K d^2, M_t 2.0.",
    limits: "M_s 2.67, gain margin 1.81, a setpoint step overshoots by 59 %. From memory; its design \
             condition holds.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "none retrieved",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-penner-20.toml"),
    law: by_formula,
};
