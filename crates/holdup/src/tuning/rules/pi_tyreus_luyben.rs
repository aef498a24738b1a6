//! Tyreus-Luyben, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.487/(K*d)`, `Ti = 8.75*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Levels and other integrating loops where a smooth, robust loop matters more than a quick return from a load.
//!
//! # Limits
//! Slow integral: load IAE 18 K d^2 at `M_s` 1.67, against 13 of `pi-maxki-ms` at 1.7. Often printed as Ku/3.2 and 2.2
//! Pu = 8.8 d.
//!
//! # Published values
//! `20*ln(complementary_sensitivity_peak)/ln(10)` = 2.0; `pi/(2*Kc*K*d)` = 3.2; `Ti/(4*d)` = 2.2.
//!
//! # Reference
//! Tyreus, Luyben (1992), Tuning PI controllers for integrator/dead time processes, Ind. Eng. Chem. Res. 31,
//! 2625-2628.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-tyreus-luyben",
    name: "Tyreus-Luyben, PI",
    authors: "Tyreus, Luyben",
    year: 1992,
    citation: "Tuning PI controllers for integrator/dead time processes, Ind. Eng. Chem. Res. 31, \
               2625-2628",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.487/(K*d)"), ("Ti", "8.75*d")],
    when: "Levels and other integrating loops where a smooth, robust loop matters more than a quick \
           return from a load.",
    limits: "Slow integral: load IAE 18 K d^2 at M_s 1.67, against 13 of pi-maxki-ms at 1.7. Often \
             printed as Ku/3.2 and 2.2 Pu = 8.8 d.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "znmethod.pdf of pages.mtu.edu",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-tyreus-luyben.toml"),
    law: by_formula,
};
