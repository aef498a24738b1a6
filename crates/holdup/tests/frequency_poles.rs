//! Dominant poles against the Lambert function, and their number against the verdict.

use holdup::analysis::frequency::{Pole, dominant_poles, margins};
use holdup::model::{ClosedLoop, Controller, Observer, Process, Seconds};

/// Poles of the proportional loop: `s·d = W_k(−K·Kc·d)`, from right to left.
fn lambert(gain: f64, d: f64) -> Vec<Pole> {
    let mut poles: Vec<Pole> = (-6..=5)
        .map(|k| lambert_w::lambert_w(k, -gain * d, 0.0, 1e-15))
        .map(|(re, im)| Pole { re: re / d, im: im / d })
        .collect();
    poles.sort_by(|a, b| b.re.total_cmp(&a.re).then(b.im.total_cmp(&a.im)));
    poles
}

fn assert_same(got: &[Pole], expected: &[Pole]) {
    assert!(!got.is_empty());
    for (a, b) in got.iter().zip(expected) {
        let distance = (a.re - b.re).hypot(a.im - b.im);
        // Both are polished to rounding; near the double pole at 1/e rounding counts by its square root.
        assert!(distance < 1e-12 * b.re.hypot(b.im), "{a:?} is not {b:?} in {got:?}");
    }
}

#[test]
fn proportional_loop_has_the_poles_of_the_lambert_function() {
    for (gain, d) in [(0.1, 1.0), (0.3, 1.0), (0.5, 1.0), (0.05, 12.0), (1.5, 1.0), (2.0, 1.0), (20.0, 1.0)] {
        let process = Process::integrating(2.0, Seconds(d)).unwrap();
        let closed = ClosedLoop::new(&process, &Controller::proportional(gain / 2.0).unwrap());
        assert_same(&dominant_poles(&closed).unwrap(), &lambert(gain, d));
    }
}

#[test]
fn derivative_that_cancels_the_lag_leaves_a_proportional_loop() {
    let process = Process::integrating(1.0, Seconds(1.0)).unwrap().with_lag(Seconds(2.0)).unwrap();
    let pd = Controller::proportional(0.5).unwrap().with_derivative_time(Seconds(2.0)).unwrap();
    let mut expected = lambert(0.5, 1.0);
    expected.push(Pole { re: -0.5, im: 0.0 });
    expected.sort_by(|a, b| b.re.total_cmp(&a.re).then(b.im.total_cmp(&a.im)));
    assert_same(&dominant_poles(&ClosedLoop::new(&process, &pd)).unwrap(), &expected);
}

#[test]
fn perfect_observer_adds_the_poles_of_its_own_loop() {
    let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
    let p = Controller::proportional(0.3).unwrap().with_observer(Observer::new(0.6).unwrap());
    let mut expected = lambert(0.3, 1.0);
    expected.extend(lambert(0.6, 1.0));
    expected.sort_by(|a, b| b.re.total_cmp(&a.re).then(b.im.total_cmp(&a.im)));
    assert_same(&dominant_poles(&ClosedLoop::new(&process, &p)).unwrap(), &expected);
}

#[test]
fn poles_to_the_right_of_the_axis_are_as_many_as_the_verdict_says() {
    for kc in [-0.3, 0.2, 0.8, 1.0, 1.6, 3.0, 9.0] {
        for ti in [0.5, 2.0, 9.0] {
            let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
            let pi = Controller::proportional(kc).unwrap().with_integral_time(Seconds(ti)).unwrap();
            let closed = ClosedLoop::new(&process, &pi);
            let poles = dominant_poles(&closed).unwrap();
            let unstable = poles.iter().filter(|p| p.re > 0.0).count();
            assert_eq!(
                Some(unstable),
                margins(&closed).unwrap().unstable_poles,
                "Kc {kc}, Ti {ti}: {poles:?}"
            );
        }
    }
}
