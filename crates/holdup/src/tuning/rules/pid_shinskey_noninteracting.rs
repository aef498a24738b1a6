//! Shinskey min-IAE load PID, noninteracting (ideal).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1/(0.78*K*d)`
//! - `Ti = 1.90*d`
//! - `Td = 0.48*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Least integrated error after a load, robustness aside; for a noninteracting (ideal) controller.
//!
//! # Limits
//! Proportional band 78 K d. The derivative is unfiltered in the source.
//!
//! # Published values
//! `100/(Kc*K*d)` = 78; `Ti/d` = 1.90; `Td/d` = 0.48.
//!
//! # Reference
//! Shinskey (1996), Process Control Systems, 4th ed., Table 4.4.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-shinskey-noninteracting",
    name: "Shinskey min-IAE load PID, noninteracting (ideal)",
    authors: "Shinskey",
    year: 1996,
    citation: "Process Control Systems, 4th ed., Table 4.4",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1/(0.78*K*d)"), ("Ti", "1.90*d"), ("Td", "0.48*d")],
    when: "Least integrated error after a load, robustness aside; for a noninteracting (ideal) controller.",
    limits: "Proportional band 78 K d. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub 'Cheatsheet - Shinskey, Process Control Systems (4th ed.)', Table 4.4 and set-point section",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-shinskey-noninteracting.toml"),
    law: by_formula,
};
