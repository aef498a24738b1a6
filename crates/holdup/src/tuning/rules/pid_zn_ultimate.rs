//! Ziegler-Nichols PID from the ultimate cycle.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Ku = pi/(2*K*d)`, `Pu = 4*d`, `Kc = 0.6*Ku`, `Ti = Pu/2`, `Td = Pu/8`. Ku and Pu are the exact ultimate gain
//! and period of the plain integrator.
//!
//! # Parameters
//! None.
//!
//! # When
//! As the reference that everybody knows; for load rejection. Milder here than the same authors' rule from the
//! reaction curve.
//!
//! # Limits
//! Sensitivity peak 2.29, gain margin 1.79, phase margin 33°; setpoint steps overshoot strongly at setpoint weight
//! 1. The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc*K*d` = 0.942478; `Kc*K*d` = 0.94; `Ti/d` = 2; `Td/d` = 0.5.
//!
//! # Reference
//! Ziegler, Nichols (1942), Optimum settings for automatic controllers, Trans. ASME 64.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-zn-ultimate",
    name: "Ziegler-Nichols PID from the ultimate cycle",
    authors: "Ziegler, Nichols",
    year: 1942,
    citation: "Optimum settings for automatic controllers, Trans. ASME 64",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Ku", "pi/(2*K*d)"), ("Pu", "4*d"), ("Kc", "0.6*Ku"), ("Ti", "Pu/2"), ("Td", "Pu/8")],
    when: "As the reference that everybody knows; for load rejection. Milder here than the same authors' rule \
           from the reaction curve.",
    limits: "Sensitivity peak 2.29, gain margin 1.79, phase margin 33°; setpoint steps overshoot strongly at \
             setpoint weight 1. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "https://github.com/rodriguessdeyson/pid-tuner (README) and \
             https://pages.mtu.edu/~tbco/cm416/znmethod.pdf",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-zn-ultimate.toml"),
    law: by_formula,
};
