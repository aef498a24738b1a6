//! Penner, max closed-loop gain 1.26, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.58/(K*d)`, `Ti = 10*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Setpoint following with little resonance: `M_t` 1.26.
//!
//! # Limits
//! The integral is slow (load IAE 17 K d^2) although the loop is not very robust (`M_s` 1.84). From memory; its design
//! condition holds.
//!
//! # Published values
//! `complementary_sensitivity_peak` = 1.26.
//!
//! # Reference
//! Penner (1988), Tuning rules for a PI controller, Proc. ISA (via O'Dwyer). From memory: no source was read.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-penner-126",
    name: "Penner, max closed-loop gain 1.26, PI",
    authors: "Penner",
    year: 1988,
    citation: "Tuning rules for a PI controller, Proc. ISA (via O'Dwyer)",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.58/(K*d)"), ("Ti", "10*d")],
    when: "Setpoint following with little resonance: M_t 1.26.",
    limits: "The integral is slow (load IAE 17 K d^2) although the loop is not very robust (M_s 1.84). \
             From memory; its design condition holds.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "none retrieved",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-penner-126.toml"),
    law: by_formula,
};
