//! Visioli PD, ISE of a setpoint step.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1.03/(K*d)`, `Td = 0.49*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Fast setpoint steps where no lasting load acts and robustness may be spent; the sharpest of the three Visioli PD
//! rules.
//!
//! # Limits
//! A load D at the process input leaves a lasting error of D/Kc. Sensitivity peak 2.96, gain margin 1.52, phase
//! margin 52.0°. The unfiltered derivative keeps |L(j inf)| at 0.50. The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc*K*d` = 1.03; `Td/d` = 0.49.
//!
//! # Reference
//! Visioli (2001), Optimal tuning of PID controllers for integral and unstable processes, IEE Proc. Control Theory
//! Appl. 148, 180-184.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pd-visioli-ise",
    name: "Visioli PD, ISE of a setpoint step",
    authors: "Visioli",
    year: 2001,
    citation: "Optimal tuning of PID controllers for integral and unstable processes, IEE Proc. Control Theory \
               Appl. 148, 180-184",
    structure: "PD",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.03/(K*d)"), ("Td", "0.49*d")],
    when: "Fast setpoint steps where no lasting load acts and robustness may be spent; the sharpest of the \
           three Visioli PD rules.",
    limits: "A load D at the process input leaves a lasting error of D/Kc. Sensitivity peak 2.96, gain margin \
             1.52, phase margin 52.0°. The unfiltered derivative keeps |L(j inf)| at 0.50. The derivative is \
             unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: ipdtctrl.m, PD and PID settings for IPDT models (Xue, Chen, Atherton, book \
             code); the ISE row also in FOMCON ipdttune.m",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pd-visioli-ise.toml"),
    law: by_formula,
};
