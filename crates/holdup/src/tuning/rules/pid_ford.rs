//! Ford PID.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1.48/(K*d)`, `Ti = 2*d`, `Td = 0.37*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! As history only: it shows how sharp controllers were tuned in the 1950s.
//!
//! # Limits
//! Sensitivity peak 5.9, gain margin 1.23, phase margin 16°: a dead time 19 % longer makes the loop unstable. From
//! memory: no source was read. The derivative is unfiltered in the source.
//!
//! # Published values
//! `decay_ratio` = 0.37037 — DIFFERENCE, see the values file.
//!
//! # Reference
//! Ford (1953), The determination of the optimum process-controller settings, Proc. IEE 101 (1953-54), by way of
//! O'Dwyer.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-ford",
    name: "Ford PID",
    authors: "Ford",
    year: 1953,
    citation: "The determination of the optimum process-controller settings, Proc. IEE 101 (1953-54), by way \
               of O'Dwyer",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.48/(K*d)"), ("Ti", "2*d"), ("Td", "0.37*d")],
    when: "As history only: it shows how sharp controllers were tuned in the 1950s.",
    limits: "Sensitivity peak 5.9, gain margin 1.23, phase margin 16°: a dead time 19 % longer makes the loop \
             unstable. From memory: no source was read. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory: no source was read (O'Dwyer)",
    status: Status::History("sensitivity peak 5.9 and gain margin 1.23 are no longer acceptable"),
    values: include_str!("../../../tests/rules/pid-ford.toml"),
    law: by_formula,
};
