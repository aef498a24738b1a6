//! AMIGO PID for integrating processes.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.45/(K*d)`, `Ti = 8*d`, `Td = 0.5*d`, `b = 0`. The weight of the derivative action (c) is not stated by
//! the transcriptions read; it stays 1 here.
//!
//! # Parameters
//! None.
//!
//! # When
//! A robust PID for every day: the design limits the sensitivity peaks to 1.4.
//!
//! # Limits
//! Slow to remove a load. One commercial toolbox prints the gain as 0.45/K, without the dead time. The setpoint
//! does not act on the proportional action (b = 0). The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc*K*d` = 0.45; `Ti/d` = 8; `Td/d` = 0.5; `sensitivity_peak` = 1.4.
//!
//! # Reference
//! Astrom, Hagglund (2004), Revisiting the Ziegler-Nichols step response method for PID control, J. Process Control
//! 14, 635-650; Advanced PID Control (2006).

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-amigo",
    name: "AMIGO PID for integrating processes",
    authors: "Astrom, Hagglund",
    year: 2004,
    citation: "Revisiting the Ziegler-Nichols step response method for PID control, J. Process Control 14, \
               635-650; Advanced PID Control (2006)",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.45/(K*d)"), ("Ti", "8*d"), ("Td", "0.5*d"), ("b", "0")],
    when: "A robust PID for every day: the design limits the sensitivity peaks to 1.4.",
    limits: "Slow to remove a load. One commercial toolbox prints the gain as 0.45/K, without the dead time. \
             The setpoint does not act on the proportional action (b = 0). The derivative is unfiltered in the \
             source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (AH_itd, PID_Skok, PI_Skok, PID_MP, PI_MP; MathWorks \
             utTuningStepResponse.m, id 1553951816)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-amigo.toml"),
    law: by_formula,
};
