//! NI `LabVIEW` PI, some overshoot / little overshoot.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = variant/(K*d)`, `Ti = 5.33*d`.
//!
//! # Parameters
//! `variant`, default 0.4: loop gain K Kc d: 0.4 (some overshoot) or 0.24 (little overshoot) (one of 0.4, 0.24).
//!
//! # When
//! A middling PI without a knob: `M_s` 1.62, load IAE 14 K d^2 at the default.
//!
//! # Limits
//! The variant for little overshoot overshoots more, not less: 39 % against 36 % of a setpoint step, because the gain
//! falls and the integral time stays. Read in a transcription, not in the manual.
//!
//! # Published values
//! `Kc*K*d` = 0.4; `Ti/d` = 5.33; `Kc*K*d` = 0.24 at `variant = 0.24`.
//!
//! # Reference
//! National Instruments (2001), `LabVIEW` PID Control Toolset, via O'Dwyer.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-labview",
    name: "NI LabVIEW PI, some overshoot / little overshoot",
    authors: "National Instruments",
    year: 2001,
    citation: "LabVIEW PID Control Toolset, via O'Dwyer",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "variant",
        Unit::Ratio,
        Default::Number(0.4),
        "loop gain K Kc d: 0.4 (some overshoot) or 0.24 (little overshoot)",
    )
    .range("0.4 | 0.24")],
    formula: &[("Kc", "variant/(K*d)"), ("Ti", "5.33*d")],
    when: "A middling PI without a knob: M_s 1.62, load IAE 14 K d^2 at the default.",
    limits: "The variant for little overshoot overshoots more, not less: 39 % against 36 % of a setpoint \
             step, because the gain falls and the integral time stays. Read in a transcription, not in \
             the manual.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-labview.toml"),
    law: by_formula,
};
