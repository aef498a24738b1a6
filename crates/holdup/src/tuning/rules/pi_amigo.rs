//! AMIGO, PI for integrating.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.35/(K*d)`
//! - `Ti = 13.4*d`
//! - `b = 0`
//!
//! # Parameters
//! None.
//!
//! # When
//! Robust PI: sensitivity peak 1.4.
//!
//! # Limits
//! Slow load rejection. The limit of the general formula is 13.35 d.
//!
//! # Published values
//! `Kc*K*d` = 0.35; `Ti/d` = 13.4; `Ms` = 1.4.
//!
//! # Reference
//! Astrom, Hagglund (2004), Revisiting the Ziegler-Nichols step response method for PID control, J. Process
//! Control 14, 635-650; Advanced PID Control (ISA 2006).

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-amigo",
    name: "AMIGO, PI for integrating",
    authors: "Astrom, Hagglund",
    year: 2004,
    citation: "Revisiting the Ziegler-Nichols step response method for PID control, J. Process Control 14, 635-650; Advanced PID Control (ISA 2006)",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.35/(K*d)"), ("Ti", "13.4*d"), ("b", "0")],
    when: "Robust PI: sensitivity peak 1.4.",
    limits: "Slow load rejection. The limit of the general formula is 13.35 d.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (AH_itd, PID_Skok/PI_Skok/PID_MP/PI_MP), id 1553951816 (MathWorks utTuningStepResponse.m); github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-amigo.toml"),
    law: by_formula,
};
