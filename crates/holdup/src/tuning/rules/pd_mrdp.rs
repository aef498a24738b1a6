//! PD with a triple real pole.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 4*exp(-2)/(K*d)`, `Td = d/4`. A triple root of `s*exp(d*s) + K*Kc*(1 + Td*s)`: its second derivative
//! vanishes at s = -2/d.
//!
//! # Parameters
//! None.
//!
//! # When
//! Setpoint steps without overshoot at the fastest triple real pole, s = -2/d; a robust starting point for PD.
//!
//! # Limits
//! A load D at the process input leaves a lasting error of D/Kc. Sensitivity peak 1.49, gain margin 3.36, phase
//! margin 66°. The derivative is unfiltered.
//!
//! # Published values
//! `Kc*K*d` = 0.541341; `decay_rate*d` = 2.00; `damping_ratio` = 1.00.
//!
//! # Reference
//! Huba; Vitecek (2003), method of the multiple real dominant pole.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pd-mrdp",
    name: "PD with a triple real pole",
    authors: "Huba; Vitecek",
    year: 2003,
    citation: "method of the multiple real dominant pole",
    structure: "PD",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "4*exp(-2)/(K*d)"), ("Td", "d/4")],
    when: "Setpoint steps without overshoot at the fastest triple real pole, s = -2/d; a robust starting point \
           for PD.",
    limits: "A load D at the process input leaves a lasting error of D/Kc. Sensitivity peak 1.49, gain margin \
             3.36, phase margin 66°. The derivative is unfiltered.",
    validity: &[],
    provenance: Provenance::Derived,
    source: "derived here: three conditions on one real pole",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pd-mrdp.toml"),
    law: by_formula,
};
