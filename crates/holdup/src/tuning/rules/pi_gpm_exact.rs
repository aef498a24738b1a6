//! Exact gain/phase margin assignment, PI on IPDT (numeric).
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Ti = tan(wp*d)/wp`, `Kc = wp*sin(wp*d)/(K*GM)`. The phase crossover `wp` [rad/s] is the unknown: these two lines
//! give every wp the gain margin GM, and `PM = atan(Ti*wg) - wg*d` at the gain crossover wg selects it.
//!
//! # Parameters
//! `GM`, default 3: gain margin (must be > 1).
//! `PM_deg` [deg], default 45: phase margin (must be > 0 and < 90).
//!
//! # When
//! A gain margin and a phase margin that must both be met exactly.
//!
//! # Limits
//! The phase margin must be below 90 (1 - 1/GM) deg, the limit of P control, which Ti = infinity would meet. Both
//! margins say nothing of the speed: near the limit the integral is very slow.
//!
//! # Published values
//! Gain and phase margin as asked for, of three pairs.
//!
//! # Reference
//! Wang, Rees, Zhong (region); Kookos; Hu-Xiao 2011 for PID (2006), Control of integral processes with dead time, Part
//! IV: various issues about PI controllers, IEE Proc. Control Theory Appl. 153, 302-306. Derived here.

use crate::tuning::exact;
use crate::tuning::{Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-gpm-exact",
    name: "Exact gain/phase margin assignment, PI on IPDT (numeric)",
    authors: "Wang, Rees, Zhong (region); Kookos; Hu-Xiao 2011 for PID",
    year: 2006,
    citation: "Control of integral processes with dead time, Part IV: various issues about PI \
               controllers, IEE Proc. Control Theory Appl. 153, 302-306",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[
        Parameter::new("GM", Unit::Ratio, Default::Number(3.0), "gain margin")
            .range("> 1")
            .asks(Property::GainMargin),
        Parameter::new("PM_deg", Unit::Degree, Default::Number(45.0), "phase margin")
            .range("> 0 and < 90")
            .asks(Property::PhaseMargin),
    ],
    formula: &[("Ti", "tan(wp*d)/wp"), ("Kc", "wp*sin(wp*d)/(K*GM)")],
    when: "A gain margin and a phase margin that must both be met exactly.",
    limits: "The phase margin must be below 90 (1 - 1/GM) deg, the limit of P control, which Ti = \
             infinity would meet. Both margins say nothing of the speed: near the limit the integral is \
             very slow.",
    validity: &[],
    provenance: Provenance::Derived,
    source: "the two margin conditions, solved here to rounding",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-gpm-exact.toml"),
    law: exact::pi,
};

#[cfg(test)]
mod tests {
    use crate::analysis::frequency::margins;
    use crate::model::{ClosedLoop, Process, Seconds};
    use crate::tuning::{Parameters, RuleError, rule};

    #[test]
    fn both_margins_are_met_up_to_the_limit_of_proportional_control_and_infeasible_from_it_on() {
        let process = Process::integrating(-0.2, Seconds(7.4)).unwrap();
        for gain_margin in [1.2, 2.0, 3.0, 6.0] {
            let ask = |phase: f64| {
                let set = Parameters::new().set("GM", gain_margin).set("PM_deg", phase);
                rule("pi-gpm-exact").unwrap().tune(&process, &set)
            };
            let limit = 90.0 * (1.0 - 1.0 / gain_margin);
            for part in [1e-3, 0.1, 0.5, 0.9, 0.999] {
                let found =
                    margins(&ClosedLoop::new(&process, &ask(part * limit).unwrap().controller)).unwrap();
                // Two roots solved to rounding, a flat one where the phase margin is small.
                assert!((found.gain_margin.unwrap() - gain_margin).abs() < 1e-9, "{part}");
                assert!((found.phase_margin.unwrap().degrees() - part * limit).abs() < 1e-7, "{part}");
            }
            for beyond in [limit, 0.5 * (limit + 90.0)] {
                let Err(RuleError::Infeasible(answer)) = ask(beyond) else { panic!("{beyond}") };
                assert!(ask(answer.nearest[0].phase_margin.unwrap().to_degrees()).is_ok());
            }
        }
    }
}
