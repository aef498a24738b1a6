//! PI control that meets a gain margin and a phase margin exactly.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! None: solved at the phase crossover p/d, where `Ti = d*tan(p)/p` and `K*Kc = p*sin(p)/(GM*d)`.
//!
//! # Parameters
//! `GM`, default 3: gain margin. `PM_deg` [deg], default 45: phase margin, below 90 (1 - 1/GM).
//!
//! # When
//! PI with a stated robustness.
//!
//! # Limits
//! The phase margin must be below 90° (1 - 1/GM), that of P control with the same gain margin.
//!
//! # Published values
//! The promise of the rule, gain margin 3 and phase margin 45°.
//!
//! # Reference
//! The region is that of Wang, Rees, Zhong (2006), Control of integral processes with dead time Part IV: various
//! issues about PI controllers, IEE Proc. Control Theory Appl. 153, 302-306; derived here.

use crate::tuning::exact;
use crate::tuning::{Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-gpm-exact",
    name: "PI that meets a gain margin and a phase margin",
    authors: "Wang, Rees, Zhong (region); Kookos; Hu, Xiao",
    year: 2006,
    citation: "Control of integral processes with dead time Part IV: various issues about PI controllers, IEE Proc. \
               Control Theory Appl. 153 (2006) 302-306",
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
    formula: &[],
    when: "PI with a stated robustness.",
    limits: "The phase margin must be below 90° (1 - 1/GM), that of P control with the same gain margin.",
    validity: &[],
    provenance: Provenance::Derived,
    source: "derived here",
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
    fn both_margins_are_met_up_to_the_limit_and_not_beyond() {
        let process = Process::integrating(-0.2, Seconds(7.4)).unwrap();
        let rule = rule("pi-gpm-exact").unwrap();
        for gain_margin in [1.2, 2.0, 3.0, 6.0] {
            let limit = 90.0 * (1.0 - 1.0 / gain_margin);
            for part in [0.1, 0.5, 0.9, 0.999] {
                let set = Parameters::new().set("GM", gain_margin).set("PM_deg", part * limit);
                let found =
                    margins(&ClosedLoop::new(&process, &rule.tune(&process, &set).unwrap().controller))
                        .unwrap();
                assert!((found.gain_margin.unwrap() - gain_margin).abs() < 1e-9);
                assert!((found.phase_margin.unwrap().degrees() - part * limit).abs() < 1e-7);
            }
            let beyond = Parameters::new().set("GM", gain_margin).set("PM_deg", limit);
            assert!(matches!(rule.tune(&process, &beyond), Err(RuleError::Infeasible(_))));
        }
    }
}
