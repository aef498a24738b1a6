//! Visioli ISE-optimal set-point PD.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1.03/(K*d)`
//! - `Td = 0.49*d`
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
//! `Kc*K*d` = 1.03; `Td/d` = 0.49.
//!
//! # Reference
//! Visioli (2001), Optimal tuning of PID controllers for integral and unstable processes, IEE Proc. Control
//! Theory Appl. 148, 180-184.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pd-visioli-ise",
    name: "Visioli ISE-optimal set-point PD",
    authors: "Visioli",
    year: 2001,
    citation: "Optimal tuning of PID controllers for integral and unstable processes, IEE Proc. Control Theory Appl. 148, 180-184",
    structure: "PD",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.03/(K*d)"), ("Td", "0.49*d")],
    when: "Fast setpoint steps.",
    limits: "The derivative is unfiltered in the source. A load leaves a lasting error.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub 'ipdtctrl.m - PD and PID Parameter Setting for IPDT Models' (Xue/Chen/Atherton book code); ISE row also in FOMCON ipdttune.m",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pd-visioli-ise.toml"),
    law: by_formula,
};
