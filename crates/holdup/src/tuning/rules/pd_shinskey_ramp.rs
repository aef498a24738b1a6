//! Shinskey ramp/batch PD.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1/(1.20*K*d)`
//! - `Td = 0.45*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Setpoint ramps and batch ends.
//!
//! # Limits
//! Proportional band 120 K d. The derivative is unfiltered in the source. A load leaves a lasting error.
//!
//! # Published values
//! `100/(Kc*K*d)` = 120; `Td/d` = 0.45.
//!
//! # Reference
//! Shinskey (1996), Process Control Systems, 4th ed., ch. 4 and 12.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pd-shinskey-ramp",
    name: "Shinskey ramp/batch PD",
    authors: "Shinskey",
    year: 1996,
    citation: "Process Control Systems, 4th ed., ch. 4 and 12",
    structure: "PD",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1/(1.20*K*d)"), ("Td", "0.45*d")],
    when: "Setpoint ramps and batch ends.",
    limits: "Proportional band 120 K d. The derivative is unfiltered in the source. A load leaves a lasting error.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub 'Cheatsheet - Shinskey, Process Control Systems (4th ed.)', Table 4.4 and set-point section",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pd-shinskey-ramp.toml"),
    law: by_formula,
};
