//! Huba-Zakova P with a double real pole.
//!
//! # Applies to
//! The integrator with lag T and dead time, `K·e^(−d·s)/(s·(T·s + 1))`.
//!
//! # Formula
//! `R = sqrt(d^2 + 4*T^2)`, `Kc = exp(2*T/(R + d) - 1)/(K*(R + 2*T))`. The source prints the same as
//! `(R - 2*T)/(K*d^2*exp((2*T + d - R)/(2*T)))`, which loses its digits where T is far from d; the two are equal
//! because `R^2 = d^2 + 4*T^2`. Derived again here: the double root of `s*(1 + T*s)*exp(d*s) + K*Kc`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Setpoint steps of an integrator with lag without overshoot, with the simplest controller there is.
//!
//! # Limits
//! A load D at the process input leaves a lasting error of D/Kc. Sensitivity peak 1.38, 1.28, 1.19 at T = 0.2 d, d,
//! 5 d: robust and slow. As T vanishes it becomes the P rule with a double real pole on the plain integrator.
//!
//! # Published values
//! `Kc*d^2*K*exp((2*T + d - sqrt(d^2 + 4*T^2))/(2*T))/(sqrt(d^2 + 4*T^2) - 2*T)` = 1.000000; `damping_ratio` =
//! 1.00; `decay_rate*(2*d*T)/(2*T + d - sqrt(d^2 + 4*T^2))` = 1.000.
//!
//! # Reference
//! Huba, Zakova (2003), by way of O'Dwyer.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ifopdt-p-huba-zakova",
    name: "Huba-Zakova P with a double real pole",
    authors: "Huba, Zakova",
    year: 2003,
    citation: "by way of O'Dwyer",
    structure: "P",
    process: Applies::IntegratingWithLag,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("R", "sqrt(d^2 + 4*T^2)"), ("Kc", "exp(2*T/(R + d) - 1)/(K*(R + 2*T))")],
    when: "Setpoint steps of an integrator with lag without overshoot, with the simplest controller there is.",
    limits: "A load D at the process input leaves a lasting error of D/Kc. Sensitivity peak 1.38, 1.28, 1.19 \
             at T = 0.2 d, d, 5 d: robust and slow. As T vanishes it becomes the P rule with a double real \
             pole on the plain integrator.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner, a C# transcription of O'Dwyer's tables, \
             Methods/TunningMethods/FOLIPDModelTunningMethods, commit 59b8950a",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/ifopdt-p-huba-zakova.toml"),
    law: by_formula,
};
