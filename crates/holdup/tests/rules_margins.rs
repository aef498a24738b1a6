//! The achieved margins of every registered rule against L(jω) written from the block diagram, sharing no code with
//! the analysis. The dead-time compensators have closed formulas of their own in `compensators.rs`.

#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use holdup::analysis::frequency::margins;
use holdup::model::{ClosedLoop, Controller, DerivativeFilter, Process, Seconds};
use holdup::tuning::{Applies, Parameters, rules};
use num_complex::Complex64;

fn example(applies: Applies) -> Process {
    let (gain, dead_time) = (0.7, Seconds(1.3));
    match applies {
        Applies::Integrating => Process::integrating(gain, dead_time).unwrap(),
        Applies::DoubleIntegrating => Process::double_integrating(gain, dead_time).unwrap(),
        Applies::IntegratingWithLag => {
            Process::integrating(gain, dead_time).unwrap().with_lag(Seconds(2.1)).unwrap()
        }
    }
}

/// G, with a perfect model, and C + Ko + Ko·G·C: the loop broken at the process input.
fn loop_transfer(process: &Process, controller: &Controller, omega: f64) -> Complex64 {
    let s = Complex64::new(0.0, omega);
    let lag = 1.0 + s * process.lag().unwrap_or(0.0);
    let g = process.process_gain() * (-s * process.dead_time()).exp()
        / (s.powi(i32::from(process.integrators())) * lag);
    let integral = controller.integral_time().map_or(Complex64::ZERO, |ti| 1.0 / (s * ti));
    let filter = 1.0 + s * controller.derivative_filter().map_or(0.0, DerivativeFilter::time);
    let derivative = s * controller.derivative_time().unwrap_or(0.0) / filter;
    let output = controller.output_filter().map_or(Complex64::ONE, |f| 1.0 + s * f.a1 + s * s * f.a2);
    let c = controller.proportional_gain() * (1.0 + integral + derivative) / output;
    let ko = controller.observer().map_or(0.0, |observer| observer.gain());
    g * (c + ko + ko * g * c)
}

#[test]
fn achieved_margins_of_every_rule_equal_an_independent_evaluation() {
    let mut seen = 0;
    for entry in rules() {
        let process = example(entry.process);
        let question = match entry.id {
            "pd-exact" => Parameters::new().set("Am", 2.5).set("phi_m", 1.1),
            _ => Parameters::new(),
        };
        let controller = entry.tune(&process, &question).unwrap().controller;
        if controller.compensator().is_some() {
            continue;
        }
        let achieved = margins(&ClosedLoop::new(&process, &controller)).unwrap();
        let at = |omega: f64| loop_transfer(&process, &controller, omega);
        // Rounding of two evaluations of L, enlarged by the slope at a crossing.
        let close = |x: f64, y: f64| (x - y).abs() <= 1e-8 * y.abs().max(1.0);
        for &omega in &achieved.gain_crossovers {
            assert!(close(at(omega).norm(), 1.0), "{} at {omega}", entry.id);
        }
        for &omega in &achieved.phase_crossovers {
            let value = at(omega);
            assert!(value.re < 0.0 && value.im.abs() <= 1e-8 * value.norm(), "{} at {omega}", entry.id);
        }
        let grid = || (1..30_000).map(|k| 1e-3 * 1.0004_f64.powi(k));
        if let (Some(peak), Some(omega)) = (achieved.sensitivity_peak, achieved.sensitivity_peak_frequency) {
            assert!(close(1.0 / (1.0 + at(omega)).norm(), peak), "{}", entry.id);
            let seen = grid().map(|w| 1.0 / (1.0 + at(w)).norm()).fold(0.0, f64::max);
            assert!(seen <= peak * (1.0 + 1e-9), "{}: the grid sees {seen} above {peak}", entry.id);
        }
        if let Some(margin) = achieved.phase_margin {
            let smallest = achieved.gain_crossovers.iter().map(|&w| (-at(w)).arg());
            let smallest = smallest.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap();
            assert!(close(margin.0, smallest), "{}", entry.id);
        }
        if let (true, Some(margin)) = (achieved.stable, achieved.gain_margin) {
            let listed = achieved.phase_crossovers.iter().map(|&w| 1.0 / at(w).norm());
            let least = listed.filter(|factor| *factor > 1.0).fold(f64::INFINITY, f64::min);
            assert!(margin <= least * (1.0 + 1e-8), "{}", entry.id);
            assert!(close(margin, least) || achieved.high_frequency_gain > 0.0, "{}", entry.id);
        }
        seen += 1;
    }
    assert!(seen > 100, "only {seen} rules were seen");
}
