//! What no controller beats on a process: lower bounds on IAE, ISE, ITAE and peak.
//!
//! For the first dead time after an event nobody can influence the output. After a setpoint step the error is
//! the whole step until then; after a load step the output first moves freely for one dead time, and what the best
//! controller can do from the moment it sees the load is to bring it back along the same path. The bounds hold
//! for every causal controller, linear or not, setpoint weighting and feed-forward from the setpoint included.

use serde::Serialize;

use super::response::Scenario;
use crate::model::Process;

/// Lower bounds that hold for every controller; absent, with the reason, where none is known.
///
/// ```
/// use holdup::analysis::{bounds::Bounds, response::Scenario};
/// use holdup::model::{Process, Seconds};
/// let level = Process::integrating(0.0506, Seconds(6.0))?;
/// let bounds = Bounds::of(&level, &Scenario::unit_load_step(Seconds(200.0))?);
/// assert!((bounds.ise.unwrap() - 0.0506f64.powi(2) * 216.0 / 3.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Bounds {
    /// Lower bound on the integral of the absolute error [output unit · s].
    pub iae: Option<f64>,
    /// Lower bound on the integral of the squared error [output unit² · s].
    pub ise: Option<f64>,
    /// Lower bound on the integral of time times the absolute error [output unit · s²].
    pub itae: Option<f64>,
    /// Lower bound on the largest deviation from the initial level [output unit].
    pub peak: Option<f64>,
    /// Why a bound is absent.
    #[serde(skip)]
    pub reasons: Vec<String>,
}

impl Bounds {
    /// The bounds for this process in this scenario.
    ///
    /// Their premises: at rest before the event, the setpoint not known beforehand, the load not measured, no noise,
    /// one event, a horizon of at least one dead time (setpoint) or two (load) after it.
    #[must_use]
    pub fn of(process: &Process, scenario: &Scenario) -> Self {
        let d = process.dead_time();
        let (setpoint, load) = (scenario.setpoint_moves(), scenario.load_moves());
        let (time, needed, unit, size) = match (setpoint.as_slice(), load.as_slice()) {
            ([], []) => return Self::absent("nothing happens in this scenario: all bounds are 0"),
            (&[(time, size)], []) => (time, d, setpoint_bounds(d), size.abs()),
            ([], &[(time, size)]) => (time, 2.0 * d, load_bounds(process), size.abs()),
            _ => {
                return Self::absent(
                    "no bounds: they hold for one event at a time, and this scenario has several",
                );
            }
        };
        if scenario.horizon() - time < needed * (1.0 - 4.0 * f64::EPSILON) {
            let reason =
                format!("no bounds: they need {needed} s after the event, and the horizon leaves less");
            return Self::absent(&reason);
        }
        let iae = unit.iae.map(|b| b * size);
        // Time counts from 0: the area that comes at least, at the time of the event, plus its moment about it.
        let itae = iae.zip(unit.itae).map(|(area, moment)| time * area + moment * size);
        Self {
            iae,
            ise: unit.ise.map(|b| b * size * size),
            itae,
            peak: unit.peak.map(|b| b * size),
            reasons: unit.reasons,
        }
    }

    fn absent(reason: &str) -> Self {
        Self { reasons: vec![reason.to_owned()], ..Self::default() }
    }
}

/// Unit setpoint step: the error is 1 until the dead time is over. The output moves by the whole step in the end or
/// IAE grows without bound, but nothing says so within the horizon: no bound on the peak.
fn setpoint_bounds(d: f64) -> Bounds {
    Bounds {
        iae: Some(d),
        ise: Some(d),
        itae: Some(0.5 * d * d),
        peak: None,
        reasons: vec!["no bound on peak: a controller may leave the output where it is".to_owned()],
    }
}

/// Unit load step: the output runs freely for one dead time, and a second one passes until an answer to what was seen
/// acts.
fn load_bounds(process: &Process) -> Bounds {
    let (k, d) = (process.process_gain().abs(), process.dead_time());
    let none = |what: &str| format!("no bound on {what} is known for this process");
    match (process.integrators(), process.lag()) {
        (1, None) => Bounds {
            iae: Some(k * d * d / 2.0),
            ise: Some(k * k * d * d * d / 3.0),
            itae: Some(5.0 / 6.0 * k * d * d * d),
            peak: Some(k * d),
            reasons: vec![],
        },
        (1, Some(lag)) => {
            // d − T(1 − e^(−d/T)) and its integral, without cancellation when T is large against d.
            let x = d / lag;
            Bounds {
                iae: Some(k * lag * lag * exponential_rest(x, 3)),
                peak: Some(k * lag * exponential_rest(x, 2)),
                reasons: vec![none("ise and itae")],
                ..Bounds::default()
            }
        }
        (_, None) => Bounds {
            iae: Some(k * d * d * d / 6.0),
            ise: Some(k * k * d.powi(5) / 20.0),
            peak: Some(k * d * d / 2.0),
            itae: None,
            reasons: vec![none("itae")],
        },
        (_, Some(_)) => Bounds::absent("no bounds are known for a double integrator with lag"),
    }
}

/// `x^(n−1)/(n−1)! − x^(n−2)/(n−2)! + … ∓ (1 − e^(−x))`, that is `Σ_{j≥n} (−1)^{j−n} x^j/j!`.
fn exponential_rest(x: f64, n: i32) -> f64 {
    if x > 1.0 {
        return if n == 2 { x + (-x).exp_m1() } else { 0.5 * x * x - x - (-x).exp_m1() };
    }
    let mut term = (1..=n).fold(1.0, |t, j| t * x / f64::from(j));
    let (mut sum, mut j) = (0.0, f64::from(n));
    while term.abs() > 1e-18 * f64::abs(sum) {
        sum += term;
        j += 1.0;
        term *= -x / j;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Seconds;

    fn level() -> Process {
        Process::integrating(-2.0, Seconds(3.0)).unwrap()
    }

    #[test]
    fn bounds_scale_with_the_step_and_ise_with_its_square() {
        let of = |size: f64| {
            let scenario = Scenario::new(vec![], vec![(0.0, size)], Seconds(30.0), 0.0).unwrap();
            Bounds::of(&level(), &scenario)
        };
        let (one, three) = (of(1.0), of(-3.0));
        assert_eq!(three.iae.unwrap(), 3.0 * one.iae.unwrap());
        assert_eq!(three.ise.unwrap(), 9.0 * one.ise.unwrap());
        assert_eq!(three.peak.unwrap(), 18.0);
    }

    #[test]
    fn itae_of_a_late_event_counts_time_from_the_start() {
        let scenario = Scenario::new(vec![(10.0, 1.0)], vec![], Seconds(30.0), 0.0).unwrap();
        assert_eq!(Bounds::of(&level(), &scenario).itae.unwrap(), 10.0 * 3.0 + 4.5);
    }

    #[test]
    fn a_vanishing_lag_gives_the_plain_bounds_and_a_huge_one_the_double_integrators() {
        let scenario = Scenario::unit_load_step(Seconds(30.0)).unwrap();
        let with = |lag: f64| Bounds::of(&level().with_lag(Seconds(lag)).unwrap(), &scenario);
        let plain = Bounds::of(&level(), &scenario);
        // The bounds differ from the limits by a relative T/d and d/T.
        assert!((with(1e-9).iae.unwrap() / plain.iae.unwrap() - 1.0).abs() < 1e-8);
        assert!((with(1e-9).peak.unwrap() / plain.peak.unwrap() - 1.0).abs() < 1e-8);
        let double = Bounds::of(&Process::double_integrating(-2.0, Seconds(3.0)).unwrap(), &scenario);
        assert!((with(1e9).iae.unwrap() * 1e9 / double.iae.unwrap() - 1.0).abs() < 1e-8);
        assert!((with(1e9).peak.unwrap() * 1e9 / double.peak.unwrap() - 1.0).abs() < 1e-8);
    }

    #[test]
    fn the_two_formulas_for_the_lag_meet() {
        for n in [2, 3] {
            let (below, above) = (exponential_rest(1.0, n), exponential_rest(1.0 + 1e-12, n));
            assert!((below - above).abs() < 1e-11, "{n}"); // the function's slope is below 1
        }
    }

    #[test]
    fn two_events_or_a_short_horizon_leave_no_bound_and_say_why() {
        let two = Scenario::new(vec![(0.0, 1.0)], vec![(5.0, 1.0)], Seconds(30.0), 0.0).unwrap();
        assert!(Bounds::of(&level(), &two).reasons[0].contains("several"));
        let short = Scenario::unit_load_step(Seconds(5.0)).unwrap();
        let bounds = Bounds::of(&level(), &short);
        assert!(bounds.iae.is_none() && bounds.reasons[0].contains("6 s"));
    }
}
