//! Simulation of one loop: `cargo bench -p holdup --bench response`.

use divan::{Bencher, black_box};
use holdup::analysis::batch::integrals_over_processes;
use holdup::analysis::response::{
    Scenario, Trajectory, integrals, refill_trajectory, simulate, simulate_with_trajectory,
};
use holdup::model::{ClosedLoop, Controller, Observer, Process, Seconds};

fn main() {
    divan::main();
}

fn level() -> Process {
    Process::integrating(0.0506, Seconds(6.0)).expect("valid")
}

fn pid() -> Controller {
    let pi = Controller::proportional(2.95).and_then(|c| c.with_integral_time(Seconds(15.0)));
    let pid =
        pi.and_then(|c| c.with_derivative_time(Seconds(3.0))).and_then(|c| c.with_filter_bandwidth(100.0));
    pid.expect("valid")
}

fn servo_and_load(horizon: f64) -> Scenario {
    Scenario::new(vec![(0.0, 1.0)], vec![(horizon / 2.0, 1.0)], Seconds(horizon), 0.0).expect("valid")
}

/// 200 s of the paper's PID loop, setpoint step at 0, load step at 100 s: the metrics.
#[divan::bench]
fn metrics_only(bencher: Bencher) {
    let (closed, scenario) = (ClosedLoop::new(&level(), &pid()), servo_and_load(200.0));
    bencher.bench(|| simulate(black_box(&closed), black_box(&scenario)));
}

/// The four integrals alone.
#[divan::bench]
fn integrals_only(bencher: Bencher) {
    let (closed, scenario) = (ClosedLoop::new(&level(), &pid()), servo_and_load(200.0));
    bencher.bench(|| integrals(black_box(&closed), black_box(&scenario)));
}

/// The four integrals and 20 001 output points, in memory that is used again.
#[divan::bench]
fn integrals_and_20_001_points(bencher: Bencher) {
    let (closed, scenario) = (ClosedLoop::new(&level(), &pid()), servo_and_load(200.0));
    let time = (0..=20_000).map(|i| f64::from(i) * 0.01).collect();
    let mut trajectory = Trajectory { time, ..Trajectory::default() };
    bencher.bench_local(|| refill_trajectory(black_box(&closed), black_box(&scenario), &mut trajectory));
}

/// All metrics with 20 001 output points.
#[divan::bench]
fn metrics_and_20_001_points(bencher: Bencher) {
    let (closed, scenario) = (ClosedLoop::new(&level(), &pid()), servo_and_load(200.0));
    let times: Vec<f64> = (0..=20_000).map(|i| f64::from(i) * 0.01).collect();
    bencher.bench(|| simulate_with_trajectory(black_box(&closed), black_box(&scenario), black_box(&times)));
}

/// 200 s of PI control: one cell for each dead time.
#[divan::bench]
fn pi_metrics_only(bencher: Bencher) {
    let pi = Controller::proportional(1.6).and_then(|c| c.with_integral_time(Seconds(48.0))).expect("valid");
    let (closed, scenario) = (ClosedLoop::new(&level(), &pi), servo_and_load(200.0));
    bencher.bench(|| simulate(black_box(&closed), black_box(&scenario)));
}

/// The paper's PD loop with an observer whose model has another dead time: two delays over 200 dead times.
#[divan::bench]
fn two_delays_200_dead_times(bencher: Bencher) {
    let observer = Observer::new(0.8).and_then(|o| o.with_model_dead_time(Seconds(6.6))).expect("valid");
    let pd = Controller::proportional(1.2).and_then(|c| c.with_derivative_time(Seconds(1.0)));
    let pd = pd.and_then(|c| c.with_filter_bandwidth(100.0)).expect("valid").with_observer(observer);
    let (closed, scenario) = (ClosedLoop::new(&level(), &pd), servo_and_load(1200.0));
    bencher.bench(|| simulate(black_box(&closed), black_box(&scenario)));
}

/// An oscillation that hardly decays, over 10 000 dead times.
#[divan::bench(sample_count = 10)]
fn slowly_damped_10_000_dead_times(bencher: Bencher) {
    let process = Process::integrating(1.0, Seconds(1.0)).expect("valid");
    let closed = ClosedLoop::new(&process, &Controller::proportional(1.57).expect("valid"));
    let scenario = Scenario::unit_setpoint_step(Seconds(10_000.0)).expect("valid");
    bencher.bench(|| simulate(black_box(&closed), black_box(&scenario)));
}

/// The integrals of 1000 processes, ±20 % in gain and dead time, under the paper's PID control.
#[divan::bench(sample_count = 10)]
fn one_thousand_processes(bencher: Bencher) {
    let process = |i: u32| {
        let (gain, time) = (0.8 + 0.0004 * f64::from(i), 0.8 + 0.4 * f64::from(i * 37 % 1000) / 1000.0);
        Process::integrating(0.0506 * gain, Seconds(6.0 * time)).expect("valid")
    };
    let processes: Vec<Process> = (0..1000).map(process).collect();
    let (controller, scenario) = (pid(), servo_and_load(200.0));
    bencher.bench(|| {
        integrals_over_processes(black_box(&processes), black_box(&controller), black_box(&scenario))
    });
}
