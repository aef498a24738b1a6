//! What must hold for every loop: superposition, scaling, identities, bounds, and an answer to everything.

#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use holdup::analysis::bounds::Bounds;
use holdup::analysis::metrics::METRICS;
use holdup::analysis::response::{
    Response, ResponseError, Scenario, plot_times, simulate, simulate_with_trajectory, trajectory,
};
use holdup::model::{ClosedLoop, Controller, Observer, Process, Seconds};
use proptest::prelude::*;

fn process(k: f64, d: f64) -> Process {
    Process::integrating(k, Seconds(d)).unwrap()
}

fn pid(kc: f64, ti: f64, td: f64, n: f64) -> Controller {
    let pid = Controller::proportional(kc).unwrap().with_integral_time(Seconds(ti)).unwrap();
    pid.with_derivative_time(Seconds(td)).unwrap().with_filter_bandwidth(n).unwrap()
}

fn scenario(setpoint: &[(f64, f64)], load: &[(f64, f64)], horizon: f64) -> Scenario {
    Scenario::new(setpoint.to_vec(), load.to_vec(), Seconds(horizon), 0.0).unwrap()
}

fn run(k: f64, d: f64, controller: &Controller, scenario: &Scenario) -> Response {
    simulate(&ClosedLoop::new(&process(k, d), controller), scenario).unwrap()
}

#[test]
fn the_integral_of_the_error_after_a_load_step_is_what_the_controller_fixes() {
    // No sign change, so that IAE = |∫e|. PI: Ti/Kc. PD + observer: 1/(K·Kc·Ko). 1e-12: the tail beyond the horizon is nothing.
    let load = scenario(&[], &[(0.0, 1.0)], 20_000.0);
    let pi = Controller::proportional(0.8).unwrap().with_integral_time(Seconds(120.0)).unwrap();
    assert!((run(0.0506, 6.0, &pi, &load).metrics.iae.unwrap() / 150.0 - 1.0).abs() < 1e-12);
    let observed = Controller::proportional(0.8).unwrap().with_observer(Observer::new(0.7).unwrap());
    let exact = 1.0 / (0.0506 * 0.8 * 0.7);
    assert!((run(0.0506, 6.0, &observed, &load).metrics.iae.unwrap() / exact - 1.0).abs() < 1e-12);
}

#[test]
fn proportional_control_keeps_the_offset_that_the_load_needs_to_any_horizon() {
    let p = Controller::proportional(0.8).unwrap();
    let response = run(0.0506, 6.0, &p, &scenario(&[], &[(0.0, 1.0)], 1e9));
    assert!((response.final_controlled_variable - 1.25).abs() < 1e-15);
    assert_eq!(response.final_manipulated_variable, -1.0);
    // Offset 1/Kc but for the first instants, whose area is below 1e3 of 1.25e9.
    assert!((response.metrics.iae.unwrap() / 1.25e9 - 1.0).abs() < 1e-6);
}

#[test]
fn an_event_after_a_long_rest_gives_what_it_gives_at_once() {
    let late = run(0.0506, 6.0, &pid(2.0, 40.0, 1.0, 50.0), &scenario(&[(5e8, 1.0)], &[], 1e9)).metrics;
    let now = run(0.0506, 6.0, &pid(2.0, 40.0, 1.0, 50.0), &scenario(&[(0.0, 1.0)], &[], 5e8)).metrics;
    // 1e-7 s is the rounding of times near 5e8 s.
    assert!((late.iae.unwrap() / now.iae.unwrap() - 1.0).abs() < 1e-9);
    assert!((late.ise.unwrap() / now.ise.unwrap() - 1.0).abs() < 1e-9);
    assert!((late.settling_time.unwrap().0 - now.settling_time.unwrap().0).abs() < 2e-7);
}

#[test]
fn a_loop_that_does_not_settle_within_the_budget_names_the_horizon() {
    // κ = π/2 (rounded): an oscillation that practically never decays.
    let p = Controller::proportional(std::f64::consts::FRAC_PI_2).unwrap();
    let closed = ClosedLoop::new(&process(1.0, 1.0), &p);
    let error = simulate(&closed, &scenario(&[(0.0, 1.0)], &[], 1e9)).unwrap_err();
    assert!(matches!(error, ResponseError::HorizonTooLong { .. }) && error.to_string().contains("--horizon"));
}

#[test]
fn ten_thousand_dead_times_of_a_slow_oscillation_keep_their_accuracy() {
    // P control with κ = 1.57: the dominant pole s = −κ·e^{−s}, and its residue, by Newton in complex numbers:
    // y → 1 + 2·Re(c·e^{st}), e(t) = −2·Re(c·e^{st}), c = κe^{−s}/(s(1 + s)·…): from y(s) = κe^{−s}/(s(s + κe^{−s})).
    use num_complex::Complex64;
    let kappa = 1.57;
    let mut s = Complex64::new(-1e-4, 1.57);
    for _ in 0..50 {
        let delayed = kappa * (-s).exp();
        s -= (s + delayed) / (1.0 - delayed);
    }
    let residue = kappa * (-s).exp() / (s * (1.0 - kappa * (-s).exp()));
    let closed = ClosedLoop::new(&process(1.0, 1.0), &Controller::proportional(kappa).unwrap());
    let times = [5000.0, 9000.3, 9999.9];
    let path = trajectory(&closed, &scenario(&[(0.0, 1.0)], &[], 10_000.0), &times).unwrap();
    for (t, y) in times.iter().zip(&path.controlled_variable) {
        let exact = 1.0 + 2.0 * (residue * (s * t).exp()).re;
        // 1e-10: e^{st} at t = 1e4 carries the rounding of s times t, 1e-12; the other poles are long gone.
        assert!((y - exact).abs() < 1e-10, "t = {t}: {y} against {exact}");
    }
}

#[test]
fn an_unstable_loop_overflows_at_a_stated_time() {
    let response = run(1.0, 1.0, &Controller::proportional(5.0).unwrap(), &scenario(&[(0.0, 1.0)], &[], 1e6));
    // The dominant pole of κ = 5, d = 1 is 0.70 ± 1.89i (W₀(−5)): e^{0.7·t} leaves the range of 1e308 near 1000 s.
    let time = response.overflow_at.unwrap().0;
    assert!((700.0..1400.0).contains(&time), "{time}");
    assert!(METRICS.iter().all(|m| (m.value)(&response.metrics).is_none()));
    assert!(response.warnings[0].contains("unstable") && response.final_controlled_variable.is_finite());
}

#[test]
fn neutral_loops_near_and_beyond_their_limit_get_an_answer() {
    for product in [0.9, 0.99, 0.999, 1.0, 1.1, 30.0] {
        let kc = 0.3;
        let pd = Controller::proportional(kc).unwrap().with_derivative_time(Seconds(product / kc)).unwrap();
        let closed = ClosedLoop::new(&process(1.0, 1.0), &pd);
        for scenario in [scenario(&[(0.0, 1.0)], &[], 300.0), scenario(&[], &[(0.0, 1.0)], 300.0)] {
            let response = simulate(&closed, &scenario).unwrap();
            assert!(response.metrics.iae.is_some() || response.overflow_at.is_some(), "{product}");
        }
    }
}

#[test]
fn a_model_dead_time_that_nears_the_process_s_gives_the_same_response() {
    let pd = pid(1.2, 60.0, 0.7, 100.0);
    let of = |observer: Observer| {
        run(0.0506, 6.0, &pd.with_observer(observer), &scenario(&[(0.0, 1.0)], &[(100.0, 1.0)], 1200.0))
    };
    let observer = Observer::new(0.5).unwrap();
    let same = of(observer).metrics;
    for off in [1e-6, 1e-9, 1e-12] {
        let near = of(observer.with_model_dead_time(Seconds(6.0 * (1.0 + off))).unwrap()).metrics;
        for metric in METRICS {
            if let (Some(a), Some(b)) = ((metric.value)(&same), (metric.value)(&near)) {
                // 100·off: sensitivities to the dead time are of size 10; 1e-9 is the promise.
                assert!((a / b - 1.0).abs() < 100.0 * off + 1e-9, "{} {off}: {a} {b}", metric.name);
            }
        }
    }
}

#[test]
fn an_exactly_equal_model_dead_time_given_by_hand_changes_nothing() {
    let pd = pid(1.2, 60.0, 0.7, 100.0);
    let observer = Observer::new(0.5).unwrap();
    let given = observer.with_model_dead_time(Seconds(6.0)).unwrap();
    let step = scenario(&[(0.0, 1.0)], &[(100.0, 1.0)], 600.0);
    assert_eq!(
        run(0.0506, 6.0, &pd.with_observer(observer), &step).metrics,
        run(0.0506, 6.0, &pd.with_observer(given), &step).metrics
    );
}

#[test]
fn the_load_estimate_reaches_the_load() {
    let observed = Controller::proportional(0.8).unwrap().with_observer(Observer::new(0.7).unwrap());
    let closed = ClosedLoop::new(&process(0.0506, 6.0), &observed);
    let path = trajectory(&closed, &scenario(&[], &[(1.0, -2.0)], 5000.0), &[0.5, 4999.0]).unwrap();
    let estimate = path.load_estimate.unwrap();
    assert_eq!((estimate[0], path.load), (0.0, vec![0.0, -2.0]));
    assert!((estimate[1] + 2.0).abs() < 1e-12);
}

#[test]
fn trajectories_do_not_depend_on_the_order_or_number_of_times_and_are_right_continuous() {
    let closed = ClosedLoop::new(&process(0.0506, 6.0), &pid(2.95, 15.0, 3.0, 100.0));
    let step = Scenario::new(vec![(10.0, 1.5)], vec![(50.0, 1.0)], Seconds(100.0), 1.0).unwrap();
    let dense: Vec<f64> = (0..=10_000).map(|i| f64::from(i) * 0.01).collect();
    let (_, all) = simulate_with_trajectory(&closed, &step, &dense).unwrap();
    let few = [dense[7777], dense[1000], dense[10_000], dense[1601], dense[999]];
    let some = trajectory(&closed, &step, &few).unwrap();
    for (i, index) in [7777, 1000, 10_000, 1601, 999].into_iter().enumerate() {
        // 1e-12 of u's 888: a batch of points is compiled to other instructions than a single one.
        assert!((some.controlled_variable[i] - all.controlled_variable[index]).abs() < 1e-14);
        assert!((some.manipulated_variable[i] - all.manipulated_variable[index]).abs() < 1e-9);
    }
    assert_eq!((some.setpoint[1], some.setpoint[4], some.manipulated_variable[4]), (1.5, 1.0, 0.0));
    // 0.5·Kc·(1 + Td·N) at the step; 1e-12 relative: rounding.
    assert!((some.manipulated_variable[1] / (0.5 * 2.95 * 301.0) - 1.0).abs() < 1e-12);
    assert_eq!(some.controlled_variable[4], 1.0);
}

#[test]
fn plot_times_contain_both_sides_of_every_breakpoint() {
    let closed = ClosedLoop::new(&process(1.0, 1.0), &Controller::proportional(0.5).unwrap());
    let times = plot_times(&closed, &scenario(&[(0.5, 1.0)], &[], 3.0), 7);
    assert!(times.is_sorted() && times.contains(&1.5) && times.iter().any(|t| *t < 1.5 && *t > 1.499_999));
    assert!(trajectory(&closed, &scenario(&[(0.5, 1.0)], &[], 3.0), &times).is_ok());
}

#[test]
fn times_outside_the_horizon_are_refused() {
    let closed = ClosedLoop::new(&process(1.0, 1.0), &Controller::proportional(0.5).unwrap());
    for time in [-1.0, 10.1, f64::NAN] {
        assert!(matches!(
            trajectory(&closed, &scenario(&[(0.0, 1.0)], &[], 10.0), &[time]),
            Err(ResponseError::TimeOutside { .. })
        ));
    }
}

fn relative(a: Option<f64>, b: Option<f64>) -> f64 {
    match (a, b) {
        (Some(a), Some(b)) if a == b => 0.0,
        (Some(a), Some(b)) => (a - b).abs() / a.abs().max(b.abs()),
        (None, None) => 0.0,
        _ => f64::INFINITY,
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// Time stretched by a, gains divided by b: times and integrals follow. And K → −K with Kc → −Kc changes nothing in y.
    #[test]
    fn metrics_scale_with_time_and_gain(kappa in 0.2..0.7f64, ti in 3.0..20.0f64, td in 0.05..0.4f64, n in 5.0..200.0f64, a in 0.01..100.0f64, b in -50.0..50.0f64) {
        prop_assume!(b.abs() > 0.02);
        let step = |a: f64| scenario(&[(0.0, 1.0)], &[], 60.0 * a);
        let one = run(1.0, 1.0, &pid(kappa, ti, td, n), &step(1.0)).metrics;
        let other = run(b / a, a, &pid(kappa / b, ti * a, td * a, n / a), &step(a)).metrics;
        // 1e-9: the promise for the integrals; measured differences are near 1e-13.
        prop_assert!(relative(one.iae.map(|v| v * a), other.iae) < 1e-10);
        prop_assert!(relative(one.ise.map(|v| v * a), other.ise) < 1e-10);
        prop_assert!(relative(one.itae.map(|v| v * a * a), other.itae) < 1e-10);
        prop_assert!(relative(one.control_energy.map(|v| v * a / b / b), other.control_energy) < 1e-10);
        prop_assert!(relative(one.total_variation.map(|v| v / b.abs()), other.total_variation) < 1e-9);
        prop_assert!(relative(one.settling_time.map(|v| v.0 * a), other.settling_time.map(|v| v.0)) < 1e-9);
        prop_assert!((one.overshoot.unwrap() - other.overshoot.unwrap()).abs() < 1e-10);
    }

    /// The response to setpoint and load together is the sum of the two, at any event times.
    #[test]
    fn responses_superpose(kappa in 0.2..0.7f64, ti in 3.0..20.0f64, td in 0.0..0.4f64, at in 0.0..9.0f64, when in 0.0..9.0f64, load in -3.0..3.0f64) {
        let closed = ClosedLoop::new(&process(1.0, 1.0), &pid(kappa, ti, td, 50.0));
        let times: Vec<f64> = (0..200).map(|i| f64::from(i) * 0.15).collect();
        let path = |setpoint: &[(f64, f64)], load: &[(f64, f64)]| trajectory(&closed, &scenario(setpoint, load, 31.0), &times).unwrap();
        let (both, servo, regulatory) = (path(&[(at, 1.0)], &[(when, load)]), path(&[(at, 1.0)], &[]), path(&[(at, 0.0)], &[(when, load)]));
        for (i, y) in both.controlled_variable.iter().enumerate() {
            let sum = servo.controlled_variable[i] + regulatory.controlled_variable[i];
            // 1e-12: rounding and the cells' tolerance.
            prop_assert!((y - sum).abs() < 1e-12, "t = {}", times[i]);
        }
    }

    /// No controller beats the bounds: stable, unstable, with or without observer, lag, second integrator.
    #[test]
    fn no_random_controller_beats_the_bounds(
        kappa in 0.01..3.0f64, ti in 0.3..50.0f64, td in 0.0..3.0f64, n in 0.5..200.0f64, ko in 0.01..2.0f64,
        lag in 0.01..20.0f64, kind in 0..5, is_load: bool,
    ) {
        let plain = process(-2.0, 1.5);
        let plant = match kind {
            3 => plain.with_lag(Seconds(lag)).unwrap(),
            4 => Process::double_integrating(-2.0, Seconds(1.5)).unwrap(),
            _ => plain,
        };
        let kc = kappa / -3.0;
        let controller = match kind {
            0 => Controller::proportional(kc).unwrap(),
            1 => pid(kc, ti, td, n).with_observer(Observer::new(-ko).unwrap()),
            2 => Controller::proportional(kc).unwrap().with_derivative_time(Seconds(td)).unwrap(),
            _ => pid(kc, ti, td, n),
        };
        let scenario = if is_load { scenario(&[], &[(1.0, 2.0)], 40.0) } else { scenario(&[(1.0, 2.0)], &[], 40.0) };
        let response = simulate(&ClosedLoop::new(&plant, &controller), &scenario).unwrap();
        let bounds = Bounds::of(&plant, &scenario);
        let m = response.metrics;
        for (value, bound) in [(m.iae, bounds.iae), (m.ise, bounds.ise), (m.itae, bounds.itae), (m.peak, bounds.peak)] {
            if let (Some(value), Some(bound)) = (value, bound) {
                // 1e-12: rounding where a bound is attained.
                prop_assert!(value >= bound * (1.0 - 1e-12), "{value} beats {bound}: {bounds:?} {m:?}");
            }
        }
    }

    /// Whatever the numbers, there is a response or an error, soon, and no NaN.
    #[test]
    fn absurd_loops_get_an_answer(
        k in -4.0..4.0f64, d in -4.0..4.0f64, kc in -4.0..4.0f64, ti in -4.0..4.0f64, td in -4.0..4.0f64,
        n in -4.0..4.0f64, dm in -0.5..0.5f64, kind in 0..5, load in -100.0..100.0f64,
    ) {
        let power = |x: f64| 10f64.powf(x);
        let plant = process(power(k), power(d));
        let p = Controller::proportional(power(kc)).unwrap();
        let controller = match kind {
            0 => pid(power(kc), power(ti), power(td), power(n)),
            1 => p.with_derivative_time(Seconds(power(td))).unwrap(),
            2 => p.with_integral_time(Seconds(power(ti))).unwrap().with_output_filter(power(td), power(n)).unwrap(),
            3 => p.with_observer(Observer::new(power(td)).unwrap()),
            _ => p.with_observer(Observer::new(power(td)).unwrap().with_model_dead_time(Seconds(power(d + dm))).unwrap()),
        };
        let horizon = 50.0 * power(d);
        let scenario = Scenario::new(vec![(0.0, 1.0)], vec![(horizon / 3.0, load)], Seconds(horizon), 0.0).unwrap();
        let start = std::time::Instant::now();
        let answer = simulate(&ClosedLoop::new(&plant, &controller), &scenario);
        // The budget of cells takes two seconds at most on an idle machine: 20 s is a hang even on a busy one.
        prop_assert!(start.elapsed().as_secs_f64() < 20.0, "{plant:?} {controller:?} {:?}", start.elapsed());
        if let Ok(response) = answer {
            prop_assert!(response.final_controlled_variable.is_finite(), "{response:?}");
            prop_assert!(METRICS.iter().all(|m| (m.value)(&response.metrics).is_none_or(f64::is_finite)));
        }
    }
}
