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

use std::f64::consts::FRAC_PI_2;

use crate::model::Process;
use crate::tuning::{
    Applies, Default, Entry, Form, Infeasible, Parameter, Property, Provenance, RuleError, Specification,
    Status, Tuning, Unit, Values, from_settings,
};

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
    law: tune,
};

fn tune(entry: &'static Entry, _: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let mut values = values.clone();
    let (k, d) = (values.get("K")?, values.get("d")?);
    let (gain_margin, phase_margin) = (values.get("GM")?, values.get("PM_deg")?.to_radians());
    let limit = FRAC_PI_2 * (1.0 - 1.0 / gain_margin);
    if phase_margin >= limit {
        let asked = values.specification();
        let reason = format!(
            "PI control with gain margin {gain_margin} has a phase margin below {:.4}°, that of P control",
            limit.to_degrees()
        );
        // The limit is never reached: a ten-thousandth of it is left.
        let nearest = Specification { phase_margin: Some(limit * (1.0 - 1e-4)), ..asked };
        let infeasible = Infeasible { rule: entry.id, asked, reason, nearest: vec![nearest] };
        return Err(RuleError::Infeasible(Box::new(infeasible)));
    }
    // Along the loops of one gain margin the phase margin rises with the phase crossover, from 0 at 0 (Ti = d) to
    // the limit of P control at π/2 (Ti = ∞): the root is unique.
    let (mut low, mut high) = (0.0, FRAC_PI_2);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if phase_margin_at(middle, gain_margin) < phase_margin { low = middle } else { high = middle }
    }
    let (loop_gain, integral_time) = settings(low, gain_margin);
    values.keep("Kc", loop_gain / (k * d));
    values.keep("Ti", integral_time * d);
    from_settings(entry, &values)
}

/// Loop gain K·Kc·d and Ti/d of the PI loop with this phase crossover [1/d] and gain margin.
fn settings(crossover: f64, gain_margin: f64) -> (f64, f64) {
    (crossover * crossover.sin() / gain_margin, crossover.tan() / crossover)
}

/// Phase margin [rad] of that loop.
fn phase_margin_at(crossover: f64, gain_margin: f64) -> f64 {
    let (k, ti) = settings(crossover, gain_margin);
    // |L| = 1: w⁴ = k²·(w² + 1/Ti²).
    let w = (0.5 * k * (k + k.hypot(2.0 / ti))).sqrt();
    (ti * w).atan() - w
}

#[cfg(test)]
mod tests {
    use super::{FRAC_PI_2, phase_margin_at};
    use crate::model::{Process, Seconds};
    use crate::tuning::{Parameters, RuleError, rule};

    #[test]
    fn phase_margin_rises_with_the_phase_crossover_up_to_that_of_proportional_control() {
        for gain_margin in [1.001, 1.1, 1.5, 2.0, 3.0, 5.0, 20.0, 1000.0] {
            let margin = |i: u32| phase_margin_at(FRAC_PI_2 * f64::from(i) / 1001.0, gain_margin);
            assert!((11..=1000).all(|i| margin(i) > margin(i - 1)), "{gain_margin}");
            let limit = FRAC_PI_2 * (1.0 - 1.0 / gain_margin);
            assert!(margin(10) > 0.0 && margin(1000) < limit, "{gain_margin}");
        }
    }

    #[test]
    fn a_phase_margin_from_the_limit_of_proportional_control_on_is_infeasible_and_one_below_it_is_met() {
        let process = Process::integrating(-0.3, Seconds(2.0)).unwrap();
        let ask = |pm: f64| {
            rule("pi-gpm-exact").unwrap().tune(&process, &Parameters::new().set("GM", 2.0).set("PM_deg", pm))
        };
        for beyond in [45.0, 60.0] {
            let Err(RuleError::Infeasible(answer)) = ask(beyond) else { panic!("{beyond}") };
            let near = answer.nearest[0].phase_margin.unwrap().to_degrees();
            assert!(near < 45.0 && ask(near).is_ok());
        }
        assert!(ask(44.99).unwrap().controller.integral_time().unwrap() > 1000.0);
        assert!(ask(0.01).unwrap().controller.integral_time().unwrap() > 2.0);
    }
}
