//! Integrals of a step response to an infinite horizon, with a bound on what is left out.
//!
//! The response is simulated exactly to a horizon H. What follows is bounded by Parseval's theorem on the line
//! Re s = −σ, to whose right no closed-loop pole lies, and the inequality of Cauchy and Schwarz:
//!
//! ```text
//! ∫_H^∞ |e| dt ≤ e^(−σH)/√(2σ) · √(∫_0^∞ e^(2σt)·e² dt),   ∫_0^∞ e^(2σt)·e² dt = 1/(2π) ∫ |E(−σ + jω)|² dω
//! ```
//!
//! The inequality is a theorem. The last integral is found by quadrature to a percent and then doubled; what lies
//! beyond the highest frequency is bounded by the envelope found there.

mod laplace;
mod weighted;

use serde::Serialize;

use super::bounds::Bounds;
use super::frequency::{FrequencyError, dominant_poles};
use super::response::{ResponseError, Scenario, simulate};
use crate::model::{ClosedLoop, Controller, Process, Seconds};

pub use laplace::Input;

/// The part of the integral that may be left out.
const REST: f64 = 1e-9;

/// How near the line −σ comes to the rightmost pole.
const SHARE: f64 = 0.9;

/// Band of the settling time, as a part of the setpoint step.
const SETTLED: f64 = 0.02;

/// Decay times after which a loop whose poles are not known to be complete counts as over.
const UNPROVEN: f64 = 60.0;

/// Integrals of a unit step response over all time; one that is infinite is absent, with a sentence in the warnings.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct InfiniteHorizon {
    /// Integral of the absolute error [output unit · s].
    pub iae: Option<f64>,
    /// Bound on the part of `iae` that is left out, as a ratio of it; absent where none is proven.
    pub tail: Option<f64>,
    /// Integral of the squared error [output unit² · s], up to the horizon; absent where `iae` is.
    pub ise: Option<f64>,
    /// Total variation of the controller output [input unit], up to the horizon.
    pub total_variation: Option<f64>,
    /// Integral of the squared controller output [input unit² · s], up to the horizon.
    pub control_energy: Option<f64>,
    /// Last time at which the error is more than 2 % of the setpoint step \[s\]; absent after a load step.
    #[serde(rename = "settling_time_s")]
    pub settling_time: Option<f64>,
    /// The horizon to which the response was simulated [s]; absent where no integral is finite.
    #[serde(rename = "horizon_s")]
    pub horizon: Option<f64>,
    /// Why an integral is absent.
    #[serde(skip)]
    pub warnings: Vec<String>,
}

/// Why integrals to an infinite horizon could not be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum InfiniteHorizonError {
    /// The poles are out of reach.
    #[error(transparent)]
    Frequency(#[from] FrequencyError),
    /// The response is out of reach.
    #[error(transparent)]
    Response(#[from] ResponseError),
    /// The horizon that the tail asks for is no time that can be simulated.
    #[error("the loop decays too slowly: a horizon of {horizon} s cannot be simulated")]
    Horizon {
        /// The horizon [s].
        horizon: f64,
    },
}

/// Integrals of the response of a **stable** loop to a unit step at time 0, over all time.
///
/// ```
/// use holdup::analysis::infinite_horizon::{Input, to_infinity};
/// use holdup::model::{Controller, Process, Seconds};
/// let process = Process::integrating(1.0, Seconds(1.0))?;
/// let simc = Controller::proportional(0.5)?.with_integral_time(Seconds(8.0))?;
/// let load = to_infinity(&process, &simc, Input::Load)?;
/// // The error never changes its sign: IAE is Ti/Kc.
/// assert!((load.iae.unwrap() - 16.0).abs() < 1e-7 && load.tail.unwrap() < 1e-9);
/// // A proportional controller leaves an error behind.
/// let p = Controller::proportional(0.5)?;
/// assert_eq!(to_infinity(&process, &p, Input::Load)?.iae, None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`InfiniteHorizonError`] if poles or response are out of the reach of double precision or of the budget.
pub fn to_infinity(
    process: &Process,
    controller: &Controller,
    input: Input,
) -> Result<InfiniteHorizon, InfiniteHorizonError> {
    if let Some(why) = lasting_error(controller, input) {
        return Ok(InfiniteHorizon {
            iae: None,
            ise: None,
            tail: None,
            total_variation: None,
            control_energy: None,
            settling_time: None,
            horizon: None,
            warnings: vec![why],
        });
    }
    let closed_loop = ClosedLoop::new(process, controller);
    let poles = dominant_poles(&closed_loop)?;
    let Some(decay) = poles.first().map(|pole| -pole.re).filter(|decay| *decay > 0.0) else {
        let time = process.dead_time() + process.lag().unwrap_or(0.0);
        return integrals(process, controller, input, UNPROVEN * 10.0 * time, None, None);
    };
    let sigma = SHARE * decay;
    let heights: Vec<f64> = poles.iter().map(|pole| pole.im).filter(|im| *im > 0.0).collect();
    let Some(weighted) = weighted::squared_error(&closed_loop, input, sigma, &heights) else {
        return integrals(process, controller, input, UNPROVEN / decay, None, None);
    };
    let rest = |horizon: f64| (-sigma * horizon).exp() * (weighted / (2.0 * sigma)).sqrt();
    // The horizon that keeps the rest below its share of the least IAE that is possible.
    let least = least_iae(process, input);
    let enough = |iae: f64| {
        ((weighted / (2.0 * sigma)).sqrt() / (REST * iae)).ln().max(1.0) / sigma + process.dead_time()
    };
    let horizon = least.map_or(UNPROVEN / decay, enough);
    let first = integrals(process, controller, input, horizon, Some(&rest), None)?;
    match (first.iae, first.tail) {
        (Some(iae), Some(tail)) if tail > REST => {
            integrals(process, controller, input, enough(iae), Some(&rest), None)
        }
        _ => Ok(first),
    }
}

/// The same without the bound on what is left out, at a fraction of the cost: the response is followed until about 1e-12 of it
/// is left, or of all but the slowest part of it where that is one exponential, whose rest is closed form.
///
/// # Errors
/// As [`to_infinity`]; [`InfiniteHorizonError::Horizon`] if that takes longer than `longest` \[s\].
pub fn to_infinity_unproven(
    process: &Process,
    controller: &Controller,
    input: Input,
    longest: f64,
) -> Result<InfiniteHorizon, InfiniteHorizonError> {
    const DECAYS: f64 = 28.0;
    if lasting_error(controller, input).is_some() {
        return to_infinity(process, controller, input);
    }
    let poles = dominant_poles(&ClosedLoop::new(process, controller))?;
    let time = process.dead_time() + process.lag().unwrap_or(0.0);
    let after = |decay: f64| DECAYS / decay + 4.0 * time;
    let decay = poles.first().map(|pole| -pole.re).filter(|decay| *decay > 0.0);
    let horizon = decay.map_or(UNPROVEN * 10.0 * time, after);
    // One real pole nearer to 0 than half of the next: the others are over long before it is.
    let slowest = match poles.as_slice() {
        [first, second, ..] if first.im == 0.0 && second.re < 2.0 * first.re => {
            decay.map(|decay| (decay, after(-second.re)))
        }
        _ => None,
    };
    let simulated = slowest.map_or(horizon, |(_, shorter)| shorter);
    if simulated > longest {
        return Err(InfiniteHorizonError::Horizon { horizon: simulated });
    }
    integrals(process, controller, input, simulated, None, slowest.map(|(decay, _)| decay))
}

/// Why the error does not vanish, where it does not.
fn lasting_error(controller: &Controller, input: Input) -> Option<String> {
    // Every compensator of the model answers a constant load as integral action does.
    let integral = controller.integral_time().is_some() || controller.compensator().is_some();
    match input {
        Input::Load if !integral && controller.observer().is_none() => Some(
            "load IAE is infinite: without integral action or observer a load leaves an error behind".to_owned(),
        ),
        Input::Setpoint if !integral && controller.setpoint_weight() != 1.0 => Some(
            "setpoint IAE is infinite: a setpoint weight other than 1 without integral action leaves an error behind"
                .to_owned(),
        ),
        _ => None,
    }
}

/// A lower bound on the IAE of any controller.
fn least_iae(process: &Process, input: Input) -> Option<f64> {
    let time = Seconds(10.0 * (process.dead_time() + process.lag().unwrap_or(0.0)));
    Bounds::of(process, &scenario(input, time).ok()?).iae.filter(|least| *least > 0.0)
}

fn scenario(input: Input, horizon: Seconds) -> Result<Scenario, InfiniteHorizonError> {
    let scenario = match input {
        Input::Setpoint => Scenario::unit_setpoint_step(horizon),
        Input::Load => Scenario::unit_load_step(horizon),
    };
    scenario.map_err(|_| InfiniteHorizonError::Horizon { horizon: horizon.0 })
}

fn integrals(
    process: &Process,
    controller: &Controller,
    input: Input,
    horizon: f64,
    rest: Option<&dyn Fn(f64) -> f64>,
    decay: Option<f64>,
) -> Result<InfiniteHorizon, InfiniteHorizonError> {
    let scenario = scenario(input, Seconds(horizon))?;
    let response = simulate(&ClosedLoop::new(process, controller), &scenario)?;
    let mut metrics = response.metrics;
    let mut settling_time = metrics.settling_time.map(|time| time.0);
    if let Some(decay) = decay {
        // What follows is e(H)·e^(−σt), and the controller output likewise about where it ends.
        let (error, end) = match input {
            Input::Setpoint => (1.0 - response.final_controlled_variable, 0.0),
            Input::Load => (-response.final_controlled_variable, -1.0),
        };
        let output = response.final_manipulated_variable - end;
        if input == Input::Setpoint && error.abs() > SETTLED {
            settling_time = Some(horizon + (error.abs() / SETTLED).ln() / decay);
        }
        let more = |value: Option<f64>, rest: f64| value.map(|value| value + rest);
        metrics.iae = more(metrics.iae, error.abs() / decay);
        metrics.ise = more(metrics.ise, 0.5 * error * error / decay);
        metrics.total_variation = more(metrics.total_variation, output.abs());
        metrics.control_energy = more(metrics.control_energy, 0.5 * output * output / decay);
    }
    let mut warnings = Vec::new();
    if metrics.iae.is_some() && rest.is_none() {
        warnings.push(format!(
            "the rest of the IAE after {horizon:.3} s is not proven small: no list of the rightmost poles is complete"
        ));
    }
    if metrics.total_variation.is_none() {
        warnings.extend(response.warnings);
    }
    let tail = rest.zip(metrics.iae).map(|(rest, iae)| rest(horizon) / iae);
    // After a load step the controller output stays at −1 for ever.
    let control_energy = metrics.control_energy.filter(|_| input == Input::Setpoint);
    Ok(InfiniteHorizon {
        iae: metrics.iae,
        ise: metrics.ise.filter(|_| metrics.iae.is_some()),
        tail,
        total_variation: metrics.total_variation,
        control_energy,
        settling_time,
        horizon: Some(horizon),
        warnings,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Observer;

    fn normal() -> Process {
        Process::integrating(1.0, Seconds(1.0)).unwrap()
    }

    #[test]
    fn a_setpoint_step_under_proportional_control_without_overshoot_has_the_area_of_the_velocity_error() {
        // ∫e = 1/(K·Kc) for the plain integrator, and e does not change its sign below K·Kc·d = 1/e.
        let p = Controller::proportional(0.3).unwrap();
        let step = to_infinity(&normal(), &p, Input::Setpoint).unwrap();
        assert!((step.iae.unwrap() * 0.3 - 1.0).abs() < 2e-9, "{step:?}"); // the rest and the simulation, 1e-9 each
        assert!(step.tail.unwrap() < 1e-9 && step.control_energy.unwrap() > 0.0);
    }

    #[test]
    fn an_observer_takes_the_load_away() {
        let pd = Controller::proportional(0.25).unwrap();
        let controller = pd.with_observer(Observer::new(0.2).unwrap());
        let load = to_infinity(&normal(), &controller, Input::Load).unwrap();
        // ∫e = 1/(K·Kc·Ko); the loop is slow enough for the error to keep its sign.
        assert!((load.iae.unwrap() * 0.05 - 1.0).abs() < 2e-9, "{load:?}");
        assert_eq!(load.control_energy, None);
    }

    #[test]
    fn a_neutral_loop_has_an_iae_and_no_energy() {
        let pd = Controller::proportional(0.4).unwrap().with_derivative_time(Seconds(0.4)).unwrap();
        let step = to_infinity(&normal(), &pd, Input::Setpoint).unwrap();
        assert!(step.iae.unwrap() > 1.0 && step.tail.unwrap() < 1e-9, "{step:?}");
        assert!(step.control_energy.is_none() && step.total_variation.is_none() && !step.warnings.is_empty());
    }

    #[test]
    fn twice_the_horizon_changes_nothing() {
        let pid = Controller::proportional(0.9).unwrap().with_integral_time(Seconds(2.2)).unwrap();
        let pid = pid.with_derivative_time(Seconds(0.4)).unwrap().with_filter_bandwidth(50.0).unwrap();
        let load = to_infinity(&normal(), &pid, Input::Load).unwrap();
        let longer =
            integrals(&normal(), &pid, Input::Load, 2.0 * load.horizon.unwrap(), None, None).unwrap();
        assert!((load.iae.unwrap() / longer.iae.unwrap() - 1.0).abs() < 1e-9);
    }

    #[test]
    fn the_slowest_part_in_closed_form_changes_nothing() {
        let pi = |gain: f64, time: f64| {
            Controller::proportional(gain).unwrap().with_integral_time(Seconds(time)).unwrap()
        };
        let observed = Controller::proportional(0.4).unwrap().with_observer(Observer::new(0.01).unwrap());
        for controller in [pi(0.4, 40.0), pi(0.6, 12.0), pi(0.3, 60.0), observed] {
            for input in [Input::Load, Input::Setpoint] {
                let (whole, quick) = (
                    to_infinity(&normal(), &controller, input).unwrap(),
                    to_infinity_unproven(&normal(), &controller, input, 1e6).unwrap(),
                );
                let pairs = [(whole.iae, quick.iae), (whole.ise, quick.ise)];
                let movement = (whole.total_variation, quick.total_variation);
                // The rest of the one, 1e-9, and twice the simulation, 1e-9 each.
                for (whole, quick) in
                    [movement, (whole.control_energy, quick.control_energy)].into_iter().chain(pairs)
                {
                    let close =
                        whole.zip(quick).is_none_or(|(whole, quick)| (quick / whole - 1.0).abs() < 3e-9);
                    assert!(
                        close && whole.is_some() == quick.is_some(),
                        "{controller:?} {input:?} {whole:?} {quick:?}"
                    );
                }
            }
        }
    }
}
