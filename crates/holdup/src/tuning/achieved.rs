//! What the loop of a tuning achieves: the quantities that sources print beside their settings.

use std::f64::consts::TAU;

use num_complex::Complex64;

use crate::analysis::frequency::{Margins, margins};
use crate::analysis::metrics::Metrics;
use crate::analysis::response::{Scenario, simulate};
use crate::model::{ClosedLoop, Controller, DerivativeFilter, Process, Radians, Seconds};

/// The value of a named quantity of the loop; `None` if there is no such name, or the loop has no such value.
///
/// Times in seconds, angles in degrees where the name says so, ratios otherwise; setpoint and load are unit steps.
pub(super) fn quantity(name: &str, process: &Process, controller: &Controller) -> Option<f64> {
    let closed_loop = ClosedLoop::new(process, controller);
    let margin = |value: fn(&Margins) -> Option<f64>| margins(&closed_loop).ok().as_ref().and_then(value);
    let horizon = Seconds(
        100.0
            * (process.dead_time()
                + process.lag().unwrap_or(0.0)
                + controller.integral_time().unwrap_or(0.0)),
    );
    let after = |scenario: Scenario, value: fn(&Metrics) -> Option<f64>| {
        simulate(&closed_loop, &scenario).ok().and_then(|response| value(&response.metrics))
    };
    let setpoint = |value| after(Scenario::unit_setpoint_step(horizon).ok()?, value);
    let load = |value| after(Scenario::unit_load_step(horizon).ok()?, value);
    let oscillation = |value: fn(Complex64) -> f64| dominant_oscillation(process, controller).map(value);
    match name {
        "gain_margin" => margin(|m| m.gain_margin),
        "phase_margin_deg" => margin(|m| m.phase_margin.map(Radians::degrees)),
        "delay_margin" => margin(|m| m.delay_margin.map(|time| time.0)),
        "sensitivity_peak" => margin(|m| m.sensitivity_peak),
        "complementary_sensitivity_peak" => margin(|m| m.complementary_sensitivity_peak),
        "gain_crossover" => margin(|m| m.gain_crossovers.first().copied()),
        "phase_crossover" => margin(|m| m.phase_crossovers.first().copied()),
        "unstable_poles" => margin(|m| m.unstable_poles.and_then(|n| u32::try_from(n).ok()).map(f64::from)),
        "overshoot" => setpoint(|m| m.overshoot),
        "setpoint_iae" => setpoint(|m| m.iae),
        "load_iae" => load(|m| m.iae),
        "load_peak" => load(|m| m.peak),
        "decay_ratio" => oscillation(|pole| (TAU * pole.re / pole.im).exp()),
        "decay_period" => oscillation(|pole| TAU / pole.im),
        "damping_ratio" => oscillation(|pole| -pole.re / pole.norm()),
        _ => None,
    }
}

/// The rightmost oscillating closed-loop pole [rad/s] that Newton's iteration finds from a lattice of starting points
/// with imaginary part up to 8/d, and at most 20/d from 0. That none lies further right is not proven.
fn dominant_oscillation(process: &Process, controller: &Controller) -> Option<Complex64> {
    if controller.observer().is_some() {
        return None;
    }
    let d = process.dead_time();
    let mut rightmost: Option<Complex64> = None;
    for (column, row) in (0..21).flat_map(|column| (1..33).map(move |row| (column, row))) {
        let mut z = Complex64::new(-4.0 + 0.25 * f64::from(column), 0.25 * f64::from(row));
        for _ in 0..60 {
            // The slope may be rough, the function is exact: the iteration ends at the root itself.
            let h = 1e-6;
            let f = |z: Complex64| characteristic(process, controller, z / d);
            let step = f(z) * 2.0 * h / (f(z + h) - f(z - h));
            z -= step;
            // Far out the exponential overflows or outweighs the rest by more than the digits of a number.
            if !z.is_finite() || z.norm() > 20.0 {
                break;
            }
            if step.norm() <= 1e-13 * z.norm() {
                if z.im > 1e-6 && rightmost.is_none_or(|pole| z.re > pole.re) {
                    rightmost = Some(z);
                }
                break;
            }
        }
    }
    rightmost.map(|z| z / d)
}

/// The characteristic function of a loop without observer: zero at the closed-loop poles.
fn characteristic(process: &Process, controller: &Controller, s: Complex64) -> Complex64 {
    let lag = |time: f64| s * time + 1.0;
    let ti = controller.integral_time();
    let td = controller.derivative_time().unwrap_or(0.0);
    let filter = lag(controller.derivative_filter().map_or(0.0, DerivativeFilter::time));
    let output = controller.output_filter().map_or(Complex64::from(1.0), |f| (s * f.a2 + f.a1) * s + 1.0);
    let (numerator, integral) = match ti {
        Some(ti) => (lag(ti) * filter + s * s * ti * td, s * ti),
        None => (filter + s * td, Complex64::from(1.0)),
    };
    let plant = s.powu(u32::from(process.integrators())) * lag(process.lag().unwrap_or(0.0));
    let gain = process.process_gain() * controller.proportional_gain();
    plant * integral * filter * output + numerator * gain * (-s * process.dead_time()).exp()
}

#[cfg(test)]
mod tests {
    use super::quantity;
    use crate::model::{Controller, Process, Seconds};

    #[test]
    fn dominant_oscillation_of_proportional_control_is_the_principal_branch_of_lambert_w() {
        // W0(−1) = −0.318131505204764 + 1.337235701430689i: the poles of K·Kc·d = 1 (mpmath 1.3, lambertw(-1)).
        let process = Process::integrating(0.5, Seconds(2.0)).unwrap();
        let value = |name: &str| quantity(name, &process, &Controller::proportional(1.0).unwrap()).unwrap();
        let (re, im) = (-0.318_131_505_204_764, 1.337_235_701_430_689_f64);
        // Newton's iteration ends within a few units of rounding.
        assert!((value("decay_period") - 2.0 * std::f64::consts::TAU / im).abs() < 1e-12);
        assert!((value("damping_ratio") + re / im.hypot(re)).abs() < 1e-12);
        assert!((value("decay_ratio") - (std::f64::consts::TAU * re / im).exp()).abs() < 1e-12);
    }
}
