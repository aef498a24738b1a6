//! PI control with a stated gain margin and a stated phase margin.
//!
//! In units of the dead time `L = a·(1 + τ·s)·e^(−s)/(τ·s²)`. At the phase crossover p in (0, π/2) the phase condition is
//! `τ = tan(p)/p`, and the gain margin gives `a = p·sin(p)/GM`. The gain crossover g is the positive root of
//! `g⁴ − a²·g² − a²/τ² = 0`. Along these loops the phase margin rises with p, from 0 at p = 0 (τ = 1) to that of P
//! control, 90°·(1 − 1/GM), at p = π/2 (τ = ∞): a pair below that limit has one loop, and one beyond it none.

use std::f64::consts::FRAC_PI_2;

use super::root::bracket;
use crate::model::Process;
use crate::tuning::{Entry, Infeasible, RuleError, Specification, Tuning, Values, from_settings};

/// The tuning of the rule.
pub(in crate::tuning) fn tune(
    entry: &'static Entry,
    _: &Process,
    values: &Values<'_>,
) -> Result<Tuning, RuleError> {
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
    let (crossover, _) =
        bracket(
            0.0,
            FRAC_PI_2,
            0.0,
            |p| if p == 0.0 { -1.0 } else { margin_at(p, gain_margin) - phase_margin },
        );
    let (loop_gain, integral_time) = settings(crossover, gain_margin);
    values.keep("Kc", loop_gain / (k * d));
    values.keep("Ti", integral_time * d);
    from_settings(entry, &values)
}

/// a and τ of the loop with this phase crossover and gain margin.
fn settings(crossover: f64, gain_margin: f64) -> (f64, f64) {
    (crossover * crossover.sin() / gain_margin, crossover.tan() / crossover)
}

/// Phase margin [rad] of that loop.
fn margin_at(crossover: f64, gain_margin: f64) -> f64 {
    let (a, tau) = settings(crossover, gain_margin);
    let g = (0.5 * a * (a + a.hypot(2.0 / tau))).sqrt();
    (tau * g).atan() - g
}

#[cfg(test)]
mod tests {
    use super::{FRAC_PI_2, margin_at};

    #[test]
    fn phase_margin_rises_with_the_phase_crossover_up_to_that_of_proportional_control() {
        for gain_margin in [1.001, 1.1, 1.5, 2.0, 3.0, 5.0, 20.0, 1000.0] {
            let margin = |i: u32| margin_at(FRAC_PI_2 * f64::from(i) / 1001.0, gain_margin);
            assert!((11..=1000).all(|i| margin(i) > margin(i - 1)), "{gain_margin}");
            let limit = FRAC_PI_2 * (1.0 - 1.0 / gain_margin);
            assert!(margin(10) > 0.0 && margin(1000) < limit, "{gain_margin}");
        }
    }
}
