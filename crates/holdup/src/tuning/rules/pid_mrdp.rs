//! PID, quadruple real dominant pole.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.78361185/(K*d)`
//! - `Ti = 3.73205081*d`
//! - `Td = 0.26289171*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! A quadruple real pole: load rejection without ringing.
//!
//! # Limits
//! The derivative is unfiltered in the source.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Huba; Vitecek, Viteckova (2010), 2DOF PI and PID controllers tuning, IFAC TDS 2010; Huba & Vrancic.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-mrdp",
    name: "PID, quadruple real dominant pole",
    authors: "Huba; Vitecek, Viteckova",
    year: 2010,
    citation: "2DOF PI and PID controllers tuning, IFAC TDS 2010; Huba & Vrancic",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.78361185/(K*d)"), ("Ti", "3.73205081*d"), ("Td", "0.26289171*d")],
    when: "A quadruple real pole: load rejection without ringing.",
    limits: "The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::MemoryRederived,
    source: "derived here; memory",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-mrdp.toml"),
    law: by_formula,
};
