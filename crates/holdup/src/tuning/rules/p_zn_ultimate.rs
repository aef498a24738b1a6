//! Ziegler-Nichols ultimate cycle, P (IPDT closed form).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = pi/(4*K*d)`
//!
//! # Parameters
//! None.
//!
//! # When
//! A P control with gain margin 2 and phase margin 45° exactly.
//!
//! # Limits
//! A load leaves a lasting error.
//!
//! # Published values
//! `GM` = 2.0000; `PM_deg` = 45.0000.
//!
//! # Reference
//! Ziegler, Nichols (1942), Trans. ASME 64, 759-768; for IPDT Ku=pi/(2 Kp d), Pu=4d.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "p-zn-ultimate",
    name: "Ziegler-Nichols ultimate cycle, P (IPDT closed form)",
    authors: "Ziegler, Nichols",
    year: 1942,
    citation: "Trans. ASME 64, 759-768; for IPDT Ku=pi/(2 Kp d), Pu=4d",
    structure: "P",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "pi/(4*K*d)")],
    when: "A P control with gain margin 2 and phase margin 45° exactly.",
    limits: "A load leaves a lasting error.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "https://github.com/rodriguessdeyson/pid-tuner README table and https://pages.mtu.edu/~tbco/cm416/znmethod.pdf",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/p-zn-ultimate.toml"),
    law: by_formula,
};
