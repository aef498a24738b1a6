//! Time of one set of margins, and of the dominant poles.

use divan::{Bencher, black_box};
use holdup::analysis::frequency::{dominant_poles, margins};
use holdup::model::{ClosedLoop, Controller, Observer, Process, Seconds};

fn main() {
    divan::main();
}

fn process() -> Process {
    Process::integrating(0.0506, Seconds(6.0)).expect("valid")
}

fn pid(bandwidth: Option<f64>) -> Controller {
    let ideal = Controller::proportional(1.6)
        .and_then(|c| c.with_integral_time(Seconds(40.0)))
        .and_then(|c| c.with_derivative_time(Seconds(2.0)))
        .expect("valid");
    bandwidth.map_or(ideal, |n| ideal.with_filter_bandwidth(n).expect("valid"))
}

fn observer(controller: Controller) -> Controller {
    controller.with_observer(Observer::new(0.8).expect("valid"))
}

fn run(bencher: Bencher, controller: &Controller) {
    let closed = ClosedLoop::new(&process(), controller);
    bencher.bench_local(|| margins(black_box(&closed)));
}

#[divan::bench]
fn p(bencher: Bencher) {
    run(bencher, &Controller::proportional(1.6).expect("valid"));
}

#[divan::bench]
fn pid_filtered(bencher: Bencher) {
    run(bencher, &pid(Some(100.0)));
}

#[divan::bench]
fn pid_unfiltered(bencher: Bencher) {
    run(bencher, &pid(None));
}

#[divan::bench]
fn pid_with_observer(bencher: Bencher) {
    run(bencher, &observer(pid(Some(100.0))));
}

/// Hundreds of thousands of oscillations before the roll-off.
#[divan::bench(args = [0.7, 0.95])]
fn plateau(bencher: Bencher, gain: f64) {
    let td = 2.0;
    let kc = gain / (0.0506 * td);
    let controller = Controller::proportional(kc)
        .and_then(|c| c.with_derivative_time(Seconds(td)))
        .and_then(|c| c.with_filter_bandwidth(1e6))
        .expect("valid");
    run(bencher, &controller);
}

/// The same where |L| rises to its plateau from below: the peak lies far up the band.
#[divan::bench(args = [0.7, 0.95])]
fn rising_plateau(bencher: Bencher, gain: f64) {
    let td = 50.0;
    let controller = Controller::proportional(gain / (0.0506 * td))
        .and_then(|c| c.with_integral_time(Seconds(60.0)))
        .and_then(|c| c.with_derivative_time(Seconds(td)))
        .and_then(|c| c.with_filter_bandwidth(1e6))
        .expect("valid");
    run(bencher, &controller);
}

/// The rightmost poles of the filtered PID loop, proven complete.
#[divan::bench]
fn poles(bencher: Bencher) {
    let closed = ClosedLoop::new(&process(), &pid(Some(100.0)));
    bencher.bench_local(|| dominant_poles(black_box(&closed)));
}
