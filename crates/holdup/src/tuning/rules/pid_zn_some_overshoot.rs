//! Modified ZN, some overshoot.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.33*pi/(2*K*d)`
//! - `Ti = 2*d`
//! - `Td = 4*d/3`
//!
//! # Parameters
//! None.
//!
//! # When
//! Never.
//!
//! # Limits
//! The derivative is unfiltered in the source. A rule for self-regulating processes; from memory.
//!
//! # Published values
//! None retrieved.
//!
//! # Reference
//! Seborg, Edgar, Mellichamp (table) (1989), Process Dynamics and Control; generic ultimate-cycle rule.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-zn-some-overshoot",
    name: "Modified ZN, some overshoot",
    authors: "Seborg, Edgar, Mellichamp (table)",
    year: 1989,
    citation: "Process Dynamics and Control; generic ultimate-cycle rule",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.33*pi/(2*K*d)"), ("Ti", "2*d"), ("Td", "4*d/3")],
    when: "Never.",
    limits: "The derivative is unfiltered in the source. A rule for self-regulating processes; from memory.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory",
    status: Status::Wrong(
        "a rule for self-regulating processes, from memory, which nothing confirms for integrators",
    ),
    values: include_str!("../../../tests/rules/pid-zn-some-overshoot.toml"),
    law: by_formula,
};
