//! Shinskey PID for load, interacting.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1/(1.08*K*d)`, `Ti = 1.57*d`, `Td = 0.58*d`. The source gives the gain as a proportional band of 108 % of
//! K·d.
//!
//! # Parameters
//! None.
//!
//! # When
//! Tuned for the least IAE after a load step with an interacting (series) controller, and about 1 % above the
//! least: a reference for load rejection.
//!
//! # Limits
//! Sensitivity peak 3.6, gain margin 1.41, phase margin 27°: for a well known dead time. The printed IAE is that of
//! the unfiltered loop, the printed peak that of one with its lead filtered at Td/10: the two cannot both be right.
//! The derivative is unfiltered in the source.
//!
//! # Published values
//! `100/(Kc*K*d)` = 108; `load_iae/(K*d^2)` = 1.99; `load_peak/(K*d)` = 1.13 — DIFFERENCE, see the values file.
//!
//! # Reference
//! Shinskey (1996), Process Control Systems, 4th edition, Table 4.4.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-shinskey-interacting",
    name: "Shinskey PID for load, interacting",
    authors: "Shinskey",
    year: 1996,
    citation: "Process Control Systems, 4th edition, Table 4.4",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Series,
    parameters: &[],
    formula: &[("Kc", "1/(1.08*K*d)"), ("Ti", "1.57*d"), ("Td", "0.58*d")],
    when: "Tuned for the least IAE after a load step with an interacting (series) controller, and about 1 % \
           above the least: a reference for load rejection.",
    limits: "Sensitivity peak 3.6, gain margin 1.41, phase margin 27°: for a well known dead time. The printed \
             IAE is that of the unfiltered loop, the printed peak that of one with its lead filtered at Td/10: \
             the two cannot both be right. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public notes on GitHub on Shinskey, Process Control Systems, 4th edition (Table 4.4 and the \
             set-point section)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-shinskey-interacting.toml"),
    law: by_formula,
};
