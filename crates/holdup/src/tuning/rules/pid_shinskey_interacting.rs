//! Shinskey min-IAE load PID, interacting (series).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1/(1.08*K*d)`
//! - `Ti = 1.57*d`
//! - `Td = 0.58*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Least integrated error after a load, robustness aside; for an interacting (series) controller.
//!
//! # Limits
//! Proportional band 108 K d. The derivative is unfiltered in the source.
//!
//! # Published values
//! `100/(Kc*K*d)` = 108; `Ti/d` = 1.57; `Td/d` = 0.58.
//!
//! # Reference
//! Shinskey (1996), Process Control Systems, 4th ed., Table 4.4.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-shinskey-interacting",
    name: "Shinskey min-IAE load PID, interacting (series)",
    authors: "Shinskey",
    year: 1996,
    citation: "Process Control Systems, 4th ed., Table 4.4",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Series,
    parameters: &[],
    formula: &[("Kc", "1/(1.08*K*d)"), ("Ti", "1.57*d"), ("Td", "0.58*d")],
    when: "Least integrated error after a load, robustness aside; for an interacting (series) controller.",
    limits: "Proportional band 108 K d. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub 'Cheatsheet - Shinskey, Process Control Systems (4th ed.)', Table 4.4 and set-point section",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-shinskey-interacting.toml"),
    law: by_formula,
};
