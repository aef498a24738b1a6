//! AMIGO frequency response PID with kappa=0.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.3*pi/(2*K*d)`
//! - `Ti = 0.6*4*d`
//! - `Td = 0.15*4*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Never.
//!
//! # Limits
//! The derivative is unfiltered in the source. With kappa = 0 the sensitivity peak is 1.70 and the
//! complementary peak 1.95, not the 1.4 of the design.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Astrom, Hagglund (2006), Advanced PID Control.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-amigo-freq",
    name: "AMIGO frequency response PID with kappa=0",
    authors: "Astrom, Hagglund",
    year: 2006,
    citation: "Advanced PID Control",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.3*pi/(2*K*d)"), ("Ti", "0.6*4*d"), ("Td", "0.15*4*d")],
    when: "Never.",
    limits: "The derivative is unfiltered in the source. With kappa = 0 the sensitivity peak is 1.70 and the complementary peak 1.95, not the 1.4 of the design.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (AH_itd, PID_Skok/PI_Skok/PID_MP/PI_MP), id 1553951816 (MathWorks utTuningStepResponse.m)",
    status: Status::Wrong(
        "with kappa = 0, as an integrator has it, the sensitivity peak is 1.70 and the complementary peak 1.95, not 1.4",
    ),
    values: include_str!("../../../tests/rules/pid-amigo-freq.toml"),
    law: by_formula,
};
