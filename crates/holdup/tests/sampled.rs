//! The sampled response against what is known in closed form, against the continuous one, and its invariants.
#![expect(clippy::unwrap_used, reason = "helpers of tests may unwrap")]

use holdup::analysis::response::sampled::{
    Equipment, EquipmentSettings, LoadRamp, SampledLoop, SampledResponse, SampledTrajectory,
};
use holdup::analysis::response::{Scenario, simulate, trajectory};
use holdup::model::notation::{read_controller, read_process};
use holdup::model::{ClosedLoop, Compensator, CompensatorLaw, Controller, Process, Seconds};
use proptest::prelude::*;

fn plain(sample_period: f64) -> EquipmentSettings {
    EquipmentSettings { sample_period, ..EquipmentSettings::default() }
}

fn step(horizon: f64) -> Scenario {
    Scenario::unit_setpoint_step(Seconds(horizon)).unwrap()
}

fn run_with(
    process: &Process,
    controller: &Controller,
    settings: &EquipmentSettings,
    (scenario, ramps): (&Scenario, &[LoadRamp]),
    times: &[f64],
) -> (SampledResponse, SampledTrajectory) {
    let equipment = Equipment::new(settings.clone()).unwrap();
    SampledLoop::new(process, controller, &equipment).unwrap().simulate(scenario, ramps, times).unwrap()
}

fn run(process: &str, controller: &str, settings: &EquipmentSettings, horizon: f64) -> SampledResponse {
    let (process, controller) = (read_process(process).unwrap(), read_controller(controller).unwrap());
    run_with(&process, &controller, settings, (&step(horizon), &[]), &[]).0
}

#[test]
fn p_control_of_an_integrator_is_the_recurrence_by_hand() {
    // K = 2, d = 1.5, h = 0.5: y rises by K·h·u of three samples ago, on a straight line.
    let (gain, kc, h) = (2.0, 0.15, 0.5);
    let mut y = vec![0.0; 4];
    for k in 3..40 {
        y.push(y[k] + gain * h * kc * (1.0 - y[k - 3]));
    }
    let times: Vec<f64> = (0..=40).map(|k| f64::from(k) * h).collect();
    let (process, controller) = (read_process("K=2,d=1.5").unwrap(), read_controller("Kc=0.15").unwrap());
    let (response, signals) = run_with(&process, &controller, &plain(h), (&step(20.0), &[]), &times);
    for (found, expected) in signals.signals.controlled_variable.iter().zip(&y) {
        assert!((found - expected).abs() < 1e-14, "{found} {expected}"); // 40 additions of rounded terms
    }
    let (mut iae, mut ise, mut energy, mut variation, mut u_before) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for pair in y.windows(2) {
        let (a, b) = (1.0 - pair[0], 1.0 - pair[1]);
        iae += h * if a * b < 0.0 { 0.5 * (a * a + b * b) / (b - a).abs() } else { 0.5 * (a + b).abs() };
        ise += h * (a * a + a * b + b * b) / 3.0;
        let u: f64 = kc * a;
        energy += h * u * u;
        variation += (u - u_before).abs();
        u_before = u;
    }
    variation += (kc * (1.0 - y[40]) - u_before).abs(); // the sample at the horizon is taken and held for no time
    let metrics = response.response.metrics;
    assert!((metrics.iae.unwrap() - iae).abs() < 1e-13);
    assert!((metrics.ise.unwrap() - ise).abs() < 1e-13);
    assert!((metrics.control_energy.unwrap() - energy).abs() < 1e-13);
    assert!((metrics.valve_travel.unwrap() - variation).abs() < 1e-13);
}

#[test]
fn a_predictor_with_the_deadbeat_gain_reaches_the_setpoint_in_one_sample() {
    // Kr = 1/(K·h): the prediction is at the setpoint after one sample, the output one dead time later. A straight
    // line over one sample: IAE = d + h/2, ISE = d + h/3, whatever fraction of a sample the dead time is.
    for (gain, d, h) in [(0.5, 2.0, 0.5), (-3.0, 1.7, 0.4), (1.0, 1.0, 1.0)] {
        let law = CompensatorLaw::ModifiedSmith {
            main_gain: 1.0 / (gain * h),
            disturbance_gain: 0.3 / (gain * d),
            lead: None,
        };
        let process = Process::integrating(gain, Seconds(d)).unwrap();
        let controller = Controller::from(Compensator::new(law, gain, Seconds(d)).unwrap());
        let (response, _) = run_with(&process, &controller, &plain(h), (&step(20.0), &[]), &[]);
        let metrics = response.response.metrics;
        // 1e-12: the remainder of a perfect model is rounding, fed back 50 times.
        assert!((metrics.iae.unwrap() - (d + 0.5 * h)).abs() < 1e-12, "{metrics:?}");
        assert!((metrics.ise.unwrap() - (d + h / 3.0)).abs() < 1e-12);
        assert!((metrics.rise_time.unwrap().0 - 0.8 * h).abs() < 1e-12);
        assert!((metrics.total_variation.unwrap() - 2.0 / (gain * h).abs()).abs() < 1e-11);
    }
}

#[test]
fn a_load_ramp_leaves_a_pi_loop_an_error_of_ti_by_kc_times_its_rate() {
    let process = read_process("K=0.8,d=1").unwrap();
    let pi = read_controller("Kc=0.4,Ti=8").unwrap();
    let scenario = Scenario::new(vec![(0.0, 0.0)], vec![], Seconds(400.0), 0.0).unwrap();
    let ramp = LoadRamp::new(1.3, 400.0, 3.0).unwrap();
    let (response, _) = run_with(&process, &pi, &plain(0.3), (&scenario, &[ramp]), &[]);
    let error = 3.0 / 398.7 * 8.0 / 0.4;
    // At the samples the error is that; between them the held output leaves a parabola of rate·K·h²/8 = 7e-5.
    assert!((response.response.final_controlled_variable - error).abs() < 1e-4);
}

#[test]
fn an_observer_takes_a_load_ramp_of_two_ends_away() {
    let process = read_process("K=0.0506,d=6").unwrap();
    let controller = read_controller("Kc=1.5321,Td=1.0343,N=100,Ko=0.7").unwrap();
    let scenario = Scenario::new(vec![], vec![(20.0, 1.0)], Seconds(600.0), 2.0).unwrap();
    let ramp = LoadRamp::new(100.0, 150.0, -3.0).unwrap();
    let (response, signals) =
        run_with(&process, &controller, &plain(0.5), (&scenario, &[ramp]), &[600.0, 125.0]);
    // The slowest pole decays like e^(−0.03·t): 450 s after the ramp's end nothing is left.
    assert!((response.response.final_controlled_variable - 2.0).abs() < 1e-4);
    assert!((signals.signals.load_estimate.as_ref().unwrap()[0] + 2.0).abs() < 1e-4);
    assert!((signals.signals.load[1] + 0.5).abs() < 1e-12);
}

#[test]
fn a_computation_delay_acts_like_dead_time_before_a_setpoint_step() {
    let (controller, horizon) = ("Kc=0.3,Ti=9,Td=0.4,N=10", 40.0);
    // A part of a sample, and a whole one.
    for (computation_delay, process) in [(0.15, "K=1,d=1.15"), (0.4, "K=1,d=1.4")] {
        let delayed = EquipmentSettings { computation_delay, ..plain(0.4) };
        let a = run("K=1,d=1", controller, &delayed, horizon).response.metrics;
        let b = run(process, controller, &plain(0.4), horizon).response.metrics;
        for (a, b) in [(a.iae, b.iae), (a.ise, b.ise), (a.itae, b.itae), (a.overshoot, b.overshoot)] {
            assert!((a.unwrap() / b.unwrap() - 1.0).abs() < 1e-12); // the same numbers in another order
        }
    }
}

/// Largest difference of the controlled variable from the continuous response at whole seconds.
fn distance(process: &Process, controller: &Controller, scenario: &Scenario, h: f64) -> f64 {
    let times: Vec<f64> = (0..=40).map(f64::from).collect();
    let exact = trajectory(&ClosedLoop::new(process, controller), scenario, &times).unwrap();
    let (_, sampled) = run_with(process, controller, &plain(h), (scenario, &[]), &times);
    let pairs = exact.controlled_variable.iter().zip(&sampled.signals.controlled_variable);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn the_sampled_loop_tends_to_the_exact_continuous_one_in_first_order() {
    let scenario = Scenario::new(vec![(0.0, 1.0)], vec![(20.0, 0.2)], Seconds(40.0), 0.0).unwrap();
    let smith = CompensatorLaw::ModifiedSmith { main_gain: 1.0, disturbance_gain: 0.4, lead: None };
    let smith = Controller::from(Compensator::new(smith, 1.0, Seconds(1.0)).unwrap());
    let read = |text| read_controller(text).unwrap();
    for (process, controller) in [
        ("K=1,d=1", read("Kc=0.4")),
        ("K=1,d=1", read("Kc=0.4,Ti=8,b=0.6")),
        ("K=1,d=1", read("Kc=0.4,Td=0.4,Tf=0.2")),
        ("K=1,d=1", read("Kc=0.4,Td=0.4,c=0")),
        ("K=-1,d=1", read("Kc=-0.4,Ti=8,Td=0.4,Tf=0.2,c=0")),
        ("K=1,d=1", read("Kc=0.4,Td=0.4,Tf=0.2,Ko=0.3")),
        ("K=1,d=1", read("Kc=0.4,Ko=0.3,Km=0.8,dm=1.3")),
        ("K=1,d=1,T=0.7", read("Kc=0.3,Ti=10,Td=0.8,Tf=0.2")),
        ("K=0.2,d=1,integrators=2", read("Kc=0.15,Td=6,Tf=0.5")),
        ("K=0.2,d=1,T=0.1,integrators=2", read("Kc=0.1,Td=6,Tf=0.5")),
        ("K=1,d=1", smith),
    ] {
        let process = read_process(process).unwrap();
        // 0.013 s is no fraction of the dead time.
        let errors = [0.052, 0.026, 0.013].map(|h| distance(&process, &controller, &scenario, h));
        assert!(errors[0] < 0.1, "{controller:?} {errors:?}");
        // Half the sample period, half the error; terms of second order leave this much.
        for pair in errors.windows(2) {
            assert!((1.7..2.4).contains(&(pair[0] / pair[1])), "{controller:?} {errors:?}");
        }
    }
}

#[test]
fn metrics_scale_with_time_and_gain_and_do_not_know_the_sign_of_the_process() {
    let reference = run("K=0.5,d=2", "Kc=0.5,Ti=12,Td=1,Tf=0.3,Ko=0.2", &plain(0.3), 60.0).response.metrics;
    let turned = run("K=-0.5,d=2", "Kc=-0.5,Ti=12,Td=1,Tf=0.3,Ko=-0.2", &plain(0.3), 60.0).response.metrics;
    // Time by 10, gain by 1/7: IAE by 10, ITAE by 100, u by 0.7.
    let slow = run(
        "K=0.35,d=20",
        "Kc=0.07142857142857142,Ti=120,Td=10,Tf=3,Ko=0.02857142857142857",
        &plain(3.0),
        600.0,
    );
    let slow = slow.response.metrics;
    let near = |a: Option<f64>, b: Option<f64>, factor: f64| {
        assert!((a.unwrap() / b.unwrap() / factor - 1.0).abs() < 1e-11, "{a:?} {b:?}"); // 200 samples of rounding
    };
    near(turned.iae, reference.iae, 1.0);
    near(turned.valve_travel, reference.valve_travel, 1.0);
    near(slow.iae, reference.iae, 10.0);
    near(slow.itae, reference.itae, 100.0);
    near(slow.overshoot, reference.overshoot, 1.0);
    near(slow.total_variation, reference.total_variation, 1.0 / 7.0);
}

#[test]
fn the_seed_decides_what_is_random_and_nothing_else() {
    let controller = "Kc=1.5321,Td=1.0343,N=2,Ko=0.7";
    let of = |settings: EquipmentSettings| run("K=0.0506,d=6", controller, &settings, 100.0).response.metrics;
    let seeded = |seed, noise| of(EquipmentSettings { seed, noise, drop: 0.1 * noise, ..plain(0.5) });
    assert_eq!(seeded(1, 0.1), seeded(1, 0.1));
    assert_ne!(seeded(1, 0.1), seeded(2, 0.1));
    assert_eq!(seeded(1, 0.0), seeded(2, 0.0));
}

#[test]
fn noise_through_an_open_output_has_the_variance_of_the_law() {
    // A process gain so small that nothing comes back: u = −Kc·noise, energy = Kc²·variance·time.
    let settings = EquipmentSettings { noise: 0.5, seed: 3, ..plain(0.01) };
    let scenario = Scenario::new(vec![(0.0, 0.0)], vec![], Seconds(1000.0), 0.0).unwrap();
    let (process, p) = (read_process("K=1e-9,d=1").unwrap(), read_controller("Kc=2").unwrap());
    let energy = run_with(&process, &p, &settings, (&scenario, &[]), &[]).0.response.metrics.control_energy;
    // 1e5 squares of deviation √2 each: five deviations of their mean are 2.2 %.
    assert!((energy.unwrap() / 1000.0 - 1.0).abs() < 0.023, "{energy:?}");
}

#[test]
fn lost_measurements_are_counted_and_late_ones_change_little() {
    let settings = EquipmentSettings { drop: 0.2, seed: 7, ..plain(0.1) };
    let response = run("K=1,d=1", "Kc=0.4,Ti=8", &settings, 100.0);
    assert_eq!(response.samples, 1001);
    assert!((150..250).contains(&response.lost_samples), "{response:?}"); // 200 ± 4 deviations of 12.6
    let regular = run("K=1,d=1", "Kc=0.4,Ti=8", &plain(0.1), 100.0).response.metrics.iae.unwrap();
    let jitter = EquipmentSettings { jitter: 0.05, seed: 7, ..plain(0.1) };
    let late = run("K=1,d=1", "Kc=0.4,Ti=8", &jitter, 100.0).response.metrics.iae.unwrap();
    // The mean lateness of 0.025 s is that much more dead time, of 1.05 s.
    assert!((late / regular - 1.0).abs() < 0.04, "{late} {regular}");
}

#[test]
fn stiction_makes_a_pi_loop_cycle_and_a_deadband_travels_less_than_it_is_told() {
    let quiet = run("K=1,d=1", "Kc=0.4,Ti=8", &plain(0.1), 400.0).response.metrics;
    let settings = EquipmentSettings { stiction: Some((0.2, 0.1)), ..plain(0.1) };
    let sticky = run("K=1,d=1", "Kc=0.4,Ti=8", &settings, 400.0).response.metrics;
    // The limit cycle never ends: its variation grows with time, that of the quiet loop does not.
    assert!(sticky.total_variation.unwrap() > 3.0 * quiet.total_variation.unwrap());
    assert!(sticky.settling_time.is_none() || sticky.iae > quiet.iae);
    assert!((quiet.valve_travel.unwrap() / quiet.total_variation.unwrap() - 1.0).abs() < 1e-12);
    let band = EquipmentSettings { stiction: Some((0.2, 0.0)), ..plain(0.1) };
    let band = run("K=1,d=1", "Kc=0.4", &band, 100.0).response.metrics;
    assert!(band.valve_travel.unwrap() < band.total_variation.unwrap());
}

#[test]
fn a_rate_limited_valve_moves_no_faster_and_the_law_knows_it() {
    let settings = EquipmentSettings { rate_limit: Some(0.1), ..plain(0.25) };
    let (process, pi) = (read_process("K=1,d=1").unwrap(), read_controller("Kc=0.4,Ti=8").unwrap());
    let times: Vec<f64> = (0..=4000).map(|k| 0.01 * f64::from(k)).collect();
    let (response, signals) = run_with(&process, &pi, &settings, (&step(40.0), &[]), &times);
    for pair in signals.valve_position.windows(2) {
        assert!((pair[1] - pair[0]).abs() <= 0.1 * 0.01 * (1.0 + 1e-9)); // differences of rounded times
    }
    assert!(response.limited_samples > 0);
    assert!(response.response.final_controlled_variable > 0.9);
}

#[test]
fn a_loop_without_sampling_errors_has_the_same_bounds() {
    let sampled = run("K=0.0506,d=6", "Kc=1.647,Ti=48", &plain(0.05), 300.0).response.metrics;
    let closed =
        ClosedLoop::new(&read_process("K=0.0506,d=6").unwrap(), &read_controller("Kc=1.647,Ti=48").unwrap());
    let continuous = simulate(&closed, &step(300.0)).unwrap().metrics;
    // h/2 of dead time more, of 6 s: below 1 %.
    assert!((sampled.iae.unwrap() / continuous.iae.unwrap() - 1.0).abs() < 0.01);
    assert!((sampled.control_energy.unwrap() / continuous.control_energy.unwrap() - 1.0).abs() < 0.01);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn limits_are_never_exceeded_whatever_the_equipment(
        (kc, ti, ko) in (0.1f64..3.0, 1.0f64..30.0, 0.05f64..1.0),
        (low, high, rate) in (-2.0f64..-0.1, 0.1f64..2.0, 0.05f64..2.0),
        (noise, drop, jitter, quantum) in (0.0f64..0.5, 0.0f64..0.5, 0.0f64..0.2, 0.01f64..0.7),
        (seed, load) in (0u64..1000, -3.0f64..3.0),
    ) {
        let settings = EquipmentSettings {
            limits: Some((low + 5.0, high + 5.0)),
            rate_limit: Some(rate),
            initial_manipulated: 5.0,
            stiction: Some((0.1, 0.05)),
            output_quantum: Some(quantum),
            noise, drop, jitter, seed,
            computation_delay: 0.05,
            ..plain(0.25)
        };
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let controller = read_controller(&format!("Kc={kc},Ti={ti},Td=0.3,Tf=0.1,Ko={ko}")).unwrap();
        let scenario = Scenario::new(vec![(0.0, 1.0)], vec![(10.0, load)], Seconds(30.0), 0.0).unwrap();
        let times: Vec<f64> = (0..=600).map(|k| 0.05 * f64::from(k)).collect();
        let (response, signals) = run_with(&process, &controller, &settings, (&scenario, &[]), &times);
        // The limits are met in deviations from rest: adding the rest again is one rounding.
        let allowed = low + 5.0 - 1e-14 ..= high + 5.0 + 1e-14;
        for values in [&signals.signals.manipulated_variable, &signals.valve_position] {
            prop_assert!(values.iter().all(|value| allowed.contains(value)));
        }
        prop_assert!(response.response.metrics.iae.is_some());
    }
}
