//! Matausek-Micic modified Smith predictor.
//!
//! # Applies to
//! The plain integrator with dead time; the model is `K e^(-d s)/s`.
//!
//! # Formula
//! `Kr = 1/(K*Tr)`. `u = v - K0 (y - y_m)`, `v = Kr (r - y_p - (y - y_m))`, `y_p = K v/s`, `y_m` = `y_p` one dead
//! time ago. Exact: `y/r = e^(-d s)/(Tr s + 1)` and `S = [1 - e^(-d s)/(Tr s + 1)] s/(s + K K0 e^(-d s))`.
//!
//! # Parameters
//! `Tr` [s], default d: time of the setpoint response; `K0` [input/output unit], default 1/(2*K*d): gain on the
//! prediction error.
//!
//! # When
//! Setpoint steps without overshoot behind a long dead time, and loads without lasting error.
//!
//! # Limits
//! The load response is set by K0 alone and the loop K K0 e^(-d s)/s must be stable: K0 below pi/(2 K d). A
//! model that differs costs robustness on both sides: a fast setpoint response fails for a shorter dead time as
//! for a longer one.
//!
//! # Published values
//! `90 - K*K0*d*180/pi` = 61.3: the phase margin of the K0 loop in degrees, as remembered; exactly 61.352.
//!
//! # Reference
//! Matausek, Micic (1996). A modified Smith predictor for controlling a process with an integrator and long
//! dead-time, IEEE Trans. Automat. Control 41, 1199-1203. Provenance: from memory: no source was read; the
//! identities were derived again here.

use crate::model::{CompensatorLaw, Process};
use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Provenance, RuleError, Status, Tuning, Unit, Values,
    compensated,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "msp-matausek-micic-1996",
    name: "Matausek-Micic modified Smith predictor",
    authors: "Matausek, Micic",
    year: 1996,
    citation: "A modified Smith predictor for controlling a process with an integrator and long \
        dead-time, IEEE Trans. Automat. Control 41, 1199-1203",
    structure: "SP+DOB",
    process: Applies::Integrating,
    form: Form::Compensator,
    parameters: &[
        Parameter::new("Tr", Unit::Second, Default::Formula("d"), "time of the setpoint response"),
        Parameter::new("K0", Unit::Gain, Default::Formula("1/(2*K*d)"), "gain on the prediction error")
            .range("> 0 and < pi/(2*K*d)"),
    ],
    formula: &[("Kr", "1/(K*Tr)")],
    when: "Setpoint steps without overshoot behind a long dead time, and loads without lasting \
        error.",
    limits: "The load response is set by K0 alone and the loop K K0 e^(-d s)/s must be stable: K0 \
        below pi/(2 K d). A model that differs costs robustness on both sides: a fast setpoint \
        response fails for a shorter dead time as for a longer one.",
    validity: &[],
    provenance: Provenance::MemoryRederived,
    source: "from memory: no source was read; the identities were derived again here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/msp-matausek-micic-1996.toml"),
    law: tune,
};

fn tune(entry: &'static Entry, process: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let names = [("Kr", Unit::Gain), ("K0", Unit::Gain)];
    compensated(entry, process, values, &names, |of| CompensatorLaw::ModifiedSmith {
        main_gain: of("Kr"),
        disturbance_gain: of("K0"),
        lead: None,
    })
}
