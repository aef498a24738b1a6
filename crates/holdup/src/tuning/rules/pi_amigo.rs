//! AMIGO, PI for integrating.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.35/(K*d)`, `Ti = 13.4*d`, `b = 0`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Robust control without setpoint overshoot (b = 0); the reference for `M_s` 1.4.
//!
//! # Limits
//! Slow: load IAE 38 K d^2, and with b = 0 the setpoint IAE is 13.4 d. The limit of the general formula is Ti = 13.35
//! d. One commercial toolbox has the PID sister of this rule with wrong dimensions.
//!
//! # Published values
//! `sensitivity_peak` = 1.4; `Kc*K*d` = 0.35; `Ti/d` = 13.4; `sensitivity_peak` = 1.41.
//!
//! # Reference
//! Astrom, Hagglund (2004), Revisiting the Ziegler-Nichols step response method for PID control, J. Process Control
//! 14, 635-650; Advanced PID Control (ISA 2006).

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-amigo",
    name: "AMIGO, PI for integrating",
    authors: "Astrom, Hagglund",
    year: 2004,
    citation: "Revisiting the Ziegler-Nichols step response method for PID control, J. Process Control \
               14, 635-650; Advanced PID Control (ISA 2006)",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.35/(K*d)"), ("Ti", "13.4*d"), ("b", "0")],
    when: "Robust control without setpoint overshoot (b = 0); the reference for M_s 1.4.",
    limits: "Slow: load IAE 38 K d^2, and with b = 0 the setpoint IAE is 13.4 d. The limit of the general \
             formula is Ti = 13.35 d. One commercial toolbox has the PID sister of this rule with wrong \
             dimensions.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: utTuningStepResponse.m of MathWorks, integrating branch; S7_PID-Tuner \
             and a third transcription",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-amigo.toml"),
    law: by_formula,
};
