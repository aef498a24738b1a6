//! IMC PID for integrating (Seborg row N; Rice-Cooper).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = (2*tau_c + d)/(K*(tau_c + d/2)^2)`
//! - `Ti = 2*tau_c + d`
//! - `Td = (tau_c*d + d^2/4)/(2*tau_c + d)`
//!
//! # Parameters
//! `tau_c` [s], default sqrt(10)*d: closed-loop time constant (range > 0, advised >= 2*d).
//!
//! # When
//! PID whose speed is one time.
//!
//! # Limits
//! The derivative is unfiltered in the source. `tau_c` = d gives the sensitivity peak 4.29, 2 d gives 1.94, 3
//! d gives 1.55.
//!
//! # Published values
//! `Kc` = 0.85470085; `Ti` = 23.4; `Td` = 3.11495726; `Kc` = 0.53475936; `Td` = 3.33395722.
//!
//! # Reference
//! Chien, Fruehauf; Rice, Cooper (1990), Chem. Eng. Prog. 86(10) 33-41; Rice & Cooper, Design and tuning of
//! PID controllers for integrating processes, 2002.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-imc-chien-fruehauf",
    name: "IMC PID for integrating (Seborg row N; Rice-Cooper)",
    authors: "Chien, Fruehauf; Rice, Cooper",
    year: 1990,
    citation: "Chem. Eng. Prog. 86(10) 33-41; Rice & Cooper, Design and tuning of PID controllers for integrating processes, 2002",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "tau_c",
        Unit::Second,
        Default::Formula("sqrt(10)*d"),
        "closed-loop time constant",
    )
    .range("> 0")
    .advised(">= 2*d")
    .asks(Property::ClosedLoopTimeConstant)],
    formula: &[
        ("Kc", "(2*tau_c + d)/(K*(tau_c + d/2)^2)"),
        ("Ti", "2*tau_c + d"),
        ("Td", "(tau_c*d + d^2/4)/(2*tau_c + d)"),
    ],
    when: "PID whose speed is one time.",
    limits: "The derivative is unfiltered in the source. tau_c = d gives the sensitivity peak 4.29, 2 d gives 1.94, 3 d gives 1.55.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (FOSSEE Scilab companion, Seborg-Edgar-Mellichamp Example 11.3, rows M and N); PI form also in id 70437210534",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-imc-chien-fruehauf.toml"),
    law: by_formula,
};
