//! Visioli ITSE-optimal load PID.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 1.36/(K*d)`
//! - `Ti = 1.66*d`
//! - `Td = 0.53*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Least weighted error after a load, robustness aside.
//!
//! # Limits
//! Unfiltered |K Kc Td| is 0.66 to 0.81 and the sensitivity peak 4.6 to 7.3; a filter with Td/10 destabilises
//! or ruins it.
//!
//! # Published values
//! `Kc*K*d` = 1.36; `Ti/d` = 1.66; `Td/d` = 0.53.
//!
//! # Reference
//! Visioli (2001), IEE Proc. Control Theory Appl. 148, 180-184.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-visioli-itse",
    name: "Visioli ITSE-optimal load PID",
    authors: "Visioli",
    year: 2001,
    citation: "IEE Proc. Control Theory Appl. 148, 180-184",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.36/(K*d)"), ("Ti", "1.66*d"), ("Td", "0.53*d")],
    when: "Least weighted error after a load, robustness aside.",
    limits: "Unfiltered |K Kc Td| is 0.66 to 0.81 and the sensitivity peak 4.6 to 7.3; a filter with Td/10 destabilises or ruins it.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub 'ipdtctrl.m - PD and PID Parameter Setting for IPDT Models' (Xue/Chen/Atherton book code); ISE row also in FOMCON ipdttune.m",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-visioli-itse.toml"),
    law: by_formula,
};
