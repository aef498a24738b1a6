//! AMIGO PID for integrating.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.45/(K*d)`
//! - `Ti = 8*d`
//! - `Td = 0.5*d`
//! - `b = 0`
//!
//! # Parameters
//! None.
//!
//! # When
//! Robust PID: sensitivity peak 1.4.
//!
//! # Limits
//! The derivative is unfiltered in the source. One commercial toolbox prints 0.45/K, the dead time missing.
//!
//! # Published values
//! `Kc*K*d` = 0.45; `Ti/d` = 8; `Td/d` = 0.5; `Ms` = 1.4.
//!
//! # Reference
//! Astrom, Hagglund (2004), J. Process Control 14, 635-650; Advanced PID Control (2006).

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-amigo",
    name: "AMIGO PID for integrating",
    authors: "Astrom, Hagglund",
    year: 2004,
    citation: "J. Process Control 14, 635-650; Advanced PID Control (2006)",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.45/(K*d)"), ("Ti", "8*d"), ("Td", "0.5*d"), ("b", "0")],
    when: "Robust PID: sensitivity peak 1.4.",
    limits: "The derivative is unfiltered in the source. One commercial toolbox prints 0.45/K, the dead time missing.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (AH_itd, PID_Skok/PI_Skok/PID_MP/PI_MP), id 1553951816 (MathWorks utTuningStepResponse.m)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-amigo.toml"),
    law: by_formula,
};
