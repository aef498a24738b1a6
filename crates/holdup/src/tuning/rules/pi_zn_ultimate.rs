//! Ziegler-Nichols ultimate cycle, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.45*pi/(2*K*d)`
//! - `Ti = 4*d/1.2`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field.
//!
//! # Limits
//! Ku = pi/(2 K d) and Pu = 4 d of the plain integrator are put in.
//!
//! # Published values
//! `Kc*Ti*K` = 2.38.
//!
//! # Reference
//! Ziegler, Nichols (1942), Trans. ASME 64; IPDT: Ku=pi/(2 Kp d), Pu=4d.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-zn-ultimate",
    name: "Ziegler-Nichols ultimate cycle, PI",
    authors: "Ziegler, Nichols",
    year: 1942,
    citation: "Trans. ASME 64; IPDT: Ku=pi/(2 Kp d), Pu=4d",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.45*pi/(2*K*d)"), ("Ti", "4*d/1.2")],
    when: "As history of the field.",
    limits: "Ku = pi/(2 K d) and Pu = 4 d of the plain integrator are put in.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "https://github.com/rodriguessdeyson/pid-tuner README table and https://pages.mtu.edu/~tbco/cm416/znmethod.pdf",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-zn-ultimate.toml"),
    law: by_formula,
};
