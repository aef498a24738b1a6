//! PI control with a stated gain margin and a stated phase margin.
//!
//! In units of the dead time `L = a·(1 + τ·s)·e^(−s)/(τ·s²)`. At the phase crossover p in (0, π/2) the phase condition is
//! `τ = tan(p)/p`, and the gain margin gives `a = p·sin(p)/GM`. The gain crossover g is the positive root of
//! `g⁴ − a²·g² − a²/τ² = 0`. For p → π/2 the integral vanishes and the phase margin is that of P control, 90°·(1 − 1/GM).

use std::f64::consts::FRAC_PI_2;

use super::root::bracket;
use crate::model::Process;
use crate::tuning::{Entry, Infeasible, RuleError, Specification, Tuning, Values, from_settings};

/// The tuning of the rule.
pub(in crate::tuning) fn tune(
    entry: &'static Entry,
    process: &Process,
    values: &Values<'_>,
) -> Result<Tuning, RuleError> {
    let asked = values.specification();
    let gain_margin = values.get("GM")?;
    let phase_margin = values.get("PM_deg")?.to_radians();
    let settings = |p: f64| (p * p.sin() / gain_margin, p.tan() / p);
    let error = |p: f64| {
        let (a, tau) = settings(p);
        let square = a * a;
        let g = (0.5 * (square + (square * square + 4.0 * square / (tau * tau)).sqrt())).sqrt();
        (tau * g).atan() - g - phase_margin
    };
    let limit = FRAC_PI_2 * (1.0 - 1.0 / gain_margin);
    // The phase margin falls with p from its limit to below 0; the scan finds the first crossing, of least integral
    // action, and so of most robustness.
    let points = (1..200).map(|i| FRAC_PI_2 * (1.0 - f64::from(i) / 200.0));
    let mut above = FRAC_PI_2 * (1.0 - 1e-9);
    if phase_margin < limit && error(above) > 0.0 {
        for point in points {
            if error(point) <= 0.0 {
                let (p, _) = bracket(point, above, 0.0, error);
                let (a, tau) = settings(p);
                let (mut values, d) = (values.clone(), process.dead_time());
                values.keep("Kc", a / (values.get("K")? * d));
                values.keep("Ti", tau * d);
                return from_settings(entry, &values);
            }
            above = point;
        }
    }
    let reason = format!(
        "PI control with gain margin {gain_margin} has a phase margin below {:.4}°, that of P control",
        limit.to_degrees()
    );
    // The limit is never reached: a ten-thousandth is left to it.
    let nearest = Specification { phase_margin: Some(limit * (1.0 - 1e-4)), ..asked };
    Err(RuleError::Infeasible(Box::new(Infeasible { rule: entry.id, asked, reason, nearest: vec![nearest] })))
}
