//! AMIGO frequency response PI with kappa=0.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Ku = pi/(2*K*d)`, `Pu = 4*d`, `Kc = 0.16*Ku`, `Ti = Pu`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Never for an integrating process: `pi-amigo` is the rule of the same authors for it.
//!
//! # Limits
//! At kappa = 0, the integrating limit, the rule has Ti = Pu = 4 d: far too fast an integral for the gain. `M_s` 1.76,
//! phase margin 34 deg, a setpoint step overshoots by 47 %.
//!
//! # Published values
//! `sensitivity_peak` = 1.4 (DIFFERENCE, see the values file).
//!
//! # Reference
//! Astrom, Hagglund (2006), Advanced PID Control, ISA.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-amigo-freq",
    name: "AMIGO frequency response PI with kappa=0",
    authors: "Astrom, Hagglund",
    year: 2006,
    citation: "Advanced PID Control, ISA",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Ku", "pi/(2*K*d)"), ("Pu", "4*d"), ("Kc", "0.16*Ku"), ("Ti", "Pu")],
    when: "Never for an integrating process: pi-amigo is the rule of the same authors for it.",
    limits: "At kappa = 0, the integrating limit, the rule has Ti = Pu = 4 d: far too fast an integral \
             for the gain. M_s 1.76, phase margin 34 deg, a setpoint step overshoots by 47 %.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: utTuningStepResponse.m of MathWorks, integrating branch",
    status: Status::Wrong(
        "its design condition, a sensitivity peak of 1.4, is not met: the peak is 1.76 (pi-amigo \
             meets it)",
    ),
    values: include_str!("../../../tests/rules/pi-amigo-freq.toml"),
    law: by_formula,
};
