//! Kadam's PD controller with disturbance observer.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! PD settings as `pd-kadam`; the observer `D = Ko (y - y_m)` has `Ko = K_dob`, by default Kc.
//!
//! # Parameters
//! `Ts`, `Am`, `phi_m` as `pd-kadam`; `K_dob` [input/output unit], default the Kc found: observer gain.
//!
//! # When
//! To recompute the paper; dob-exact chooses the observer gain for a stated robustness of the whole loop.
//!
//! # Limits
//! The paper does not report the robustness that the observer costs: at its example the sensitivity peak rises from
//! 1.43 to 2.18. The observer alone is stable for Ko below pi/(2 K d).
//!
//! # Published values
//! Kc = Ko = 1.5321, Td = 1.0343 s for K = 0.0506, d = 6 s, Ts = 40 s.
//!
//! # Reference
//! S. D. Kadam, Disturbance Observer based Control of Integrating Processes with Dead-Time using PD controller,
//! arXiv 1711.11250 (2017), equations 9, 12, 13 and 16 to 22.

use std::f64::consts::FRAC_PI_2;

use super::pd_kadam;
use crate::model::Process;
use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Provenance, RuleError, Status, Tuning, Unit, Values, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "dob-kadam",
    name: "Kadam PD with disturbance observer",
    authors: "Kadam",
    year: 2017,
    citation: "Disturbance Observer based Control of Integrating Processes with Dead-Time using PD controller, \
               arXiv 1711.11250, equations 9, 12, 13, 16-22",
    structure: "PD+DOB",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[
        pd_kadam::PARAMETERS[0],
        pd_kadam::PARAMETERS[1],
        pd_kadam::PARAMETERS[2],
        Parameter::new("K_dob", Unit::Gain, Default::Formula("Kc"), "observer gain"),
    ],
    formula: &[
        pd_kadam::FORMULA[0],
        pd_kadam::FORMULA[1],
        pd_kadam::FORMULA[2],
        pd_kadam::FORMULA[3],
        ("Ko", "K_dob"),
    ],
    when: "To recompute the paper; dob-exact chooses the observer gain for a stated robustness of the whole loop.",
    limits: "The paper does not report the robustness that the observer costs: at its example the sensitivity peak \
             rises from 1.43 to 2.18. The observer alone is stable for Ko below pi/(2 K d).",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "the paper's LaTeX source",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/dob-kadam.toml"),
    law: tune,
};

fn tune(entry: &'static Entry, process: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let mut tuning = by_formula(entry, process, values)?;
    let observer_gain = tuning.controller.observer().map_or(0.0, |observer| observer.gain());
    let loop_gain = process.process_gain() * observer_gain * process.dead_time();
    if loop_gain >= FRAC_PI_2 {
        tuning.warnings.push(format!(
            "unstable: K·Ko·d = {loop_gain} is not below π/2, so the observer is unstable by itself"
        ));
    }
    tuning.warnings.extend(pd_kadam::remarks(values)?);
    Ok(tuning)
}

#[cfg(test)]
mod tests {
    use crate::model::{Process, Seconds};
    use crate::tuning::{Parameters, rule};

    #[test]
    fn observer_gain_is_the_proportional_gain_unless_set() {
        let process = Process::integrating(-0.0506, Seconds(6.0)).unwrap();
        let rule = rule("dob-kadam").unwrap();
        let by_default = rule.tune(&process, &Parameters::new()).unwrap().controller;
        assert_eq!(by_default.observer().unwrap().gain(), by_default.proportional_gain());
        let set = rule.tune(&process, &Parameters::new().set("K_dob", -0.5)).unwrap().controller;
        assert_eq!(set.observer().unwrap().gain(), -0.5);
        let wrong_sign = rule.tune(&process, &Parameters::new().set("K_dob", 0.5)).unwrap_err();
        assert!(wrong_sign.to_string().contains("sign of the process gain"), "{wrong_sign}");
    }

    #[test]
    fn an_unstable_observer_is_said() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let rule = rule("dob-kadam").unwrap();
        let unstable = |gain: f64| {
            let tuning = rule.tune(&process, &Parameters::new().set("K_dob", gain)).unwrap();
            tuning.warnings.iter().any(|warning| warning.starts_with("unstable"))
        };
        assert!(unstable(1.571) && !unstable(1.570));
    }
}
