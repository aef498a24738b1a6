//! Visioli ISTE-optimal set-point PD.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.9/(K*d)`
//! - `Td = 0.45*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Fast setpoint steps.
//!
//! # Limits
//! The derivative is unfiltered in the source. A load leaves a lasting error.
//!
//! # Published values
//! `Kc*K*d` = 0.9; `Td/d` = 0.45.
//!
//! # Reference
//! Visioli (2001), Optimal tuning of PID controllers for integral and unstable processes, IEE Proc. Control
//! Theory Appl. 148, 180-184.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pd-visioli-iste",
    name: "Visioli ISTE-optimal set-point PD",
    authors: "Visioli",
    year: 2001,
    citation: "Optimal tuning of PID controllers for integral and unstable processes, IEE Proc. Control Theory Appl. 148, 180-184",
    structure: "PD",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.9/(K*d)"), ("Td", "0.45*d")],
    when: "Fast setpoint steps.",
    limits: "The derivative is unfiltered in the source. A load leaves a lasting error.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub 'ipdtctrl.m - PD and PID Parameter Setting for IPDT Models' (Xue/Chen/Atherton book code); ISE row also in FOMCON ipdttune.m",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pd-visioli-iste.toml"),
    law: by_formula,
};
