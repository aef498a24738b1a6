//! Ziegler-Nichols ultimate cycle, PID.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.6*pi/(2*K*d)`
//! - `Ti = 2*d`
//! - `Td = 0.5*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! As history of the field.
//!
//! # Limits
//! The derivative is unfiltered in the source. Hardly robust.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Ziegler, Nichols (1942), Trans. ASME 64; also AH1995 row 0.94, 2d, 0.5d.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-zn-ultimate",
    name: "Ziegler-Nichols ultimate cycle, PID",
    authors: "Ziegler, Nichols",
    year: 1942,
    citation: "Trans. ASME 64; also AH1995 row 0.94, 2d, 0.5d",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.6*pi/(2*K*d)"), ("Ti", "2*d"), ("Td", "0.5*d")],
    when: "As history of the field.",
    limits: "The derivative is unfiltered in the source. Hardly robust.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "https://github.com/rodriguessdeyson/pid-tuner README table and https://pages.mtu.edu/~tbco/cm416/znmethod.pdf",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-zn-ultimate.toml"),
    law: by_formula,
};
