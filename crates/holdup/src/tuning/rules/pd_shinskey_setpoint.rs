//! Shinskey set-point PD.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1/(1.40*K*d)`
//! - `Td = 0.42*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Setpoint steps.
//!
//! # Limits
//! Proportional band 140 K d. The derivative is unfiltered in the source. A load leaves a lasting error.
//!
//! # Published values
//! `100/(Kc*K*d)` = 140; `Td/d` = 0.42.
//!
//! # Reference
//! Shinskey (1996), Process Control Systems, 4th ed., ch. 4.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pd-shinskey-setpoint",
    name: "Shinskey set-point PD",
    authors: "Shinskey",
    year: 1996,
    citation: "Process Control Systems, 4th ed., ch. 4",
    structure: "PD",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1/(1.40*K*d)"), ("Td", "0.42*d")],
    when: "Setpoint steps.",
    limits: "Proportional band 140 K d. The derivative is unfiltered in the source. A load leaves a lasting error.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub 'Cheatsheet - Shinskey, Process Control Systems (4th ed.)', Table 4.4 and set-point section",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pd-shinskey-setpoint.toml"),
    law: by_formula,
};
