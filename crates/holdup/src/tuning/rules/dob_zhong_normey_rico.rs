//! Zhong-Normey-Rico disturbance observer with two degrees of freedom.
//!
//! # Applies to
//! The plain integrator with dead time; the model is `K e^(-d s)/s`.
//!
//! # Formula
//! `a1 = 2*lam`, `a2 = lam^2`. `Q = ((2 lam + d) s + 1)/(lam s + 1)^2`, the type-2 filter of internal model
//! control. Exact: the complementary sensitivity is `Q e^(-d s)`, and `y/r = e^(-d s)/(T s + 1)`.
//!
//! # Parameters
//! `lam` [s], default 2*d: time of the observer's filter; `T` [s], default d: time of the setpoint response;
//! does not enter robustness.
//!
//! # When
//! One number, lam, sets robustness and load rejection, another, T, the setpoint response.
//!
//! # Limits
//! Below lam = 0.65 d the controller itself is unstable. The law holds an integral over the last dead time: it
//! must be run as such, not as a difference of two integrators.
//!
//! # Published values
//! `sensitivity_peak` = 2.20, 1.87, 1.69, 1.49 at lam = d, 1.5 d, 2 d, 3 d: computed for the collection of
//! rules, not printed by the authors.
//!
//! # Reference
//! Zhong, Normey-Rico; Morari, Zafiriou (2002). Control of integral processes with dead-time. Part 1:
//! Disturbance observer-based 2DOF control scheme, IEE Proc. Control Theory Appl. 149, 285-290; Part 2:
//! Quantitative analysis (Zhong, Mirkin). Provenance: the filter from public code on GitHub (internal model
//! control, type-2 filter of integrating models), the scheme from memory; derived again here.

use crate::model::{CompensatorLaw, Process};
use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Provenance, RuleError, Status, Tuning, Unit, Values,
    compensated,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "dob-zhong-normey-rico",
    name: "Zhong-Normey-Rico disturbance observer with two degrees of freedom",
    authors: "Zhong, Normey-Rico; Morari, Zafiriou",
    year: 2002,
    citation: "Control of integral processes with dead-time. Part 1: Disturbance observer-based 2DOF \
        control scheme, IEE Proc. Control Theory Appl. 149, 285-290; Part 2: Quantitative \
        analysis (Zhong, Mirkin)",
    structure: "2DOF-DTC",
    process: Applies::Integrating,
    form: Form::Compensator,
    parameters: &[
        Parameter::new("lam", Unit::Second, Default::Formula("2*d"), "time of the observer's filter")
            .advised("> 0.65*d"),
        Parameter::new(
            "T",
            Unit::Second,
            Default::Formula("d"),
            "time of the setpoint response; does not enter robustness",
        ),
    ],
    formula: &[("a1", "2*lam"), ("a2", "lam^2")],
    when: "One number, lam, sets robustness and load rejection, another, T, the setpoint response.",
    limits: "Below lam = 0.65 d the controller itself is unstable. The law holds an integral over the \
        last dead time: it must be run as such, not as a difference of two integrators.",
    validity: &[],
    provenance: Provenance::RetrievedAndMemory,
    source: "the filter from public code on GitHub (internal model control, type-2 filter of \
        integrating models), the scheme from memory; derived again here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/dob-zhong-normey-rico.toml"),
    law: tune,
};

fn tune(entry: &'static Entry, process: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let names =
        [("T", Unit::Second), ("a1", Unit::Second), ("a2", Unit::SecondSquared), ("lam", Unit::Second)];
    compensated(entry, process, values, &names, |of| CompensatorLaw::TwoDegree {
        setpoint_time: of("T"),
        a1: of("a1"),
        a2: of("a2"),
    })
}
