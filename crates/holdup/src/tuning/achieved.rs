//! What the loop of a rule achieves, by name: the quantities of a published value that are not settings.

use std::f64::consts::TAU;

use num_complex::Complex64;

use crate::analysis::frequency::{Margins, margins};
use crate::analysis::metrics::Metrics;
use crate::analysis::response::{Scenario, simulate};
use crate::model::{ClosedLoop, Controller, OutputFilter, Process, Radians, Seconds};

/// Dead times (with the lag) after which a response counts as over: the slowest rule has time constants of some ten.
const HORIZON: f64 = 1000.0;

/// The value of a name for this loop; `None` where nothing has the name, or the loop has no such quantity.
///
/// `gain_margin`, `phase_margin_deg`, `delay_margin_s`, `sensitivity_peak`, `complementary_sensitivity_peak`, the
/// first `gain_crossover` and `phase_crossover` [rad/s], the number of `unstable_poles`; of a unit step of load or setpoint `load_iae`, `load_ise`, `load_peak`, `overshoot`; of the dominant poles
/// `decay_ratio` (of one period), `period_s`, `damping_ratio`, `decay_rate` [1/s].
pub(super) fn achieved(name: &str, process: &Process, controller: &Controller) -> Option<f64> {
    let pole = || dominant_pole(process, controller);
    let margins = |of: fn(&Margins) -> Option<f64>| {
        margins(&ClosedLoop::new(process, controller)).ok().and_then(|achieved| of(&achieved))
    };
    let response = |scenario: fn(Seconds) -> Option<Scenario>, of: fn(&Metrics) -> Option<f64>| {
        let horizon = Seconds(HORIZON * (process.dead_time() + process.lag().unwrap_or(0.0)));
        let response = simulate(&ClosedLoop::new(process, controller), &scenario(horizon)?).ok()?;
        of(&response.metrics)
    };
    let load = |horizon| Scenario::unit_load_step(horizon).ok();
    let setpoint = |horizon| Scenario::unit_setpoint_step(horizon).ok();
    match name {
        "gain_margin" => margins(|m| m.gain_margin),
        "phase_margin_deg" => margins(|m| m.phase_margin.map(Radians::degrees)),
        "delay_margin_s" => margins(|m| m.delay_margin.map(|Seconds(time)| time)),
        "sensitivity_peak" => margins(|m| m.sensitivity_peak),
        "complementary_sensitivity_peak" => margins(|m| m.complementary_sensitivity_peak),
        "gain_crossover" => margins(|m| m.gain_crossovers.first().copied()),
        "phase_crossover" => margins(|m| m.phase_crossovers.first().copied()),
        "unstable_poles" => margins(|m| m.unstable_poles.and_then(|n| u32::try_from(n).ok()).map(f64::from)),
        "load_iae" => response(load, |m| m.iae),
        "load_ise" => response(load, |m| m.ise),
        "load_peak" => response(load, |m| m.peak),
        "overshoot" => response(setpoint, |m| m.overshoot),
        "decay_ratio" => pole().map(|pole| (TAU * pole.re / pole.im).exp()),
        "period_s" => pole().map(|pole| TAU / pole.im),
        "damping_ratio" => pole().map(|pole| -pole.re / pole.norm()),
        "decay_rate" => pole().map(|pole| -pole.re),
        _ => None,
    }
}

/// The rightmost closed-loop pole that Newton's method finds from a grid of starts, with imaginary part ≥ 0
/// [1/s]; of a PID loop without observer. Not proven to be the rightmost: good for a published damping, not for a proof.
fn dominant_pole(process: &Process, controller: &Controller) -> Option<Complex64> {
    if controller.observer().is_some() || controller.compensator().is_some() {
        return None;
    }
    let time = process.dead_time() + process.lag().unwrap_or(0.0);
    let mut found: Option<Complex64> = None;
    // Re from −3 to 1, Im from 0 to 8, in units of 1/(d + T): beyond lie only poles of a faster decay.
    for re in -12..=4 {
        for im in 0..=32 {
            let start = Complex64::new(f64::from(re) + 0.1, f64::from(im) + 0.1) / (4.0 * time);
            let Some(pole) = newton(start, time, |s| characteristic(process, controller, s)) else {
                continue;
            };
            if found.is_none_or(|best| pole.re > best.re) {
                found = Some(pole);
            }
        }
    }
    found
}

/// A root from this start, by Newton's method with a bounded step.
fn newton(start: Complex64, time: f64, function: impl Fn(Complex64) -> Complex64) -> Option<Complex64> {
    let (mut s, step) = (start, 1e-6 / time);
    for _ in 0..100 {
        let slope = (function(s + step) - function(s - step)) / (2.0 * step);
        let mut move_by = function(s) / slope;
        if move_by.norm() * time > 0.5 {
            move_by *= 0.5 / (move_by.norm() * time);
        }
        s -= move_by;
        if !s.is_finite() {
            return None;
        }
        // A multiple root is met to the root of rounding only.
        if move_by.norm() * time < 1e-9 {
            return Some(Complex64::new(s.re, s.im.abs()));
        }
    }
    None
}

/// The numerator of 1 + L: no pole of process or controller is left in it.
fn characteristic(process: &Process, controller: &Controller, s: Complex64) -> Complex64 {
    let lag = 1.0 + s * process.lag().unwrap_or(0.0);
    let filter = 1.0 + s * controller.derivative_filter().map_or(0.0, crate::model::DerivativeFilter::time);
    let output = controller.output_filter().unwrap_or(OutputFilter { a1: 0.0, a2: 0.0 });
    let output = 1.0 + s * (output.a1 + s * output.a2);
    let derivative = s * controller.derivative_time().unwrap_or(0.0);
    // C = Kc·(proportional and integral)·(…)/s where there is an integral.
    let (law, integrator) = match controller.integral_time() {
        Some(ti) => ((s + 1.0 / ti) * filter + s * derivative, s),
        None => (filter + derivative, Complex64::new(1.0, 0.0)),
    };
    let gain = process.process_gain() * controller.proportional_gain() * (-s * process.dead_time()).exp();
    s.powu(u32::from(process.integrators())) * lag * integrator * filter * output + gain * law
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain() -> Process {
        Process::integrating(0.5, Seconds(2.0)).unwrap()
    }

    #[test]
    fn proportional_control_at_half_the_ultimate_gain_has_the_pole_of_lambert() {
        // s·d·e^(s·d) = −π/4: s·d is a branch of the Lambert W function.
        let controller = Controller::proportional(std::f64::consts::FRAC_PI_4).unwrap();
        let pole = dominant_pole(&plain(), &controller).unwrap() * 2.0;
        let lambert = pole * pole.exp();
        // Newton's step ends at 1e-9.
        assert!((lambert.re + std::f64::consts::FRAC_PI_4).abs() < 1e-8 && lambert.im.abs() < 1e-8, "{pole}");
    }

    #[test]
    fn margins_and_responses_have_names_and_nothing_else_has() {
        let controller = Controller::proportional(0.5).unwrap().with_integral_time(Seconds(16.0)).unwrap();
        let of = |name| achieved(name, &plain(), &controller);
        // Half a unit of the last digit known (SIMC PI).
        assert!((of("sensitivity_peak").unwrap() - 1.70352).abs() < 5e-6);
        assert!(of("load_iae").unwrap() > 0.0 && of("overshoot").unwrap() > 0.0);
        assert_eq!(of("gain"), None);
    }
}
