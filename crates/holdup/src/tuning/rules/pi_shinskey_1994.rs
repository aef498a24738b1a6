//! Shinskey min-IAE load, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.9524/(K*d)`, `Ti = 4*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Load rejection above all, as the 1988 rule.
//!
//! # Limits
//! No robustness: gain margin 1.44, phase margin 19 deg, `M_s` 4.16, a setpoint step overshoots by 89 %; the 1988
//! version has the smaller load IAE. Written in the source as a proportional band of 105 K d %.
//!
//! # Published values
//! `load_peak/(K*d)` = 1.48 (DIFFERENCE, see the values file); `Kc*K*d` = 0.9524; `Ti/d` = 4.0.
//!
//! # Reference
//! Shinskey (1994), Feedback Controllers for the Process Industries, McGraw-Hill.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-shinskey-1994",
    name: "Shinskey min-IAE load, PI",
    authors: "Shinskey",
    year: 1994,
    citation: "Feedback Controllers for the Process Industries, McGraw-Hill",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.9524/(K*d)"), ("Ti", "4*d")],
    when: "Load rejection above all, as the 1988 rule.",
    limits: "No robustness: gain margin 1.44, phase margin 19 deg, M_s 4.16, a setpoint step overshoots \
             by 89 %; the 1988 version has the smaller load IAE. Written in the source as a proportional \
             band of 105 K d %.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook; a cheat sheet to \
             Shinskey, Process Control Systems, 4th ed., Table 4.4",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-shinskey-1994.toml"),
    law: by_formula,
};
