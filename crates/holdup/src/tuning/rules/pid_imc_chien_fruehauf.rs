//! IMC PID for integrating processes.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = (2*tau_c + d)/(K*(tau_c + d/2)^2)`, `Ti = 2*tau_c + d`, `Td = (tau_c*d + d^2/4)/(2*tau_c + d)`.
//!
//! # Parameters
//! `tau_c` [s], default sqrt(10)·d: closed-loop time constant, advised at least 2·d.
//!
//! # When
//! A smooth PID whose speed is one time constant, with well damped load response.
//!
//! # Limits
//! `tau_c` below 2 d is not robust: the sensitivity peak is 1.55 at 3 d, 1.94 at 2 d and 4.29 at d. The derivative
//! is unfiltered in the source.
//!
//! # Published values
//! `Kc` = 0.8547009 (K = 0.2, d = 7.4, `tau_c` = 8); `Ti` = 23.4; `Td` = 3.1149573; `Kc` = 0.5347594 (`tau_c` =
//! 15); `Td` = 3.3339572; `sensitivity_peak` = 4.29 (`tau_c` = d); `sensitivity_peak` = 1.94 (`tau_c` = 2 d);
//! `sensitivity_peak` = 1.55 (`tau_c` = 3 d).
//!
//! # Reference
//! Chien, Fruehauf; Rice, Cooper (1990), Consider IMC tuning to improve controller performance, Chem. Eng. Prog.
//! 86(10), 33-41; Rice, Cooper, Design and tuning of PID controllers for integrating processes, 2002.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-imc-chien-fruehauf",
    name: "IMC PID for integrating processes",
    authors: "Chien, Fruehauf; Rice, Cooper",
    year: 1990,
    citation: "Consider IMC tuning to improve controller performance, Chem. Eng. Prog. 86(10), 33-41; Rice, \
               Cooper, Design and tuning of PID controllers for integrating processes, 2002",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "tau_c",
        Unit::Second,
        Default::Formula("sqrt(10)*d"),
        "closed-loop time constant",
    )
    .advised(">= 2*d")
    .asks(Property::ClosedLoopTimeConstant)],
    formula: &[
        ("Kc", "(2*tau_c + d)/(K*(tau_c + d/2)^2)"),
        ("Ti", "2*tau_c + d"),
        ("Td", "(tau_c*d + d^2/4)/(2*tau_c + d)"),
    ],
    when: "A smooth PID whose speed is one time constant, with well damped load response.",
    limits: "tau_c below 2 d is not robust: the sensitivity peak is 1.55 at 3 d, 1.94 at 2 d and 4.29 at d. \
             The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (FOSSEE Scilab companion of Seborg, Edgar, Mellichamp, example 11.3, rows M \
             and N)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-imc-chien-fruehauf.toml"),
    law: by_formula,
};
