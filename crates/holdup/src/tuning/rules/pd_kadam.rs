//! Kadam's PD controller from settling time, gain margin and phase margin.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `w_pc = 2*pi/Ts`, `w_gc = 4*pi/Ts` (equation 13), `Td = abs(tan(phi_m + w_gc*d - pi/2))/w_gc` (equation 9, "ignore
//! the negative sign"), `Kc = w_pc/(K*Am*sqrt(1 + (Td*w_pc)^2))` (equation 12).
//!
//! # Parameters
//! `Ts` [s], default 20·d/3: settling time. `Am`, default 2: gain margin. `phi_m` [rad], default π: phase margin.
//!
//! # When
//! To recompute the paper, or as a mild PD tuning near its defaults; pd-exact really meets a specification.
//!
//! # Limits
//! The specified margins are not achieved: equation 13 puts the gain crossover above the phase crossover, which no
//! PD loop has. For Ts > 8 d at the default phase margin Td comes out negative and its sign is dropped. A load
//! disturbance leaves a lasting error.
//!
//! # Published values
//! Kc = 1.5321, Td = 1.0343 s for K = 0.0506, d = 6 s, Ts = 40 s.
//!
//! # Reference
//! S. D. Kadam, Disturbance Observer based Control of Integrating Processes with Dead-Time using PD controller,
//! arXiv 1711.11250 (2017), equations 9, 12 and 13.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::model::Process;
use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, RuleError, Status, Tuning, Unit, Values,
    by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pd-kadam",
    name: "Kadam PD from settling time, gain margin and phase margin",
    authors: "Kadam",
    year: 2017,
    citation: "Disturbance Observer based Control of Integrating Processes with Dead-Time using PD controller, \
               arXiv 1711.11250, equations 9, 12, 13",
    structure: "PD",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &PARAMETERS,
    formula: &FORMULA,
    when: "To recompute the paper, or as a mild PD tuning near its defaults; pd-exact really meets a specification.",
    limits: "The specified margins are not achieved: equation 13 puts the gain crossover above the phase crossover, \
             which no PD loop has. For Ts > 8 d at the default phase margin Td comes out negative and its sign is \
             dropped. A load disturbance leaves a lasting error.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "the paper's LaTeX source",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pd-kadam.toml"),
    law: tune,
};

/// Parameters, which the rule with observer shares.
pub(super) const PARAMETERS: [Parameter; 3] = [
    Parameter::new("Ts", Unit::Second, Default::Formula("20*d/3"), "settling time")
        .asks(Property::SettlingTime),
    Parameter::new("Am", Unit::Ratio, Default::Number(2.0), "gain margin")
        .range(">= 1")
        .asks(Property::GainMargin),
    Parameter::new("phi_m", Unit::Radian, Default::Number(PI), "phase margin")
        .range("any")
        .asks(Property::PhaseMargin),
];

/// Formula, which the rule with observer shares.
pub(super) const FORMULA: [(&str, &str); 4] = [
    ("w_pc", "2*pi/Ts"),
    ("w_gc", "4*pi/Ts"),
    ("Td", "abs(tan(phi_m + w_gc*d - pi/2))/w_gc"),
    ("Kc", "w_pc/(K*Am*sqrt(1 + (Td*w_pc)^2))"),
];

fn tune(entry: &'static Entry, process: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let mut tuning = by_formula(entry, process, values)?;
    tuning.warnings.extend(remarks(values)?);
    Ok(tuning)
}

/// What the paper does not say about its specification, and the rule with observer repeats.
pub(super) fn remarks(values: &Values<'_>) -> Result<Vec<String>, RuleError> {
    let (d, ts, am, phi_m) = (values.get("d")?, values.get("Ts")?, values.get("Am")?, values.get("phi_m")?);
    let w_gc = 4.0 * PI / ts;
    let td = (phi_m + w_gc * d - FRAC_PI_2).tan() / w_gc;
    let mut remarks = Vec::new();
    if td < 0.0 {
        remarks.push(format!(
            "equation 9 gives Td = {td} s; the sign is dropped as the paper says, and the phase margin specification \
             is thereby not met"
        ));
    }
    if td.abs() > 1e6 * d {
        remarks.push("equation 9 stands at a pole of the tangent: Td has no meaning here".to_owned());
    }
    let (low, high) = (FRAC_PI_2 * (1.0 - 1.0 / am), FRAC_PI_2 + (1.0 / am).asin());
    if phi_m < low || phi_m >= high {
        remarks.push(format!(
            "no PD controller has gain margin {am} together with phase margin {:.4}°: from {:.4}° to {:.4}° is \
             possible (see pd-exact)",
            phi_m.to_degrees(),
            low.to_degrees(),
            high.to_degrees()
        ));
    }
    Ok(remarks)
}

#[cfg(test)]
mod tests {
    use crate::model::{Process, Seconds};
    use crate::tuning::{Parameters, RuleError, Tuning, rule};

    fn tune(ts: f64) -> Result<Tuning, RuleError> {
        let process = Process::integrating(0.0506, Seconds(6.0)).unwrap();
        rule("pd-kadam")?.tune(&process, &Parameters::new().set("Ts", ts))
    }

    #[test]
    fn dropping_the_sign_of_td_is_said() {
        let below = tune(47.9).unwrap();
        assert!(!below.warnings.iter().any(|w| w.contains("sign is dropped")), "{:?}", below.warnings);
        let above = tune(48.1).unwrap();
        assert!(above.warnings.iter().any(|w| w.contains("phase margin specification is thereby not met")));
        assert!(above.controller.derivative_time().unwrap() > 0.0);
    }

    #[test]
    fn an_impossible_pair_of_margins_is_said() {
        let warnings = tune(40.0).unwrap().warnings;
        assert!(warnings[0].contains("from 45.0000° to 120.0000° is possible"), "{warnings:?}");
    }

    #[test]
    fn absurd_settling_times_give_an_error_or_a_controller_but_no_panic() {
        for ts in [f64::MIN_POSITIVE, 1e-300, 24.0, 1e300, f64::MAX] {
            let _ = tune(ts);
        }
        assert!(tune(0.0).is_err() && tune(-1.0).is_err() && tune(f64::NAN).is_err());
    }
}
