//! Tyreus-Luyben PID from the ultimate cycle.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Ku = pi/(2*K*d)`, `Pu = 4*d`, `Kc = Ku/2.2`, `Ti = 2.2*Pu`, `Td = Pu/6.3`. Ku and Pu are the exact ultimate
//! gain and period of the plain integrator.
//!
//! # Parameters
//! None.
//!
//! # When
//! Smooth control from an ultimate-cycle test, made for processes with an integrator; slow to remove a load.
//!
//! # Limits
//! Phase margin 65° but gain margin only 1.92 and sensitivity peak 2.09: the large derivative time spends at high
//! frequency what the slow integral saves. The derivative is unfiltered in the source.
//!
//! # Published values
//! `pi/(2*K*d)/Kc` = 2.2; `Ti/(4*d)` = 2.2; `4*d/Td` = 6.3.
//!
//! # Reference
//! Tyreus, Luyben; Luyben (1997), Luyben, Luyben, Essentials of Process Control.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-tyreus-luyben",
    name: "Tyreus-Luyben PID from the ultimate cycle",
    authors: "Tyreus, Luyben; Luyben",
    year: 1997,
    citation: "Luyben, Luyben, Essentials of Process Control",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Ku", "pi/(2*K*d)"), ("Pu", "4*d"), ("Kc", "Ku/2.2"), ("Ti", "2.2*Pu"), ("Td", "Pu/6.3")],
    when: "Smooth control from an ultimate-cycle test, made for processes with an integrator; slow to remove a \
           load.",
    limits: "Phase margin 65° but gain margin only 1.92 and sensitivity peak 2.09: the large derivative time \
             spends at high frequency what the slow integral saves. The derivative is unfiltered in the \
             source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "https://pages.mtu.edu/~tbco/cm416/znmethod.pdf",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-tyreus-luyben.toml"),
    law: by_formula,
};
