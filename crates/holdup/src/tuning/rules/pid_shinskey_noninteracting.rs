//! Shinskey PID for load, noninteracting.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1/(0.78*K*d)`, `Ti = 1.90*d`, `Td = 0.48*d`. The source gives the gain as a proportional band of 78 % of
//! K·d.
//!
//! # Parameters
//! None.
//!
//! # When
//! Tuned for the least IAE after a load step with a noninteracting (ideal) controller, and about 1 % above the
//! least: a reference for load rejection.
//!
//! # Limits
//! Sensitivity peak 4.0, gain margin 1.35, phase margin 28°: for a well known dead time. The derivative is
//! unfiltered in the source.
//!
//! # Published values
//! `100/(Kc*K*d)` = 78; `load_iae/(K*d^2)` = 1.94.
//!
//! # Reference
//! Shinskey (1996), Process Control Systems, 4th edition, Table 4.4.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-shinskey-noninteracting",
    name: "Shinskey PID for load, noninteracting",
    authors: "Shinskey",
    year: 1996,
    citation: "Process Control Systems, 4th edition, Table 4.4",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1/(0.78*K*d)"), ("Ti", "1.90*d"), ("Td", "0.48*d")],
    when: "Tuned for the least IAE after a load step with a noninteracting (ideal) controller, and about 1 % \
           above the least: a reference for load rejection.",
    limits: "Sensitivity peak 4.0, gain margin 1.35, phase margin 28°: for a well known dead time. The \
             derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public notes on GitHub on Shinskey, Process Control Systems, 4th edition (Table 4.4 and the \
             set-point section)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-shinskey-noninteracting.toml"),
    law: by_formula,
};
