//! Shinskey PD for setpoint steps.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1/(1.40*K*d)`, `Td = 0.42*d`. The source gives the gain as a proportional band of 140 % of K·d.
//!
//! # Parameters
//! None.
//!
//! # When
//! Setpoint steps of a process that is balanced without integral action, a batch end point for instance.
//!
//! # Limits
//! A load D at the process input leaves a lasting error of D/Kc. Sensitivity peak 1.78, gain margin 2.34, phase
//! margin 64.6°. The derivative is unfiltered in the source.
//!
//! # Published values
//! `100/(Kc*K*d)` = 140; `Td/d` = 0.42.
//!
//! # Reference
//! Shinskey (1996), Process Control Systems, 4th edition, chapter 4.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pd-shinskey-setpoint",
    name: "Shinskey PD for setpoint steps",
    authors: "Shinskey",
    year: 1996,
    citation: "Process Control Systems, 4th edition, chapter 4",
    structure: "PD",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1/(1.40*K*d)"), ("Td", "0.42*d")],
    when: "Setpoint steps of a process that is balanced without integral action, a batch end point for \
           instance.",
    limits: "A load D at the process input leaves a lasting error of D/Kc. Sensitivity peak 1.78, gain margin \
             2.34, phase margin 64.6°. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public notes on GitHub on Shinskey, Process Control Systems, 4th edition (Table 4.4 and the \
             set-point section)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pd-shinskey-setpoint.toml"),
    law: by_formula,
};
