//! Step responses that have a closed form: a polynomial of one more degree for each dead time that has passed.

#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use holdup::analysis::response::{Scenario, simulate, trajectory};
use holdup::model::{ClosedLoop, Controller, Process, Seconds};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{FromPrimitive, One, ToPrimitive, Zero};

fn unit_process() -> Process {
    Process::integrating(1.0, Seconds(1.0)).unwrap()
}

fn proportional(kappa: f64) -> ClosedLoop {
    ClosedLoop::new(&unit_process(), &Controller::proportional(kappa).unwrap())
}

fn outputs(closed: &ClosedLoop, times: &[f64]) -> Vec<f64> {
    let scenario = Scenario::unit_setpoint_step(Seconds(times.iter().fold(1.0, |m: f64, t| m.max(*t)) + 1.0));
    trajectory(closed, &scenario.unwrap(), times).unwrap().controlled_variable
}

/// Times that hit cell edges, cell middles and nothing in particular; all exact binary fractions.
fn times(until: u32) -> Vec<f64> {
    (0..until * 4).map(|i| f64::from(i) * 0.25 + if i % 3 == 0 { 0.078_125 } else { 0.0 }).collect()
}

/// `y(t) = Σ_{k=1}^{⌊t⌋} (−1)^{k+1} κ^k·Σ_j C(m, j)·Td^j·(t − k)^{k−j}/(k − j)!` in exact rationals: unit step
/// response of `κ(1 + Td·s)·e^{−s}/s` under unit feedback; m = k for derivative weight c = 1, k − 1 for c = 0.
fn exact(t: f64, kappa: f64, td: f64, c: bool) -> f64 {
    let rational = |x: f64| BigRational::from_f64(x).unwrap();
    let (kappa, td) = (rational(kappa), rational(td));
    let mut sum = BigRational::zero();
    let mut power = -BigRational::one();
    let mut k = 1;
    while f64::from(k) <= t {
        power = -power * &kappa;
        let tau = rational(t) - BigRational::from_integer(BigInt::from(k));
        let mut powers = vec![BigRational::one()];
        for i in 1..=k {
            let next = powers.last().unwrap() * &tau / BigRational::from_integer(BigInt::from(i));
            powers.push(next);
        }
        let m = if c { k } else { k - 1 };
        let mut choose = power.clone();
        for j in 0..=m {
            sum += &choose * &powers[usize::try_from(k - j).unwrap()];
            choose = choose * &td * BigRational::new(BigInt::from(m - j), BigInt::from(j + 1));
        }
        k += 1;
    }
    sum.to_f64().unwrap()
}

/// The same for c = 1 in f64, with the terms up to `echoes`.
fn in_f64(echoes: i32, t: f64, kappa: f64, td: f64) -> f64 {
    let mut sum = 0.0;
    for k in 1..=echoes {
        let mut choose = -(-kappa).powi(k);
        for j in 0..=k {
            let power: f64 = (1..=k - j).map(|i| (t - f64::from(k)) / f64::from(i)).product();
            sum += choose * power;
            choose *= td * f64::from(k - j) / f64::from(j + 1);
        }
    }
    sum
}

#[test]
fn proportional_control_follows_the_piecewise_polynomial() {
    for kappa in [0.25f64, 0.5, 1.0, 1.5] {
        let closed = proportional(kappa);
        let times = times(20);
        for (t, y) in times.iter().zip(outputs(&closed, &times)) {
            let (mut sum, mut k) = (0.0, 1);
            while f64::from(k) <= *t {
                let mut term = -1.0;
                for i in 1..=k {
                    term *= -kappa * (t - f64::from(k)) / f64::from(i);
                }
                sum += term;
                k += 1;
            }
            // 1e-12 as the issue asks; the sum's terms reach 1e4 × (κ/1.5)^20 and cancel, which costs that in f64.
            let cancelled = if kappa > 0.5 { 1e-10 } else { 1e-12 };
            assert!((y - sum).abs() < cancelled, "κ = {kappa}, t = {t}: {y} against {sum}");
        }
    }
}

#[test]
fn proportional_control_follows_the_exact_rationals_to_sixty_dead_times() {
    for kappa in [0.5f64, 1.5] {
        let times = [3.25, 12.0, 20.25, 33.5, 47.125, 59.0, 60.75];
        for (t, y) in times.iter().zip(outputs(&proportional(kappa), &times)) {
            // 1e-12: rounding of 60 cells.
            assert!((y - exact(*t, kappa, 0.0, true)).abs() < 1e-12, "κ = {kappa}, t = {t}");
        }
    }
}

#[test]
fn unfiltered_derivative_action_makes_the_echoes_of_its_closed_form() {
    for (c, weight) in [(true, 1.0), (false, 0.0)] {
        for td in [0.5, 1.5, 1.9375] {
            let pd = Controller::proportional(0.5).unwrap().with_derivative_time(Seconds(td)).unwrap();
            let pd = pd.with_setpoint_weights(1.0, weight).unwrap();
            let closed = ClosedLoop::new(&unit_process(), &pd);
            let times: Vec<f64> = times(40).into_iter().step_by(11).collect();
            for (t, y) in times.iter().zip(outputs(&closed, &times)) {
                // 1e-12: rounding of 40 cells; κ·Td up to 0.97 lets errors live long.
                let wanted = exact(*t, 0.5, td, c);
                assert!((y - wanted).abs() < 1e-12, "c = {weight}, Td = {td}, t = {t}: {y} against {wanted}");
            }
        }
    }
}

#[test]
fn an_impulse_in_the_controller_output_makes_energy_and_variation_infinite_and_nothing_else() {
    let pd = Controller::proportional(0.5).unwrap().with_derivative_time(Seconds(0.8)).unwrap();
    let scenario = Scenario::unit_setpoint_step(Seconds(12.0)).unwrap();
    let response = simulate(&ClosedLoop::new(&unit_process(), &pd), &scenario).unwrap();
    assert_eq!((response.metrics.control_energy, response.metrics.total_variation), (None, None));
    assert_eq!(response.warnings.len(), 1, "{:?}", response.warnings);
    // Simpson's rule between breakpoints on the closed form, in f64: until t = 12 its cancellation costs 2 digits.
    let panels = 100;
    let mut ise = 1.0;
    for k in 1..12 {
        for i in 0..panels {
            let (a, h) = (f64::from(k) + f64::from(i) / f64::from(panels), 1.0 / f64::from(panels));
            let square = |t: f64| (1.0 - in_f64(k, t, 0.5, 0.8)).powi(2);
            ise += h / 6.0 * (square(a) + 4.0 * square(a + 0.5 * h) + square(a + h));
        }
    }
    // 1e-10: Simpson's error, h⁴/2880 times the fourth derivative.
    assert!((response.metrics.ise.unwrap() - ise).abs() < 1e-10, "{:?} against {ise}", response.metrics.ise);
    // A load step, or c = 0, is finite.
    let load = Scenario::unit_load_step(Seconds(30.0)).unwrap();
    assert!(
        simulate(&ClosedLoop::new(&unit_process(), &pd), &load).unwrap().metrics.control_energy.is_some()
    );
    let weighted = pd.with_setpoint_weights(1.0, 0.0).unwrap();
    assert!(simulate(&ClosedLoop::new(&unit_process(), &weighted), &scenario).unwrap().warnings.is_empty());
}

#[test]
fn first_cells_of_proportional_control_have_metrics_in_closed_form() {
    // κ = 1/2 until t = 2: e = 1 until 1, then 1 − (t − 1)/2; u = e/2.
    let scenario = Scenario::unit_setpoint_step(Seconds(2.0)).unwrap();
    let metrics = simulate(&proportional(0.5), &scenario).unwrap().metrics;
    // 1e-15: a few roundings.
    for (computed, wanted) in [
        (metrics.iae, 1.75),
        (metrics.ise, 1.0 + 7.0 / 12.0),
        (metrics.itae, 0.5 + 1.5 - 5.0 / 12.0),
        (metrics.control_energy, 0.25 + 7.0 / 48.0),
        (metrics.total_variation, 0.5 + 0.25),
        (metrics.peak, 0.5),
    ] {
        assert!((computed.unwrap() - wanted).abs() < 4e-15, "{computed:?} against {wanted}");
    }
}
