//! Hay, PI (memory only).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.42/(K*d)`, `Ti = 5.8*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Never by this name: the numbers could not be traced. `pi-simc` and `pi-maxki-ms` are known and better.
//!
//! # Limits
//! From memory only. The loop itself is unremarkable: gain margin 3.43, phase margin 43 deg, `M_s` 1.63, load IAE 14 K
//! d^2.
//!
//! # Published values
//! None: the formula is from memory and no number of the book was retrieved.
//!
//! # Reference
//! Hay (1998), The industrial art of controller tuning, via O'Dwyer. From memory: no source was read.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-hay",
    name: "Hay, PI (memory only)",
    authors: "Hay",
    year: 1998,
    citation: "The industrial art of controller tuning, via O'Dwyer",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.42/(K*d)"), ("Ti", "5.8*d")],
    when: "Never by this name: the numbers could not be traced. pi-simc and pi-maxki-ms are known and \
           better.",
    limits: "From memory only. The loop itself is unremarkable: gain margin 3.43, phase margin 43 deg, \
             M_s 1.63, load IAE 14 K d^2.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "none retrieved",
    status: Status::Wrong(
        "unverified: from memory without a source, and no published value to hold it against",
    ),
    values: include_str!("../../../tests/rules/pi-hay.toml"),
    law: by_formula,
};
