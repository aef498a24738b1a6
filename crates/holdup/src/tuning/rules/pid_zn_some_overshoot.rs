//! Modified Ziegler-Nichols PID, some overshoot.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Ku = pi/(2*K*d)`, `Pu = 4*d`, `Kc = 0.33*Ku`, `Ti = Pu/2`, `Td = Pu/3`. Ku and Pu are the exact ultimate gain
//! and period of the plain integrator.
//!
//! # Parameters
//! None.
//!
//! # When
//! Not to be used on an integrator: kept to show what is wrong with it. pid-isimc is the robust everyday PID.
//!
//! # Limits
//! Made for self-regulating processes: with Ti = 2 d on an integrator the dominant damping is 0.30. K Kc Td is
//! 0.69: gain margin 1.45, sensitivity peak 3.24, reached as a limit of high frequency. From memory: no source was
//! read.
//!
//! # Published values
//! No value is published with it for an integrator.
//!
//! # Reference
//! Seborg, Edgar, Mellichamp (table) (1989), Process Dynamics and Control; a general rule from the ultimate cycle.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-zn-some-overshoot",
    name: "Modified Ziegler-Nichols PID, some overshoot",
    authors: "Seborg, Edgar, Mellichamp (table)",
    year: 1989,
    citation: "Process Dynamics and Control; a general rule from the ultimate cycle",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Ku", "pi/(2*K*d)"), ("Pu", "4*d"), ("Kc", "0.33*Ku"), ("Ti", "Pu/2"), ("Td", "Pu/3")],
    when: "Not to be used on an integrator: kept to show what is wrong with it. pid-isimc is the robust \
           everyday PID.",
    limits: "Made for self-regulating processes: with Ti = 2 d on an integrator the dominant damping is 0.30. \
             K Kc Td is 0.69: gain margin 1.45, sensitivity peak 3.24, reached as a limit of high frequency. \
             From memory: no source was read.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory: no source was read",
    status: Status::Wrong(
        "it is made for self-regulating processes: on an integrator its dominant damping is 0.30 and its \
         sensitivity peak 3.2, and nothing published confirms it",
    ),
    values: include_str!("../../../tests/rules/pid-zn-some-overshoot.toml"),
    law: by_formula,
};
