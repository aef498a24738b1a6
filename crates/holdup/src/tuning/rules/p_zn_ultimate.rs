//! Ziegler-Nichols ultimate cycle, P.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Ku = pi/(2*K*d)`, `Kc = 0.5*Ku`.
//!
//! # Parameters
//! None.
//!
//! # When
//! The ultimate-cycle experiment done on the model: half the gain at which the loop oscillates.
//!
//! # Limits
//! Gain margin exactly 2 and phase margin 45 deg, but a setpoint step overshoots by 29 %. P control leaves a lasting
//! error under load.
//!
//! # Published values
//! `gain_margin*Kc*K*d` = 1.57079632679; `2*pi/(phase_crossover*d)` = 4.0.
//!
//! # Reference
//! Ziegler, Nichols (1942), Trans. ASME 64, 759-768; ultimate gain pi/(2 K d) and period 4 d of this process.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "p-zn-ultimate",
    name: "Ziegler-Nichols ultimate cycle, P",
    authors: "Ziegler, Nichols",
    year: 1942,
    citation: "Trans. ASME 64, 759-768; ultimate gain pi/(2 K d) and period 4 d of this process",
    structure: "P",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Ku", "pi/(2*K*d)"), ("Kc", "0.5*Ku")],
    when: "The ultimate-cycle experiment done on the model: half the gain at which the loop oscillates.",
    limits: "Gain margin exactly 2 and phase margin 45 deg, but a setpoint step overshoots by 29 %. P \
             control leaves a lasting error under load.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "rodriguessdeyson/pid-tuner, table of its README; znmethod.pdf of pages.mtu.edu",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/p-zn-ultimate.toml"),
    law: by_formula,
};
