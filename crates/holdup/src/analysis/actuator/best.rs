//! The best that any controller can do within the limits, on the plain integrator with dead time.
//!
//! # After a load step l at time 0
//! The output runs away at the rate K·l from d on. It shows then for the first time, so the earliest answer acts at 2d:
//! no controller keeps the peak below K·|l|·d. From there the output of the process returns at most at the rate K·m,
//! where m is what the actuator has left beyond the load: `(rest − low) − l` against a positive load,
//! `(high − rest) − |l|` against a negative one. So `|y| ≥ K·(|l|·d − m·(t − 2d))`, and y is back after d·|l|/m. The
//! actuator at its limit from d until one dead time before that, then at `rest − l`, attains it (the load is known as
//! soon as it shows, without noise): bang-bang with one switch. With `T = d·|l|/m`, P = K·|l|·d:
//! - back at rest at 2d + T
//! - IAE = P·d/2 + P·T/2
//! - ISE = P²·d/3 + P²·T/3
//! - ITAE = (5/6)·P·d² + P·(d·T + T²/6)
//!
//! # After a setpoint step s at time 0
//! The output stays for one dead time and then moves at most at the rate K·v, v being what the actuator has left from
//! rest towards the side that s/K asks for. With `T = |s|/(K·v)`: at the setpoint at d + T, IAE = |s|·(d + T/2),
//! ISE = s²·(d + T/3), ITAE = |s|·(d²/2 + d·T/2 + T²/6).
//!
//! Without limits, m and v are infinite, T is 0, and these are the bounds of [`bounds`](crate::analysis::bounds).

use serde::Serialize;

use super::Actuator;
use crate::model::Process;

/// Lower bounds that hold for every controller within the limits, and are attained; absent with the reason.
///
/// Their premises are those of [`Bounds`](crate::analysis::bounds::Bounds), with a horizon that lasts until rest.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Best {
    /// Least largest deviation from the initial level [output unit], after a load step.
    pub peak: Option<f64>,
    /// Least integral of the absolute error [output unit · s].
    pub iae: Option<f64>,
    /// Least integral of the squared error [output unit² · s].
    pub ise: Option<f64>,
    /// Least integral of time times the absolute error [output unit · s²].
    pub itae: Option<f64>,
    /// Earliest time at which the error can be 0 for good [s], from the step on.
    #[serde(rename = "at_rest_s")]
    pub at_rest: Option<f64>,
    /// Why what is absent is absent.
    #[serde(skip)]
    pub reasons: Vec<String>,
}

impl Best {
    fn absent(reason: &str) -> Self {
        Self { reasons: vec![reason.to_owned()], ..Self::default() }
    }
}

/// Why there is nothing but for the plain integrator.
const OTHER: &str = "the best within limits is known for the plain integrator only: with a lag or a second integrator \
                     the fastest return is not the one of least IAE";

/// The best possible answer to a load step [input unit] at time 0.
///
/// ```
/// use holdup::analysis::actuator::{Actuator, best_after_load_step};
/// use holdup::model::{Process, Seconds};
/// let level = Process::integrating(0.05, Seconds(6.0))?;
/// let best = best_after_load_step(&level, &Actuator::new(0.0, 100.0, 40.0)?, 20.0);
/// // 20 are left beyond the load of 20: the way back is as steep as the way up.
/// assert_eq!((best.peak, best.at_rest), (Some(6.0), Some(18.0)));
/// assert_eq!(best.iae, Some(36.0));
/// # Ok::<(), holdup::model::ModelError>(())
/// ```
#[must_use]
pub fn best_after_load_step(process: &Process, actuator: &Actuator, load: f64) -> Best {
    if !process.is_plain() {
        return Best::absent(OTHER);
    }
    let (k, d) = (process.process_gain().abs(), process.dead_time());
    let l = load.abs();
    let left = if load > 0.0 { actuator.below() - l } else { actuator.above() - l };
    let peak = k * l * d;
    if left < 0.0 {
        return Best::absent("the load cannot be held: the output runs away whatever the controller does");
    }
    if left == 0.0 && l > 0.0 {
        let reason =
            "the load takes all that the actuator has: the output stays where it is after 2 dead times";
        return Best { peak: Some(peak), ..Best::absent(reason) };
    }
    let back = if l > 0.0 { d * (l / left) } else { 0.0 };
    Best {
        peak: Some(peak),
        iae: Some(0.5 * peak * (d + back)),
        ise: Some(peak * peak * (d + back) / 3.0),
        itae: Some(peak * (5.0 / 6.0 * d * d + back * (d + back / 6.0))),
        at_rest: Some(if l > 0.0 { 2.0 * d + back } else { 0.0 }),
        reasons: Vec::new(),
    }
}

/// The best possible answer to a setpoint step [output unit] at time 0.
#[must_use]
pub fn best_after_setpoint_step(process: &Process, actuator: &Actuator, step: f64) -> Best {
    if !process.is_plain() {
        return Best::absent(OTHER);
    }
    let (k, d, s) = (process.process_gain(), process.dead_time(), step.abs());
    let left = if (step > 0.0) == (k > 0.0) { actuator.above() } else { actuator.below() };
    if s == 0.0 {
        return Best {
            iae: Some(0.0),
            ise: Some(0.0),
            itae: Some(0.0),
            at_rest: Some(0.0),
            ..Best::default()
        };
    }
    if left == 0.0 {
        return Best::absent(
            "the actuator rests at the limit that would have to be passed: the output cannot move there",
        );
    }
    let way = s / (k.abs() * left);
    Best {
        peak: None,
        iae: Some(s * (d + 0.5 * way)),
        ise: Some(s * s * (d + way / 3.0)),
        itae: Some(s * (0.5 * d * d + 0.5 * d * way + way * way / 6.0)),
        at_rest: Some(d + way),
        reasons: vec!["no bound on peak: a controller may leave the output where it is".to_owned()],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::bounds::Bounds;
    use crate::analysis::response::Scenario;
    use crate::model::Seconds;
    use proptest::prelude::*;

    /// The error after a load or a setpoint step under a sequence of outputs, integrated step by step: an independent
    /// simulation of the plain integrator, whose delayed input is a list.
    fn simulated(k: f64, d: f64, outputs: &dyn Fn(f64) -> f64, load: f64, step: f64, end: f64) -> [f64; 4] {
        const STEPS: u32 = 40_000;
        let h = end / f64::from(STEPS);
        let (mut y, mut sums, mut peak) = (0.0, [0.0; 3], 0.0_f64);
        for index in 0..STEPS {
            let time = h * (f64::from(index) + 0.5);
            let input = if time > d { outputs(time - d) + load } else { 0.0 };
            let middle = y + 0.5 * h * k * input;
            let error: f64 = step - middle;
            sums[0] += h * error.abs();
            sums[1] += h * error * error;
            sums[2] += h * time * error.abs();
            y += h * k * input;
            peak = peak.max(y.abs());
        }
        [sums[0], sums[1], sums[2], peak]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn the_bang_bang_answer_attains_the_best(
            k in 0.1..3.0_f64, sign in prop::bool::ANY, d in 0.5..8.0_f64, rest in 5.0..95.0_f64, part in 0.05..0.9_f64,
        ) {
            let k = if sign { k } else { -k };
            let process = Process::integrating(k, Seconds(d)).unwrap();
            let valve = Actuator::new(0.0, 100.0, rest).unwrap();
            for load in [part * valve.below(), -part * valve.above()] {
                let best = best_after_load_step(&process, &valve, load);
                let at_rest = best.at_rest.unwrap();
                let limit = if load > 0.0 { -valve.below() } else { valve.above() };
                let outputs = |time: f64| {
                    if time < d { 0.0 } else if time < at_rest - d { limit } else { -load }
                };
                let [iae, ise, itae, peak] = simulated(k, d, &outputs, load, 0.0, 1.01 * at_rest);
                // 40 000 steps: the corners are off by half a step, the sums by a few 1e-4 of themselves.
                for (sum, best) in [(iae, best.iae), (ise, best.ise), (itae, best.itae), (peak, best.peak)] {
                    prop_assert!((sum / best.unwrap() - 1.0).abs() < 2e-3, "{sum} {best:?}");
                }
            }
            for step in [3.0, -3.0] {
                let best = best_after_setpoint_step(&process, &valve, step);
                let at_rest = best.at_rest.unwrap();
                let limit = if (step > 0.0) == (k > 0.0) { valve.above() } else { -valve.below() };
                let outputs = |time: f64| if time < at_rest - d { limit } else { 0.0 };
                let [iae, ise, itae, _] = simulated(k, d, &outputs, 0.0, step, 1.01 * at_rest);
                for (sum, best) in [(iae, best.iae), (ise, best.ise), (itae, best.itae)] {
                    prop_assert!((sum / best.unwrap() - 1.0).abs() < 2e-3, "{sum} {best:?}");
                }
            }
        }
    }

    #[test]
    fn far_limits_leave_the_bounds_that_hold_without_limits() {
        let process = Process::integrating(-2.0, Seconds(3.0)).unwrap();
        let far = Actuator::new(-1e12, 1e12, 0.0).unwrap();
        let load = Bounds::of(&process, &Scenario::unit_load_step(Seconds(90.0)).unwrap());
        let best = best_after_load_step(&process, &far, 1.0);
        // The limits are 1e12 loads away: relative differences of that size.
        let near =
            |left: Option<f64>, right: Option<f64>| (left.unwrap() / right.unwrap() - 1.0).abs() < 1e-11;
        assert!(near(best.peak, load.peak) && near(best.iae, load.iae));
        assert!(near(best.ise, load.ise) && near(best.itae, load.itae));
        let setpoint = Bounds::of(&process, &Scenario::unit_setpoint_step(Seconds(90.0)).unwrap());
        let best = best_after_setpoint_step(&process, &far, 1.0);
        assert!(
            near(best.iae, setpoint.iae) && near(best.ise, setpoint.ise) && near(best.itae, setpoint.itae)
        );
    }

    #[test]
    fn what_cannot_be_is_absent_with_its_reason() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let valve = Actuator::new(0.0, 10.0, 10.0).unwrap();
        let reason = |best: &Best| best.reasons.first().cloned().unwrap_or_default();
        assert!(reason(&best_after_load_step(&process, &valve, 11.0)).contains("cannot be held"));
        assert!(reason(&best_after_load_step(&process, &valve, -0.1)).contains("cannot be held"));
        let all = best_after_load_step(&process, &valve, 10.0);
        assert!(all.peak == Some(10.0) && all.iae.is_none() && reason(&all).contains("takes all"));
        assert!(reason(&best_after_setpoint_step(&process, &valve, 1.0)).contains("cannot move"));
        assert!(best_after_setpoint_step(&process, &valve, -1.0).iae.is_some());
        let lag = process.with_lag(Seconds(3.0)).unwrap();
        assert!(reason(&best_after_load_step(&lag, &valve, 1.0)).contains("plain integrator"));
        assert_eq!(best_after_load_step(&process, &valve, 0.0).iae, Some(0.0));
    }
}
