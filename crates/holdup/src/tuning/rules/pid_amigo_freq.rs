//! AMIGO PID from the frequency response, extrapolated to kappa = 0.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `kappa = 0`, `Ku = pi/(2*K*d)`, `Pu = 4*d`, `Kc = (0.3 - 0.1*kappa^4)*Ku`, `Ti = 0.6*Pu/(1 + 2*kappa)`,
//! `Td = 0.15*Pu*(1 - kappa)/(1 - 0.95*kappa)`. kappa, the gain at the ultimate frequency over the static gain, is
//! 0 on an integrator.
//!
//! # Parameters
//! None.
//!
//! # When
//! Not to be used: kept to show what is wrong with it. For an integrator the same authors give pid-amigo.
//!
//! # Limits
//! The integral time is 2.4 d where pid-amigo has 8 d: phase margin 34°, complementary sensitivity peak 1.95,
//! dominant damping 0.35, sensitivity peak 1.70 instead of 1.4.
//!
//! # Published values
//! `sensitivity_peak` = 1.4 — DIFFERENCE, see the values file.
//!
//! # Reference
//! Astrom, Hagglund (2006), Advanced PID Control.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-amigo-freq",
    name: "AMIGO PID from the frequency response, extrapolated to kappa = 0",
    authors: "Astrom, Hagglund",
    year: 2006,
    citation: "Advanced PID Control",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[
        ("kappa", "0"),
        ("Ku", "pi/(2*K*d)"),
        ("Pu", "4*d"),
        ("Kc", "(0.3 - 0.1*kappa^4)*Ku"),
        ("Ti", "0.6*Pu/(1 + 2*kappa)"),
        ("Td", "0.15*Pu*(1 - kappa)/(1 - 0.95*kappa)"),
    ],
    when: "Not to be used: kept to show what is wrong with it. For an integrator the same authors give \
           pid-amigo.",
    limits: "The integral time is 2.4 d where pid-amigo has 8 d: phase margin 34°, complementary sensitivity \
             peak 1.95, dominant damping 0.35, sensitivity peak 1.70 instead of 1.4.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "MathWorks utTuningStepResponse.m (public code on GitHub, id 1553951816)",
    status: Status::Wrong(
        "extrapolated to kappa = 0 its integral time is 2.4 d, which misses the design constraint: sensitivity \
         peak 1.70 and complementary peak 1.95 instead of 1.4",
    ),
    values: include_str!("../../../tests/rules/pid-amigo-freq.toml"),
    law: by_formula,
};
