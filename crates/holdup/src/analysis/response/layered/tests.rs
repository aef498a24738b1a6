//! The fast way against the Legendre cells.

use proptest::prelude::*;

use super::super::measure::Measure;
use super::super::solver::Solver;
use super::super::{Integrals, Response, Trajectory, measure_of, refill_trajectory, response};
use super::*;
use crate::analysis::batch::{integrals_over_controllers, integrals_over_processes};
use crate::analysis::metrics::METRICS;
use crate::model::{ClosedLoop, Controller, Observer, Process, Seconds};

fn level() -> Process {
    Process::integrating(0.0506, Seconds(6.0)).unwrap()
}

fn pid(kc: f64, ti: f64, td: f64, n: f64) -> Controller {
    let pid = Controller::proportional(kc).unwrap().with_integral_time(Seconds(ti)).unwrap();
    pid.with_derivative_time(Seconds(td)).unwrap().with_filter_bandwidth(n).unwrap()
}

fn servo_and_load(horizon: f64, load_at: f64) -> Scenario {
    Scenario::new(vec![(0.0, 1.0)], vec![(load_at, 1.0)], Seconds(horizon), 0.0).unwrap()
}

/// Both answers; `None` where the fast way declines.
fn both(closed: &ClosedLoop, scenario: &Scenario) -> (Option<Response>, Response) {
    let system = System::new(closed);
    let (mut fast, mut general): (Measure, Measure) = (measure_of(scenario), measure_of(scenario));
    let outcome = run(closed, scenario, &mut fast);
    let fast = outcome.map(|outcome| response(scenario, fast, outcome.unwrap()));
    let outcome = Solver::new(&system).run(scenario, &mut general).unwrap();
    (fast, response(scenario, general, outcome))
}

#[track_caller]
fn agree(fast: &Response, general: &Response, tolerance: f64) {
    for metric in METRICS {
        let (ours, theirs) = ((metric.value)(&fast.metrics), (metric.value)(&general.metrics));
        assert_eq!(ours.is_some(), theirs.is_some(), "{}: {ours:?} {theirs:?}", metric.name);
        let (Some(ours), Some(theirs)) = (ours, theirs) else { continue };
        assert!(
            (ours - theirs).abs() <= tolerance * theirs.abs().max(1e-3),
            "{}: {ours} {theirs}, {:e}",
            metric.name,
            ours / theirs - 1.0
        );
    }
}

#[test]
fn the_paper_s_loops_take_the_fast_way_and_agree_to_1e_11() {
    let pd = Controller::proportional(1.2).unwrap().with_derivative_time(Seconds(1.0)).unwrap();
    let pd = pd.with_filter_bandwidth(100.0).unwrap();
    let loops = [
        pid(2.95, 15.0, 3.0, 100.0),
        pid(2.95, 15.0, 3.0, 100.0).with_setpoint_weights(0.5, 0.0).unwrap(),
        Controller::proportional(1.6).unwrap().with_integral_time(Seconds(48.0)).unwrap(),
        Controller::proportional(1.6).unwrap(),
        pd,
        pd.with_observer(Observer::new(0.8).unwrap()),
    ];
    for controller in loops {
        let closed = ClosedLoop::new(&level(), &controller);
        for scenario in [servo_and_load(200.0, 100.0), Scenario::unit_setpoint_step(Seconds(301.7)).unwrap()]
        {
            let (fast, general) = both(&closed, &scenario);
            // 1e-11: tolerance of a cell (2e-14) times some hundred cells.
            agree(&fast.expect("one layer"), &general, 1e-11);
        }
    }
}

/// The derivative of the controller output rises from next to nothing where the second setpoint step arrives for the second time:
/// Newton's method from there leads to a zero before the segment. Half the variation of that segment was lost.
#[test]
fn an_extremum_behind_a_zero_next_to_the_start_is_found() {
    let (kc, kappa) = (0.113_818_710_083_647_7, 0.911_328_292_371_977_2);
    let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
    let controller = Controller::proportional(kc).unwrap().with_derivative_time(Seconds(kappa / kc)).unwrap();
    let controller = controller.with_filter_bandwidth(10f64.powf(2.893_092_687_893_388_7)).unwrap();
    let controller = controller.with_setpoint_weights(0.0, 0.787_872_192_975_349_2).unwrap();
    let end = 64.766_430_226_266_38;
    let setpoint = vec![(1.894_763_286_336_944, 1.0), (0.9 * end, 1.689_864_102_150_819_2)];
    let load = vec![(1.145_099_251_150_289_5, 0.7)];
    let scenario = Scenario::new(setpoint, load, Seconds(end), 0.3).unwrap();
    let (fast, general) = both(&ClosedLoop::new(&process, &controller), &scenario);
    // 1e-9 is what both ways promise.
    agree(&fast.expect("one layer"), &general, 1e-9);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// Random loops, scaled by a gain and a time, with any filter, close events and derivative gains up to the neutral limit.
    #[test]
    fn random_loops_agree_to_1e_9(
        (gain, time) in (0.01f64..100.0, 0.01f64..1000.0),
        kc in 0.05f64..1.3,
        ti in prop::option::of(0.8f64..40.0),
        kappa in prop::option::of(0.01f64..0.999),
        filter in -3.5f64..0.3,
        (b, c) in (0.0f64..1.2, 0.0f64..1.2),
        observer in prop::option::weighted(0.2, 0.05f64..0.6),
        lag in prop::option::weighted(0.2, 0.01f64..3.0),
        (step, load, second) in (0.0f64..5.0, 0.0f64..30.0, -2.0f64..2.0),
        horizon in 6.0f64..120.0,
    ) {
        let mut process = Process::integrating(gain, Seconds(time)).unwrap();
        if let Some(lag) = lag {
            process = process.with_lag(Seconds(lag * time)).unwrap();
        }
        let mut controller = Controller::proportional(kc / (gain * time)).unwrap();
        if let Some(ti) = ti {
            controller = controller.with_integral_time(Seconds(ti * time)).unwrap();
        }
        if let Some(kappa) = kappa {
            let controller_with = controller.with_derivative_time(Seconds(kappa / kc * time)).unwrap();
            controller = controller_with.with_filter_bandwidth(10f64.powf(-filter) / time).unwrap();
            controller = controller.with_setpoint_weights(b, c).unwrap();
        }
        if let Some(observer) = observer {
            controller = controller.with_observer(Observer::new(observer / (gain * time)).unwrap());
        }
        let closed = ClosedLoop::new(&process, &controller);
        let end = horizon * time;
        let setpoint = vec![(step * time, 1.0), (0.9 * end, second)];
        let load = vec![((load * time).min(0.8 * end), 0.7 / (gain * time))];
        let servo = Scenario::new(vec![(step * time, -1.5)], vec![], Seconds(end), 0.0).unwrap();
        let busy = Scenario::new(setpoint, load, Seconds(end), 0.3).unwrap();
        for scenario in [servo, busy] {
            let (fast, general) = both(&closed, &scenario);
            if let Some(fast) = fast {
                // 1e-9 is what both ways promise.
                agree(&fast, &general, 1e-9);
            }
        }
    }
}

#[test]
fn thousands_of_dead_times_agree() {
    let pi = Controller::proportional(1.55).unwrap().with_integral_time(Seconds(5e3)).unwrap();
    let loops =
        [Controller::proportional(1.57).unwrap(), pi, pid(1.0, 30.0, 0.3, 300.0), pid(0.5, 30.0, 0.9, 50.0)];
    let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
    for controller in loops {
        let (fast, general) = both(&ClosedLoop::new(&process, &controller), &servo_and_load(3000.0, 1000.4));
        // 1e-10: rounding of 3000 turns of an oscillation that hardly decays.
        agree(&fast.expect("one layer"), &general, 1e-10);
    }
}

#[test]
fn close_pairs_of_roots_of_the_error_are_found() {
    let pi = Controller::proportional(1.6).unwrap().with_integral_time(Seconds(48.0)).unwrap();
    for controller in [pi, pid(2.95, 15.0, 3.0, 100.0), pid(1.6, 30.0, 2.0, 20.0)] {
        let closed = ClosedLoop::new(&level(), &controller);
        let step = Scenario::unit_setpoint_step(Seconds(60.0)).unwrap();
        let overshoot = both(&closed, &step).1.metrics.overshoot.unwrap();
        let times: Vec<f64> = (0..6000).map(|i| 0.01 * f64::from(i)).collect();
        let y = super::super::trajectory(&closed, &step, &times).unwrap().controlled_variable;
        let top = (0..y.len()).max_by(|&i, &j| y[i].total_cmp(&y[j])).unwrap();
        // Half a dead time before the top the setpoint moves up to it: y feels nothing yet, the error touches zero.
        let before = times[top] - 3.0;
        for depth in [1e-2, 1e-3, 1e-4, 1e-5, 1e-7, 0.0, -1e-5] {
            let setpoint = vec![(0.0, 1.0), (before, 1.0 + overshoot - depth)];
            let scenario = Scenario::new(setpoint, vec![], Seconds(60.0), 0.0).unwrap();
            let (fast, general) = both(&closed, &scenario);
            // 1e-11: a pair overlooked at a depth of 1e-5 would be 1e-8 of the integral.
            agree(&fast.expect("one layer"), &general, 1e-11);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    /// Eight loops together, and each alone, against the general way, with any filter and events at any distance.
    #[test]
    fn integrals_of_loops_in_lanes_are_those_of_each_to_1e_9(
        kc in 0.1f64..1.2,
        ti in prop::option::of(1.5f64..40.0),
        kappa in prop::option::of(0.01f64..0.8),
        filter in -3.0f64..0.0,
        weights in (0.0f64..1.2, 0.0f64..1.2),
        spread in prop::collection::vec((0.8f64..1.2, 0.9f64..1.1), 2..20),
        (step, load, horizon) in (0.0f64..5.0, 0.0f64..30.0, 5.0f64..80.0),
    ) {
        let mut controller = Controller::proportional(kc).unwrap();
        if let Some(ti) = ti {
            controller = controller.with_integral_time(Seconds(ti)).unwrap();
        }
        if let Some(kappa) = kappa {
            controller = controller.with_derivative_time(Seconds(kappa / kc)).unwrap();
            controller = controller.with_filter_bandwidth(10f64.powf(-filter)).unwrap();
            controller = controller.with_setpoint_weights(weights.0, weights.1).unwrap();
        }
        let one = |&(gain, time): &(f64, f64)| Process::integrating(gain, Seconds(time)).unwrap();
        let processes: Vec<Process> = spread.iter().map(one).collect();
        let loads = vec![(load.min(0.8 * horizon), 0.7)];
        let scenario = Scenario::new(vec![(step, 1.0)], loads, Seconds(horizon), 0.0).unwrap();
        let together = integrals_over_processes(&processes, &controller, &scenario);
        for (process, together) in processes.iter().zip(together) {
            let closed = ClosedLoop::new(process, &controller);
            let mut general = measure_of(&scenario);
            let outcome = Solver::new(&System::new(&closed)).run(&scenario, &mut general).unwrap();
            let general = Integrals::from(&response(&scenario, general, outcome).metrics);
            for found in [together.unwrap(), super::super::integrals(&closed, &scenario).unwrap()] {
                let pairs = [
                    (found.iae, general.iae),
                    (found.ise, general.ise),
                    (found.itae, general.itae),
                    (found.control_energy, general.control_energy),
                ];
                for (ours, theirs) in pairs {
                    let (ours, theirs) = (ours.unwrap(), theirs.unwrap());
                    // 1e-9 is what both ways promise.
                    prop_assert!((ours - theirs).abs() <= 1e-9 * theirs.abs().max(1e-3), "{ours} {theirs}");
                }
            }
        }
    }
}

#[test]
fn many_loops_are_answered_in_their_order_whatever_the_number_of_threads() {
    let controller = pid(2.95, 15.0, 3.0, 33.3);
    let process = |i: u32| {
        let [gain, time] =
            [0.754_877_666_246_692_7, 0.569_840_290_998_053_2].map(|x| (f64::from(i) * x).fract());
        Process::integrating(0.0506 * (0.8 + 0.4 * gain), Seconds(6.0 * (0.8 + 0.4 * time))).unwrap()
    };
    let processes: Vec<Process> = (0..300).map(process).collect();
    let scenario = servo_and_load(200.0, 100.0);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| integrals_over_processes(&processes, &controller, &scenario))
    };
    let found = on(1);
    assert_eq!(found, on(3));
    for (process, found) in processes.iter().zip(&found) {
        let alone = super::super::integrals(&ClosedLoop::new(process, &controller), &scenario).unwrap();
        let (ours, theirs) = (found.as_ref().unwrap().iae.unwrap(), alone.iae.unwrap());
        // 1e-12: which series are cut where depends on the other lanes.
        assert!((ours / theirs - 1.0).abs() < 1e-12, "{ours} {theirs}");
    }
}

#[cfg(target_arch = "x86_64")]
#[test]
fn every_instruction_set_gives_the_same_integrals() {
    use fearless_simd::{Level, Simd, f64x8};

    fn on<S: Simd>(simd: S, loops: &[ClosedLoop], scenario: &Scenario) -> Vec<[f64; 4]> {
        super::integrals_of::<f64x8<S>>(simd, loops, scenario).unwrap()
    }
    let closed = |i: i32| {
        let process =
            Process::integrating(0.0506 * (0.9 + 0.02 * f64::from(i)), Seconds(6.0 + 0.005 * f64::from(i)));
        ClosedLoop::new(&process.unwrap(), &pid(2.95, 15.0, 3.0, 33.3))
    };
    let loops: Vec<ClosedLoop> = (0..8).map(closed).collect();
    let scenario = servo_and_load(200.0, 100.0);
    let alone = loops.iter().map(|closed| super::integrals(closed, &scenario).unwrap());
    let level = Level::new();
    let found = [
        level.as_sse2().map(|simd| on(simd, &loops, &scenario)),
        level.as_avx2().map(|simd| on(simd, &loops, &scenario)),
        level.as_avx512().map(|simd| on(simd, &loops, &scenario)),
    ];
    for (l, alone) in alone.enumerate() {
        for found in found.iter().flatten() {
            for (ours, theirs) in found[l].iter().zip(alone) {
                // 1e-11: fused or not, and parts below 2e-14 of a sum left out or not.
                assert!((ours / theirs - 1.0).abs() < 1e-11, "{ours} {theirs}");
            }
        }
    }
}

#[test]
fn integrals_over_controllers_are_those_of_each() {
    let controllers: Vec<Controller> =
        (0..11).map(|i| pid(1.5 + 0.1 * f64::from(i), 15.0 + f64::from(i), 3.0, 33.3)).collect();
    let scenario = servo_and_load(200.0, 100.0);
    let found = integrals_over_controllers(&level(), &controllers, &scenario);
    for (controller, found) in controllers.iter().zip(&found) {
        let alone = super::super::integrals(&ClosedLoop::new(&level(), controller), &scenario).unwrap();
        let (ours, theirs) = (found.as_ref().unwrap().ise.unwrap(), alone.ise.unwrap());
        // 1e-12: which series are cut where depends on the other lanes.
        assert!((ours / theirs - 1.0).abs() < 1e-12, "{ours} {theirs}");
    }
}

#[test]
fn a_refilled_trajectory_is_that_of_a_new_one_whatever_was_in_it() {
    let with_observer = Controller::proportional(1.2).unwrap().with_observer(Observer::new(0.5).unwrap());
    let loops = [pid(2.95, 15.0, 3.0, 100.0), with_observer].map(|c| ClosedLoop::new(&level(), &c));
    let scenario = servo_and_load(200.0, 100.0);
    for times in [vec![0.0, 0.5, 6.01, 99.9, 100.0, 106.02, 200.0], vec![150.0, 3.0, 6.5, 6.5, 0.0]] {
        let mut reused = Trajectory { time: times.clone(), ..Trajectory::default() };
        for closed in &loops {
            let sums = refill_trajectory(closed, &scenario, &mut reused).unwrap();
            assert_eq!(reused, super::super::trajectory(closed, &scenario, &times).unwrap());
            assert_eq!(sums, super::super::integrals(closed, &scenario).unwrap());
        }
    }
    let mut outside = Trajectory { time: vec![1.0, 200.5], ..Trajectory::default() };
    assert!(refill_trajectory(&loops[0], &scenario, &mut outside).is_err());
    assert_eq!(outside, Trajectory::default());
}
