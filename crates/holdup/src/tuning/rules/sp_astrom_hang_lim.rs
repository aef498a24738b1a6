//! Astrom-Hang-Lim Smith predictor.
//!
//! # Applies to
//! The plain integrator with dead time; the model is `K e^(-d s)/s`.
//!
//! # Formula
//! `k4 = k2 + k3*d`, `a1 = k2/k3`, `a2 = (1 + k1)/k3`. `M = (k4 + k3/s)/(1 + k1 + k2/s + k3/s^2 - (k4/s +
//! k3/s^2) e^(-d s))` feeds `y - y_m` back to the process input. Exact: the complementary sensitivity is `(k4 s +
//! k3) e^(-d s)/((1 + k1) s^2 + k2 s + k3)`.
//!
//! # Parameters
//! `k1` [–], default 0.0: coefficient of the compensator M; `k2` [1/s], default 2/d: coefficient of the
//! compensator M; `k3` [1/s²], default 1/d^2: coefficient of the compensator M; `T` [s], default d: time of the
//! setpoint response, 1/(K k) of the source's main gain k.
//!
//! # When
//! As dob-zhong-normey-rico, with poles of the load response that may be complex.
//!
//! # Limits
//! The same loop as dob-zhong-normey-rico where the poles are equal. The defaults give lam = d there:
//! sensitivity peak 2.20.
//!
//! # Published values
//! None: no source with values was retrieved.
//!
//! # Reference
//! Astrom, Hang, Lim (1994). A new Smith predictor for controlling a process with an integrator and long
//! dead-time, IEEE Trans. Automat. Control 39, 343-345. Provenance: from memory: no source was read; the
//! identities were derived again here.

use crate::model::{CompensatorLaw, Process};
use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Provenance, RuleError, Status, Tuning, Unit, Values,
    compensated,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "sp-astrom-hang-lim",
    name: "Astrom-Hang-Lim Smith predictor",
    authors: "Astrom, Hang, Lim",
    year: 1994,
    citation: "A new Smith predictor for controlling a process with an integrator and long dead-time, \
        IEEE Trans. Automat. Control 39, 343-345",
    structure: "2DOF-DTC",
    process: Applies::Integrating,
    form: Form::Compensator,
    parameters: &[
        Parameter::new("k1", Unit::Ratio, Default::Number(0.0), "coefficient of the compensator M")
            .range(">= 0"),
        Parameter::new("k2", Unit::PerSecond, Default::Formula("2/d"), "coefficient of the compensator M"),
        Parameter::new(
            "k3",
            Unit::PerSecondSquared,
            Default::Formula("1/d^2"),
            "coefficient of the compensator M",
        ),
        Parameter::new(
            "T",
            Unit::Second,
            Default::Formula("d"),
            "time of the setpoint response, 1/(K k) of the source's main gain k",
        ),
    ],
    formula: &[("k4", "k2 + k3*d"), ("a1", "k2/k3"), ("a2", "(1 + k1)/k3")],
    when: "As dob-zhong-normey-rico, with poles of the load response that may be complex.",
    limits: "The same loop as dob-zhong-normey-rico where the poles are equal. The defaults give lam \
        = d there: sensitivity peak 2.20.",
    validity: &[],
    provenance: Provenance::MemoryRederived,
    source: "from memory: no source was read; the identities were derived again here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/sp-astrom-hang-lim.toml"),
    law: tune,
};

fn tune(entry: &'static Entry, process: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let names = [
        ("T", Unit::Second),
        ("k1", Unit::Ratio),
        ("k2", Unit::PerSecond),
        ("k3", Unit::PerSecondSquared),
        ("k4", Unit::PerSecond),
        ("a1", Unit::Second),
        ("a2", Unit::SecondSquared),
    ];
    compensated(entry, process, values, &names, |of| CompensatorLaw::TwoDegree {
        setpoint_time: of("T"),
        a1: of("a1"),
        a2: of("a2"),
    })
}
