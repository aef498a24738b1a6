//! First-order linear active disturbance rejection.
//!
//! # Applies to
//! The plain integrator with dead time; the model is `K e^(-d s)/s`.
//!
//! # Formula
//! `Kc = (2*wc*wo + wo^2)/(K*(2*wo + wc))`, `Ti = (2*wc + wo)/(wc*wo)`, `Tf = 1/(2*wo + wc)`. From y to u this
//! is the PI controller Kc, Ti with its output filtered by 1/(Tf s + 1); the setpoint enters by the control law
//! only.
//!
//! # Parameters
//! `wc` [rad/s], default 0.25/d: bandwidth of the control; `wo` [rad/s], default 0.5/d: bandwidth of the
//! observer.
//!
//! # When
//! To see what active disturbance rejection is on this process: a PI controller with a filter.
//!
//! # Limits
//! It knows no dead time: wo = 2/d with wc = 0.25/d is unstable.
//!
//! # Published values
//! None: no rule for this process was found.
//!
//! # Reference
//! Gao; Herbst (2003). Z. Gao, Scaling and bandwidth-parameterization based controller tuning, ACC 2003.
//! Provenance: derived here; the defaults are no one's rule.

use crate::model::{CompensatorLaw, Process};
use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Provenance, RuleError, Status, Tuning, Unit, Values,
    compensated,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "ladrc1",
    name: "First-order linear active disturbance rejection",
    authors: "Gao; Herbst",
    year: 2003,
    citation: "Z. Gao, Scaling and bandwidth-parameterization based controller tuning, ACC 2003",
    structure: "ADRC",
    process: Applies::Integrating,
    form: Form::Compensator,
    parameters: &[
        Parameter::new("wc", Unit::RadianPerSecond, Default::Formula("0.25/d"), "bandwidth of the control"),
        Parameter::new("wo", Unit::RadianPerSecond, Default::Formula("0.5/d"), "bandwidth of the observer"),
    ],
    formula: &[
        ("Kc", "(2*wc*wo + wo^2)/(K*(2*wo + wc))"),
        ("Ti", "(2*wc + wo)/(wc*wo)"),
        ("Tf", "1/(2*wo + wc)"),
    ],
    when: "To see what active disturbance rejection is on this process: a PI controller with a \
        filter.",
    limits: "It knows no dead time: wo = 2/d with wc = 0.25/d is unstable.",
    validity: &[],
    provenance: Provenance::Derived,
    source: "derived here; the defaults are no one's rule",
    status: Status::History(
        "the structure only: no rule for this process was found, and the defaults are no one's rule",
    ),
    values: include_str!("../../../tests/rules/ladrc1.toml"),
    law: tune,
};

fn tune(entry: &'static Entry, process: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let names = [
        ("Kc", Unit::Gain),
        ("Ti", Unit::Second),
        ("Tf", Unit::Second),
        ("wc", Unit::RadianPerSecond),
        ("wo", Unit::RadianPerSecond),
    ];
    compensated(entry, process, values, &names, |of| CompensatorLaw::DisturbanceRejection {
        controller_bandwidth: of("wc"),
        observer_bandwidth: of("wo"),
    })
}
