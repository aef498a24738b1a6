//! Poulin-Pomerleau ITAE, input step load, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.5327/(K*d)`, `Ti = 3.8853*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Load steps at the process input, with the resonance peak held at 5 dB: load IAE 8.0 K d^2.
//!
//! # Limits
//! `M_s` 2.06, phase margin 33 deg, a setpoint step overshoots by 52 %: filter or weight the setpoint.
//!
//! # Published values
//! `20*ln(complementary_sensitivity_peak)/ln(10)` = 5.0; `Kc*K*d` = 0.5327; `Ti/d` = 3.8853.
//!
//! # Reference
//! Poulin, Pomerleau (1996), PID tuning for integrating and unstable processes, IEE Proc. Control Theory Appl. 143,
//! 429-435.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-poulin-input",
    name: "Poulin-Pomerleau ITAE, input step load, PI",
    authors: "Poulin, Pomerleau",
    year: 1996,
    citation: "PID tuning for integrating and unstable processes, IEE Proc. Control Theory Appl. 143, \
               429-435",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.5327/(K*d)"), ("Ti", "3.8853*d")],
    when: "Load steps at the process input, with the resonance peak held at 5 dB: load IAE 8.0 K d^2.",
    limits: "M_s 2.06, phase margin 33 deg, a setpoint step overshoots by 52 %: filter or weight the \
             setpoint.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-poulin-input.toml"),
    law: by_formula,
};
