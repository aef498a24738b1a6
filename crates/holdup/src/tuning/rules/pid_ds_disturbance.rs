//! Direct synthesis for disturbances, PID with second-order output filter.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `eta = 3*lam + d`, `D = 3*lam^2 + 3*lam*d + 0.5*d^2`, `Kc = (eta + 0.5*d)/(K*D)`, `Ti = eta + 0.5*d`,
//! `Td = 0.5*d*eta/(eta + 0.5*d)`, `a1 = (lam^3 + 1.5*lam^2*d)/D`, `a2 = 0.5*lam^3*d/D`. Derived here: with (1 -
//! d·s/2)/(1 + d·s/2) for the dead time the loop has three poles at -1/lam and one at -2/d; the whole output is
//! filtered by 1/(a2·s² + a1·s + 1).
//!
//! # Parameters
//! `lam` [s], default 1.5·d: time constant of the triple closed-loop pole of the design model, advised at least d.
//!
//! # When
//! Load rejection with a controller that rolls off: noise reaches the actuator twice filtered.
//!
//! # Limits
//! The formula is derived here, in the structure of the source: not its printed one. Sensitivity peak 1.96 at the
//! default, 2.34 at lam = d. A setpoint step at weight 1 overshoots.
//!
//! # Published values
//! Derived here; no value is published for this formula.
//!
//! # Reference
//! Seshagiri Rao, Rao, Padma Sree (family) (2009), Direct synthesis-based controller design for integrating
//! processes with time delay, J. Franklin Inst. 346, 38-56 (structure; the formula is derived here).

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-ds-disturbance",
    name: "Direct synthesis for disturbances, PID with second-order output filter",
    authors: "Seshagiri Rao, Rao, Padma Sree (family)",
    year: 2009,
    citation: "Direct synthesis-based controller design for integrating processes with time delay, J. Franklin \
               Inst. 346, 38-56 (structure; the formula is derived here)",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::IdealOutputFilter,
    parameters: &[Parameter::new(
        "lam",
        Unit::Second,
        Default::Formula("1.5*d"),
        "time constant of the triple closed-loop pole of the design model",
    )
    .advised(">= d")
    .asks(Property::ClosedLoopTimeConstant)],
    formula: &[
        ("eta", "3*lam + d"),
        ("D", "3*lam^2 + 3*lam*d + 0.5*d^2"),
        ("Kc", "(eta + 0.5*d)/(K*D)"),
        ("Ti", "eta + 0.5*d"),
        ("Td", "0.5*d*eta/(eta + 0.5*d)"),
        ("a1", "(lam^3 + 1.5*lam^2*d)/D"),
        ("a2", "0.5*lam^3*d/D"),
    ],
    when: "Load rejection with a controller that rolls off: noise reaches the actuator twice filtered.",
    limits: "The formula is derived here, in the structure of the source: not its printed one. Sensitivity \
             peak 1.96 at the default, 2.34 at lam = d. A setpoint step at weight 1 overshoots.",
    validity: &[],
    provenance: Provenance::Derived,
    source: "derived here, with the first-order approximation of the dead time that the source uses",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-ds-disturbance.toml"),
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
        let pid = rule("pid-ds-disturbance")
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
            let design = 3.0 * lam * lam + 3.0 * lam * d + 0.5 * d * d;
            let right = (lam * s + 1.0).powu(3) * (1.0 + 0.5 * d * s)
                / (design * s * s * (filter.a2 * s * s + filter.a1 * s + 1.0));
            // Some thirty roundings.
            assert!((left - right).norm() < 1e-12 * right.norm(), "{left} is not {right}");
        }
    }
}
