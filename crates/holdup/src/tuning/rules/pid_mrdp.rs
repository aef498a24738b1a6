//! PID with a quadruple real pole.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = (12*sqrt(3) - 18)*exp(sqrt(3) - 3)/(K*d)`, `Ti = (2 + sqrt(3))*d`,
//! `Td = (sqrt(3) - 1)/(12*sqrt(3) - 18)*d`. A quadruple root of `s^2*exp(d*s) + K*Kc*(s + 1/Ti + Td*s^2)`: its
//! third derivative vanishes at `s*d = sqrt(3) - 3`. The source prints the three factors as decimals.
//!
//! # Parameters
//! None.
//!
//! # When
//! Fast load rejection without oscillation: all dominant poles at -1.268/d.
//!
//! # Limits
//! Sensitivity peak 1.99, gain margin 2.30, phase margin 37°; a setpoint step at weight 1 overshoots. The source
//! has it with two degrees of freedom, whose weights did not come here. The derivative is unfiltered.
//!
//! # Published values
//! `Kc*K*d` = 0.78361185; `Ti/d` = 3.73205081; `Td/d` = 0.26289171; `decay_rate*d` = 1.27.
//!
//! # Reference
//! Huba; Vitecek, Viteckova (2010), 2DOF PI and PID controllers tuning, IFAC Workshop on Time Delay Systems; Huba,
//! Vrancic.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-mrdp",
    name: "PID with a quadruple real pole",
    authors: "Huba; Vitecek, Viteckova",
    year: 2010,
    citation: "2DOF PI and PID controllers tuning, IFAC Workshop on Time Delay Systems; Huba, Vrancic",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[
        ("Kc", "(12*sqrt(3) - 18)*exp(sqrt(3) - 3)/(K*d)"),
        ("Ti", "(2 + sqrt(3))*d"),
        ("Td", "(sqrt(3) - 1)/(12*sqrt(3) - 18)*d"),
    ],
    when: "Fast load rejection without oscillation: all dominant poles at -1.268/d.",
    limits: "Sensitivity peak 1.99, gain margin 2.30, phase margin 37°; a setpoint step at weight 1 \
             overshoots. The source has it with two degrees of freedom, whose weights did not come here. The \
             derivative is unfiltered.",
    validity: &[],
    provenance: Provenance::MemoryRederived,
    source: "memory (no source was read); derived again here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-mrdp.toml"),
    law: by_formula,
};
