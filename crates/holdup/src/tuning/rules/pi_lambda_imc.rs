//! IMC / lambda tuning PI for integrating processes (Chien-Fruehauf; Rice-Cooper; AH2006; Bialkowski; Rivera-Morari
//! family).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = (2*tau_c + d)/(K*(tau_c + d)^2)`, `Ti = 2*tau_c + d`.
//!
//! # Parameters
//! `tau_c` [s], default sqrt(10)*d: closed-loop time constant; larger is smoother (advised >= 2*d).
//!
//! # When
//! The lambda tuning of plants: one number, the closed-loop time constant, slows the loop without making it oscillate.
//!
//! # Limits
//! A `tau_c` near d is too tight: `M_s` 3.29 at d, 1.95 at 2 d, 1.61 at 3 d. A setpoint step overshoots by 28 % at the
//! default. Some libraries omit the division by K.
//!
//! # Published values
//! `Kc` = 0.493338 at `tau_c = 8`; `Ti` = 23.4 at `tau_c = 8`; `Kc` = 0.37 at `tau_c = 15`; `Kc` = 0.372767 at
//! `tau_c = 15` (DIFFERENCE, see the values file); `Ti` = 37.4 at `tau_c = 15`; `sensitivity_peak` = 3.29 at
//! `tau_c = 1`; `sensitivity_peak` = 1.95 at `tau_c = 2`; `sensitivity_peak` = 1.61 at `tau_c = 3`.
//!
//! # Reference
//! Chien, Fruehauf; Rivera, Morari, Skogestad; Rice, Cooper (1990), Consider IMC tuning to improve controller
//! performance, Chem. Eng. Prog. 86(10), 33-41; Seborg et al., Table 12.1, row M.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-lambda-imc",
    name: "IMC / lambda tuning PI for integrating processes (Chien-Fruehauf; Rice-Cooper; AH2006; \
           Bialkowski; Rivera-Morari family)",
    authors: "Chien, Fruehauf; Rivera, Morari, Skogestad; Rice, Cooper",
    year: 1990,
    citation: "Consider IMC tuning to improve controller performance, Chem. Eng. Prog. 86(10), 33-41; \
               Seborg et al., Table 12.1, row M",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "tau_c",
        Unit::Second,
        Default::Formula("sqrt(10)*d"),
        "closed-loop time constant; larger is smoother",
    )
    .advised(">= 2*d")
    .asks(Property::ClosedLoopTimeConstant)],
    formula: &[("Kc", "(2*tau_c + d)/(K*(tau_c + d)^2)"), ("Ti", "2*tau_c + d")],
    when: "The lambda tuning of plants: one number, the closed-loop time constant, slows the loop without \
           making it oscillate.",
    limits: "A tau_c near d is too tight: M_s 3.29 at d, 1.95 at 2 d, 1.61 at 3 d. A setpoint step \
             overshoots by 28 % at the default. Some libraries omit the division by K.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: companion of Seborg, Edgar, Mellichamp, rows M and N; pidtools \
             \"Metody\"",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-lambda-imc.toml"),
    law: by_formula,
};
