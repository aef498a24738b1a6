//! Huba P with inverse-model disturbance observer.
//!
//! # Applies to
//! The plain integrator with dead time; the model is `K e^(-d s)/s`.
//!
//! # Formula
//! `u = Kc (r - y) - D`, `D = ((s/K) y - e^(-d s) u)/(Tf s + 1)`; the default of Kc puts the double real pole.
//! Exact: `S = S_p (1 - e^(-d s)/(Tf s + 1))` with `S_p` that of the P loop.
//!
//! # Parameters
//! `Tf` [s], default d: time of the observer's filter; `Kc` [input/output unit], default 1/(exp(1)*K*d):
//! proportional gain.
//!
//! # When
//! P control of the setpoint, to which a load estimate is added without touching the setpoint response.
//!
//! # Limits
//! A small Tf has a noise gain of 1/(K Tf) and a small margin against a shorter dead time.
//!
//! # Published values
//! None: no source with values was retrieved.
//!
//! # Reference
//! Huba (2013). Performance measures, performance limits and dead time control for the integral plants, J.
//! Process Control 23 (2013) 976-989; Comparing 2DOF PI and predictive disturbance observer based filtered PI
//! control, J. Process Control 23, 1379-1400. Provenance: from memory: no source was read; the identities were
//! derived again here.

use crate::model::{CompensatorLaw, Process};
use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Provenance, RuleError, Status, Tuning, Unit, Values,
    compensated,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "dob-huba-p",
    name: "Huba P with inverse-model disturbance observer",
    authors: "Huba",
    year: 2013,
    citation: "Performance measures, performance limits and dead time control for the integral plants, \
        J. Process Control 23 (2013) 976-989; Comparing 2DOF PI and predictive disturbance \
        observer based filtered PI control, J. Process Control 23, 1379-1400",
    structure: "P+inverse-DOB",
    process: Applies::Integrating,
    form: Form::Compensator,
    parameters: &[
        Parameter::new("Tf", Unit::Second, Default::Formula("d"), "time of the observer's filter"),
        Parameter::new("Kc", Unit::Gain, Default::Formula("1/(exp(1)*K*d)"), "proportional gain")
            .range("> 0 and < pi/(2*K*d)"),
    ],
    formula: &[],
    when: "P control of the setpoint, to which a load estimate is added without touching the \
        setpoint response.",
    limits: "A small Tf has a noise gain of 1/(K Tf) and a small margin against a shorter dead time.",
    validity: &[],
    provenance: Provenance::MemoryRederived,
    source: "from memory: no source was read; the identities were derived again here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/dob-huba-p.toml"),
    law: tune,
};

fn tune(entry: &'static Entry, process: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let names = [("Kc", Unit::Gain), ("Tf", Unit::Second)];
    compensated(entry, process, values, &names, |of| CompensatorLaw::InverseModel {
        main_gain: of("Kc"),
        filter_time: of("Tf"),
    })
}
