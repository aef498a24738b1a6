//! Normey-Rico-Camacho filtered Smith predictor.
//!
//! # Applies to
//! The plain integrator with dead time; the model is `K e^(-d s)/s`.
//!
//! # Formula
//! `C = 1/(K*T0)`, `beta = T0 + Tf + d`, `a1 = T0 + Tf`, `a2 = T0*Tf`. Primary control C on the prediction,
//! predictor filter `Fr = (beta s + 1)/(Tf s + 1)`. Exact: the complementary sensitivity is `(beta s + 1) e^(-d
//! s)/((T0 s + 1)(Tf s + 1))`, and `y/r = e^(-d s)/(T0 s + 1)`.
//!
//! # Parameters
//! `T0` [s], default d: time of the primary loop and of the setpoint response; `Tf` [s], default 2*d: time of
//! the predictor's filter.
//!
//! # When
//! A Smith predictor with P primary control; Tf buys robustness without slowing the setpoint response.
//!
//! # Limits
//! The same loop as dob-zhong-normey-rico at T0 = Tf = lam. The predictor must be run in its stable form: with
//! separate integrators for process and model a constant load drives them apart.
//!
//! # Published values
//! None: no source with values was retrieved.
//!
//! # Reference
//! Normey-Rico, Camacho (2002). A unified approach to design dead-time compensators for stable and integrative
//! processes with dead-time, IEEE Trans. Automat. Control 47, 299-305; Control of Dead-time Processes (Springer
//! 2007). Provenance: from memory: no source was read; the identities were derived again here.

use crate::model::{CompensatorLaw, Process};
use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Provenance, RuleError, Status, Tuning, Unit, Values,
    compensated,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "sp-fsp-normey-rico",
    name: "Normey-Rico-Camacho filtered Smith predictor",
    authors: "Normey-Rico, Camacho",
    year: 2002,
    citation: "A unified approach to design dead-time compensators for stable and integrative processes \
        with dead-time, IEEE Trans. Automat. Control 47, 299-305; Control of Dead-time Processes \
        (Springer 2007)",
    structure: "2DOF-DTC",
    process: Applies::Integrating,
    form: Form::Compensator,
    parameters: &[
        Parameter::new(
            "T0",
            Unit::Second,
            Default::Formula("d"),
            "time of the primary loop and of the setpoint response",
        ),
        Parameter::new("Tf", Unit::Second, Default::Formula("2*d"), "time of the predictor's filter"),
    ],
    formula: &[("C", "1/(K*T0)"), ("beta", "T0 + Tf + d"), ("a1", "T0 + Tf"), ("a2", "T0*Tf")],
    when: "A Smith predictor with P primary control; Tf buys robustness without slowing the \
        setpoint response.",
    limits: "The same loop as dob-zhong-normey-rico at T0 = Tf = lam. The predictor must be run in \
        its stable form: with separate integrators for process and model a constant load drives \
        them apart.",
    validity: &[],
    provenance: Provenance::MemoryRederived,
    source: "from memory: no source was read; the identities were derived again here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/sp-fsp-normey-rico.toml"),
    law: tune,
};

fn tune(entry: &'static Entry, process: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let names = [
        ("C", Unit::Gain),
        ("T0", Unit::Second),
        ("Tf", Unit::Second),
        ("beta", Unit::Second),
        ("a1", Unit::Second),
        ("a2", Unit::SecondSquared),
    ];
    compensated(entry, process, values, &names, |of| CompensatorLaw::TwoDegree {
        setpoint_time: of("T0"),
        a1: of("a1"),
        a2: of("a2"),
    })
}
