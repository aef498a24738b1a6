//! IMC / lambda tuning PI for integrating processes (Chien-Fruehauf; Rice-Cooper; AH2006; Bialkowski;
//! Rivera-Morari family).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = (2*tau_c + d)/(K*(tau_c + d)^2)`
//! - `Ti = 2*tau_c + d`
//!
//! # Parameters
//! `tau_c` [s], default sqrt(10)*d: closed-loop time constant (range > 0, advised >= 2*d).
//!
//! # When
//! PI whose speed is one time, the common lambda tuning.
//!
//! # Limits
//! `tau_c` = d gives the sensitivity peak 3.29, 2 d gives 1.95, 3 d gives 1.61. One Python library omits the
//! division by the process gain.
//!
//! # Published values
//! `Kc` = 0.493338; `Ti` = 23.4; `Kc` = 0.372767; `Ti` = 37.4.
//!
//! # Reference
//! Chien, Fruehauf; Rivera, Morari, Skogestad; Rice, Cooper (1990), I.-L. Chien, P.S. Fruehauf, Consider IMC
//! tuning to improve controller performance, Chem. Eng. Prog. 86(10) 33-41; Seborg et al. Table 12.1 row M.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-lambda-imc",
    name: "IMC / lambda tuning PI for integrating processes (Chien-Fruehauf; Rice-Cooper; AH2006; Bialkowski; Rivera-Morari family)",
    authors: "Chien, Fruehauf; Rivera, Morari, Skogestad; Rice, Cooper",
    year: 1990,
    citation: "I.-L. Chien, P.S. Fruehauf, Consider IMC tuning to improve controller performance, Chem. Eng. Prog. 86(10) 33-41; Seborg et al. Table 12.1 row M",
    structure: "PI",
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
    formula: &[("Kc", "(2*tau_c + d)/(K*(tau_c + d)^2)"), ("Ti", "2*tau_c + d")],
    when: "PI whose speed is one time, the common lambda tuning.",
    limits: "tau_c = d gives the sensitivity peak 3.29, 2 d gives 1.95, 3 d gives 1.61. One Python library omits the division by the process gain.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub (FOSSEE Scilab companion, Seborg-Edgar-Mellichamp Example 11.3, rows M and N); PI form also in id 70437210534; public code on GitHub (pidtools 'Metody', sections SIMC, iSIMC, Lambda/IMC, averaging level)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-lambda-imc.toml"),
    law: by_formula,
};
