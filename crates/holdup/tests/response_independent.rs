//! The response against integrators that share no code with it: a fixed-step one with its measured order, and the crate
//! `differential-equations`.

#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use differential_equations::prelude::*;
use holdup::analysis::response::{Scenario, simulate, trajectory};
use holdup::model::closed_loop::{Source, Sum};
use holdup::model::{ClosedLoop, Controller, Observer, Process, Seconds};

fn level() -> Process {
    Process::integrating(0.0506, Seconds(6.0)).unwrap()
}

/// Setpoint step at 0 and load step at 42 s over 84 s, by Heun's method on a grid that contains both delays, with values
/// from the left and from the right at every point. Returns y at 20.4, 45 and 83.4 s, u at the same times and ∫u².
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "numbers of steps are below 10 000"
)]
fn heun(closed: &ClosedLoop, h: f64) -> Vec<f64> {
    let n = closed.rates().len();
    let steps = (84.0 / h).round() as usize;
    let lags: Vec<usize> = closed.channels().iter().map(|c| (c.delay / h).round() as usize).collect();
    let (mut left, mut right): (Vec<Vec<f64>>, Vec<Vec<f64>>) =
        (vec![vec![]; lags.len()], vec![vec![]; lags.len()]);
    let sum = |sum: &Sum, x: &[f64], w: &[f64], load: f64, on: f64| -> f64 {
        sum.terms()
            .iter()
            .map(|&(source, weight)| {
                weight
                    * match source {
                        Source::Setpoint => on,
                        Source::SetpointRate => 0.0,
                        Source::Load => load,
                        Source::State(i) => x[i],
                        Source::Delayed(c) => w[c],
                    }
            })
            .sum()
    };
    let mut x = vec![0.0; n];
    let (mut energy, mut out_y, mut out_u) = (0.0, vec![], vec![]);
    for k in 0..=steps {
        let t = k as f64 * h;
        let load = |from_right: bool| f64::from(t > 42.0 - 1e-9 && (from_right || t > 42.0 + 1e-9));
        let on = |from_right: bool| f64::from(from_right || k > 0);
        let past = |signal: &Vec<Vec<f64>>| -> Vec<f64> {
            lags.iter().enumerate().map(|(c, &lag)| if k >= lag { signal[c][k - lag] } else { 0.0 }).collect()
        };
        let (w_left, w_right) = (past(&left), past(&right));
        for (c, channel) in closed.channels().iter().enumerate() {
            left[c].push(sum(&channel.input, &x, &w_left, load(false), on(false)));
            right[c].push(sum(&channel.input, &x, &w_right, load(true), on(true)));
        }
        let u = closed.manipulated_variable();
        let (u_left, u_right) =
            (sum(u, &x, &w_left, load(false), on(false)), sum(u, &x, &w_right, load(true), on(true)));
        if k > 0 {
            energy += 0.5 * h * u_left * u_left;
        }
        if k < steps {
            energy += 0.5 * h * u_right * u_right;
        }
        if [20.4, 45.0, 83.4].iter().any(|s| (t - s).abs() < 1e-9) {
            out_y.push(x[closed.controlled_variable()]);
            out_u.push(u_right);
        }
        if k == steps {
            break;
        }
        let next: Vec<f64> = lags
            .iter()
            .enumerate()
            .map(|(c, &lag)| if k + 1 >= lag { left[c][k + 1 - lag] } else { 0.0 })
            .collect();
        let load_next = f64::from(t + h > 42.0 + 1e-9);
        let rate = |x: &[f64], w: &[f64], load: f64| -> Vec<f64> {
            closed.rates().iter().map(|r| sum(r, x, w, load, 1.0)).collect()
        };
        let first = rate(&x, &w_right, load(true));
        let predicted: Vec<f64> = x.iter().zip(&first).map(|(x, f)| x + h * f).collect();
        let second = rate(&predicted, &next, load_next);
        for i in 0..n {
            x[i] += 0.5 * h * (first[i] + second[i]);
        }
    }
    [out_y, out_u, vec![energy]].concat()
}

/// Ours, the same numbers.
fn ours(closed: &ClosedLoop) -> Vec<f64> {
    let scenario = Scenario::new(vec![(0.0, 1.0)], vec![(42.0, 1.0)], Seconds(84.0), 0.0).unwrap();
    let path = trajectory(closed, &scenario, &[20.4, 45.0, 83.4]).unwrap();
    let energy = simulate(closed, &scenario).unwrap().metrics.control_energy.unwrap();
    [path.controlled_variable, path.manipulated_variable, vec![energy]].concat()
}

#[track_caller]
fn agrees(closed: &ClosedLoop) {
    let wanted = ours(closed);
    let h = 0.0125;
    let runs: Vec<Vec<f64>> = [h, h / 2.0, h / 4.0].iter().map(|&h| heun(closed, h)).collect();
    for i in 0..wanted.len() {
        let errors: Vec<f64> = runs.iter().map(|run| (run[i] - wanted[i]).abs()).collect();
        let scale = wanted[i].abs().max(1.0);
        // Second order: the error falls by 4 at each halving (measured where it is not yet rounding of 7000 steps), and what
        // Richardson's extrapolation leaves is of third order or better: below a hundredth of the error.
        if errors[2] > 1e-9 * scale {
            let order = (errors[1] / errors[2]).log2();
            assert!((order - 2.0).abs() < 0.15, "value {i}: order {order}, errors {errors:?}");
        }
        let extrapolated = (4.0 * runs[2][i] - runs[1][i]) / 3.0;
        assert!(
            (extrapolated - wanted[i]).abs() <= 1e-2 * errors[2] + 1e-9 * scale,
            "value {i}: {extrapolated} against {}",
            wanted[i]
        );
    }
}

fn pd(kc: f64, td: f64, n: f64) -> Controller {
    let p = Controller::proportional(kc).unwrap().with_derivative_time(Seconds(td)).unwrap();
    p.with_filter_bandwidth(n).unwrap()
}

#[test]
fn pid_agrees_with_a_fixed_step_integrator_of_second_order() {
    agrees(&ClosedLoop::new(&level(), &pd(2.95, 3.0, 4.0).with_integral_time(Seconds(15.0)).unwrap()));
}

#[test]
fn an_observer_with_another_gain_and_dead_time_agrees_with_a_fixed_step_integrator() {
    let observer = Observer::new(0.9).unwrap().with_model_gain(0.06).unwrap();
    for dead_time in [6.6, 4.8, 6.0] {
        let observer = observer.with_model_dead_time(Seconds(dead_time)).unwrap();
        agrees(&ClosedLoop::new(&level(), &pd(1.2, 0.7, 4.0).with_observer(observer)));
    }
}

#[test]
fn lags_two_integrators_and_output_filters_agree_with_a_fixed_step_integrator() {
    let pi = Controller::proportional(1.2).unwrap().with_integral_time(Seconds(60.0)).unwrap();
    agrees(&ClosedLoop::new(&level().with_lag(Seconds(3.0)).unwrap(), &pi));
    agrees(&ClosedLoop::new(&level(), &pi.with_output_filter(1.0, 0.0).unwrap()));
    agrees(&ClosedLoop::new(&level(), &pi.with_output_filter(0.8, 0.9).unwrap()));
    let double = Process::double_integrating(0.001, Seconds(6.0)).unwrap();
    agrees(&ClosedLoop::new(&double, &pd(1.5, 25.0, 2.0)));
}

#[test]
fn a_neutral_loop_agrees_with_a_fixed_step_integrator() {
    let unfiltered = Controller::proportional(2.0).unwrap().with_derivative_time(Seconds(6.0)).unwrap();
    agrees(&ClosedLoop::new(&level(), &unfiltered.with_setpoint_weights(1.0, 0.0).unwrap()));
}

/// PI control of the level, written out by hand: y and the integral of the error.
struct PiLoop;

impl DDE<1, f64, [f64; 2]> for PiLoop {
    fn diff(&self, t: f64, x: &[f64; 2], delayed: &[[f64; 2]; 1], rate: &mut [f64; 2]) {
        let (kc, ti, k) = (1.6, 48.0, 0.0506);
        let [y, integral] = delayed[0];
        let u = if t < 6.0 { 0.0 } else { kc * (1.0 - y + integral / ti) };
        rate[0] = k * u;
        rate[1] = 1.0 - x[0];
    }

    fn lags(&self, _t: f64, _x: &[f64; 2], lags: &mut [f64; 1]) {
        lags[0] = 6.0;
    }
}

#[test]
fn pi_control_agrees_with_the_crate_differential_equations() {
    // differential-equations 0.7.0, Dormand–Prince with dense history; started at the dead time, before which the
    // output rests and the integral is t, so that no breakpoint of order 0 is inside.
    let system = PiLoop;
    let solution = IVP::dde(&system, 6.0, 60.0, [0.0, 6.0], |t: f64| [0.0, t.max(0.0)])
        .even(6.0)
        .method(ExplicitRungeKutta::dopri5().rtol(1e-11).atol(1e-12).max_delay(7.0))
        .solve()
        .unwrap();
    let pi = Controller::proportional(1.6).unwrap().with_integral_time(Seconds(48.0)).unwrap();
    let scenario = Scenario::unit_setpoint_step(Seconds(60.0)).unwrap();
    let path = trajectory(&ClosedLoop::new(&level(), &pi), &scenario, &solution.t).unwrap();
    assert!(solution.t.len() > 8);
    for ((t, x), y) in solution.iter().zip(&path.controlled_variable) {
        // 1e-7: its interpolated history is of order 4, and the breakpoints at 12, 18… are not on its mesh.
        assert!((x[0] - y).abs() < 1e-7, "t = {t}: {} against {y}", x[0]);
    }
}
