//! Haalman PD, lag cancelled.
//!
//! # Applies to
//! The integrator with lag T and dead time, `K·e^(−d·s)/(s·(T·s + 1))`.
//!
//! # Formula
//! `Kc = 2/(3*K*d)`, `Td = T`. The derivative cancels the lag: the loop is 2/(3·d·s)·e^(−d·s) whatever T is.
//!
//! # Parameters
//! None.
//!
//! # When
//! Setpoint steps of an integrator with lag, where no lasting load acts.
//!
//! # Limits
//! A load D at the process input leaves a lasting error of D/Kc. Gain margin 2.36, phase margin 51.8°, sensitivity
//! peak 1.92 for every T. The derivative is unfiltered in the source: a long lag makes it a large noise gain.
//!
//! # Published values
//! `gain_margin` = 2.356; `phase_margin_deg` = 51.80; `sensitivity_peak` = 1.9.
//!
//! # Reference
//! Haalman; Xue, Chen (1965), Adjusting controllers for a deadtime process, Control Engineering 12, 71-73; Xue,
//! Chen, Atherton.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-pd-haalman",
    name: "Haalman PD, lag cancelled",
    authors: "Haalman; Xue, Chen",
    year: 1965,
    citation: "Adjusting controllers for a deadtime process, Control Engineering 12, 71-73; Xue, Chen, \
               Atherton",
    structure: "PD",
    process: Applies::IntegratingWithLag,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "2/(3*K*d)"), ("Td", "T")],
    when: "Setpoint steps of an integrator with lag, where no lasting load acts.",
    limits: "A load D at the process input leaves a lasting error of D/Kc. Gain margin 2.36, phase margin \
             51.8°, sensitivity peak 1.92 for every T. The derivative is unfiltered in the source: a long lag \
             makes it a large noise gain.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: foipdt.m, PD and PID settings for FOIPDT models (Xue, Chen, Atherton, book \
             code)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-pd-haalman.toml"),
    law: by_formula,
};
