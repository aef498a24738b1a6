//! Ziegler-Nichols ultimate cycle, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Ku = pi/(2*K*d)`, `Pu = 4*d`, `Kc = 0.45*Ku`, `Ti = Pu/1.2`.
//!
//! # Parameters
//! None.
//!
//! # When
//! The classic ultimate-cycle settings, computed from the model instead of an experiment.
//!
//! # Limits
//! Aggressive: gain margin 1.87, phase margin 25 deg, `M_s` 2.83, a setpoint step overshoots by 73 %.
//!
//! # Published values
//! `Kc*K*Ti` = 2.38 (DIFFERENCE, see the values file).
//!
//! # Reference
//! Ziegler, Nichols (1942), Trans. ASME 64, 759-768; ultimate gain pi/(2 K d) and period 4 d of this process.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-zn-ultimate",
    name: "Ziegler-Nichols ultimate cycle, PI",
    authors: "Ziegler, Nichols",
    year: 1942,
    citation: "Trans. ASME 64, 759-768; ultimate gain pi/(2 K d) and period 4 d of this process",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Ku", "pi/(2*K*d)"), ("Pu", "4*d"), ("Kc", "0.45*Ku"), ("Ti", "Pu/1.2")],
    when: "The classic ultimate-cycle settings, computed from the model instead of an experiment.",
    limits: "Aggressive: gain margin 1.87, phase margin 25 deg, M_s 2.83, a setpoint step overshoots by \
             73 %.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "rodriguessdeyson/pid-tuner, table of its README; znmethod.pdf of pages.mtu.edu",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-zn-ultimate.toml"),
    law: by_formula,
};
