//! Matausek-Micic modified Smith predictor with derivative.
//!
//! # Applies to
//! The plain integrator with dead time; the model is `K e^(-d s)/s`.
//!
//! # Formula
//! `gap = (90 - phi_pm_deg)*pi/180`, `K0 = gap/(K*d*sqrt((1 - alpha)^2 + (alpha*gap)^2))`, `Td = alpha*d`, `Tf
//! = Td/10`, `Kr = 1/(K*Tr)`. As msp-matausek-micic-1996 with `K0 (Td s + 1)/(Tf s + 1)` in place of K0.
//!
//! # Parameters
//! `alpha` [–], default 0.4: lead time over dead time; `phi_pm_deg` [deg], default 64.0: phase margin asked of
//! the loop of K0 and its lead; `Tr` [s], default d: time of the setpoint response.
//!
//! # When
//! As msp-matausek-micic-1996 where loads must be rejected faster and the measurement allows a derivative.
//!
//! # Limits
//! The formula takes atan x for x and leaves Tf out of the phase: the phase margin of the K0 loop is not quite
//! the one asked for, and that of the whole loop is another. The lead multiplies the noise gain of K0 by ten.
//!
//! # Published values
//! None: no source with values was retrieved.
//!
//! # Reference
//! Matausek, Micic (1999). On the modified Smith predictor for controlling a process with an integrator and
//! long dead-time, IEEE Trans. Automat. Control 44, 1603-1606. Provenance: from memory: no source was read; the
//! identities were derived again here.

use crate::model::{CompensatorLaw, Lead, Process};
use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Provenance, RuleError, Status, Tuning, Unit, Values,
    compensated,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "msp-matausek-micic-1999",
    name: "Matausek-Micic modified Smith predictor with derivative",
    authors: "Matausek, Micic",
    year: 1999,
    citation: "On the modified Smith predictor for controlling a process with an integrator and long \
        dead-time, IEEE Trans. Automat. Control 44, 1603-1606",
    structure: "SP+DOB",
    process: Applies::Integrating,
    form: Form::Compensator,
    parameters: &[
        Parameter::new("alpha", Unit::Ratio, Default::Number(0.4), "lead time over dead time")
            .range("0..0.5"),
        Parameter::new(
            "phi_pm_deg",
            Unit::Degree,
            Default::Number(64.0),
            "phase margin asked of the loop of K0 and its lead",
        )
        .range("40..75"),
        Parameter::new("Tr", Unit::Second, Default::Formula("d"), "time of the setpoint response"),
    ],
    formula: &[
        ("gap", "(90 - phi_pm_deg)*pi/180"),
        ("K0", "gap/(K*d*sqrt((1 - alpha)^2 + (alpha*gap)^2))"),
        ("Td", "alpha*d"),
        ("Tf", "Td/10"),
        ("Kr", "1/(K*Tr)"),
    ],
    when: "As msp-matausek-micic-1996 where loads must be rejected faster and the measurement \
        allows a derivative.",
    limits: "The formula takes atan x for x and leaves Tf out of the phase: the phase margin of the \
        K0 loop is not quite the one asked for, and that of the whole loop is another. The lead \
        multiplies the noise gain of K0 by ten.",
    validity: &[],
    provenance: Provenance::MemoryRederived,
    source: "from memory: no source was read; the identities were derived again here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/msp-matausek-micic-1999.toml"),
    law: tune,
};

fn tune(entry: &'static Entry, process: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let names = [("Kr", Unit::Gain), ("K0", Unit::Gain), ("Td", Unit::Second), ("Tf", Unit::Second)];
    compensated(entry, process, values, &names, |of| CompensatorLaw::ModifiedSmith {
        main_gain: of("Kr"),
        disturbance_gain: of("K0"),
        lead: (of("Td") > 0.0).then(|| Lead { derivative_time: of("Td"), filter_time: of("Tf") }),
    })
}
