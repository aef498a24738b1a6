//! H-infinity PID with output filter.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `D = 3*lam^2 + 1.5*lam*d + 0.25*d^2`, `Kc = (3*lam + d)/(K*D)`, `Ti = 3*lam + d`,
//! `Td = d/2*(3*lam + d/2)/(3*lam + d)`, `Tf = lam^3/D`. Derived again here: with (1 - d·s/2)/(1 + d·s/2) for the
//! dead time the loop has three poles at -1/lam.
//!
//! # Parameters
//! `lam` [s], default 2·d: time constant of the triple closed-loop pole of the design model, advised at least d.
//!
//! # When
//! A PID whose speed is one number and which brings its own noise filter on the whole output.
//!
//! # Limits
//! The formula is from memory, derived again here. Sensitivity peak 2.29 at lam = d, 1.80 at 1.5 d, 1.62 at 2 d;
//! below lam = d not robust.
//!
//! # Published values
//! `sensitivity_peak` = 2.29 (lam = d); `sensitivity_peak` = 1.80 (lam = 1.5 d).
//!
//! # Reference
//! Zhang, Xu, Sun (1999), Quantitative performance design for integrating processes with time delay, Automatica 35,
//! 719-723.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-zhang-hinf",
    name: "H-infinity PID with output filter",
    authors: "Zhang, Xu, Sun",
    year: 1999,
    citation: "Quantitative performance design for integrating processes with time delay, Automatica 35, \
               719-723",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::IdealOutputFilter,
    parameters: &[Parameter::new(
        "lam",
        Unit::Second,
        Default::Formula("2*d"),
        "time constant of the triple closed-loop pole of the design model",
    )
    .advised(">= d")
    .asks(Property::ClosedLoopTimeConstant)],
    formula: &[
        ("D", "3*lam^2 + 1.5*lam*d + 0.25*d^2"),
        ("Kc", "(3*lam + d)/(K*D)"),
        ("Ti", "3*lam + d"),
        ("Td", "d/2*(3*lam + d/2)/(3*lam + d)"),
        ("Tf", "lam^3/D"),
    ],
    when: "A PID whose speed is one number and which brings its own noise filter on the whole output.",
    limits: "The formula is from memory, derived again here. Sensitivity peak 2.29 at lam = d, 1.80 at 1.5 d, \
             1.62 at 2 d; below lam = d not robust.",
    validity: &[],
    provenance: Provenance::MemoryRederived,
    source: "memory (no source was read); derived again here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-zhang-hinf.toml"),
    law: by_formula,
};

#[cfg(test)]
mod tests {
    use num_complex::Complex64;

    use crate::model::{Process, Seconds};
    use crate::tuning::{Parameters, rule};

    #[test]
    fn with_the_first_order_approximation_of_the_dead_time_the_loop_has_its_triple_pole() {
        let (k, d, lam) = (0.5, 2.0, 3.0);
        let process = Process::integrating(k, Seconds(d)).unwrap();
        let pid = rule("pid-zhang-hinf")
            .unwrap()
            .tune(&process, &Parameters::new().set("lam", lam))
            .unwrap()
            .controller;
        let (filter, ti) = (pid.output_filter().unwrap(), pid.integral_time().unwrap());
        for omega in [0.01, 0.3, 1.0, 7.0] {
            let s = Complex64::new(0.2, omega);
            let law = pid.proportional_gain() * (1.0 + 1.0 / (ti * s) + pid.derivative_time().unwrap() * s)
                / (filter.a2 * s * s + filter.a1 * s + 1.0);
            let dead_time = (1.0 - 0.5 * d * s) / (1.0 + 0.5 * d * s);
            let left = 1.0 + law * k / s * dead_time;
            let design = 3.0 * lam * lam + 1.5 * lam * d + 0.25 * d * d;
            let right =
                (lam * s + 1.0).powu(3) / (design * s * s * (filter.a2 * s * s + filter.a1 * s + 1.0));
            // Some thirty roundings.
            assert!((left - right).norm() < 1e-12 * right.norm(), "{left} is not {right}");
        }
    }
}
