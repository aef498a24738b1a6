//! AMIGO frequency response PI with kappa=0.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.16*pi/(2*K*d)`
//! - `Ti = 4*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Never.
//!
//! # Limits
//! With kappa = 0 the integral time becomes Pu = 4 d: the sensitivity peak is 1.76 and the complementary peak
//! 1.89, not the 1.4 of the design.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Astrom, Hagglund (2006), Advanced PID Control (ISA 2006).

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-amigo-freq",
    name: "AMIGO frequency response PI with kappa=0",
    authors: "Astrom, Hagglund",
    year: 2006,
    citation: "Advanced PID Control (ISA 2006)",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.16*pi/(2*K*d)"), ("Ti", "4*d")],
    when: "Never.",
    limits: "With kappa = 0 the integral time becomes Pu = 4 d: the sensitivity peak is 1.76 and the complementary peak 1.89, not the 1.4 of the design.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (AH_itd, PID_Skok/PI_Skok/PID_MP/PI_MP), id 1553951816 (MathWorks utTuningStepResponse.m)",
    status: Status::Wrong(
        "with kappa = 0, as an integrator has it, the sensitivity peak is 1.76 and the complementary peak 1.89, not 1.4",
    ),
    values: include_str!("../../../tests/rules/pi-amigo-freq.toml"),
    law: by_formula,
};
