//! Transfers without a bump.

use holdup_control::{Input, Mode, Status};

use crate::laws::{Law, PERIOD};
use crate::plant::Loop;

/// The most the output may move at the samples after a transfer: the loops here move slower than this on their own
/// (Kc ≤ 1, y' ≤ 0.4, so Kc (1 + Td/Tf) y' h ≤ 0.12), and a bump would be the whole proportional term, 0.4 or more.
const SLOW: f64 = 0.13;

fn input(run: &Loop<f64>, setpoint: f64, mode: Mode<f64>) -> Input<f64> {
    Input { mode, ..Input::automatic(PERIOD, setpoint, run.controlled_variable) }
}

pub(crate) fn switching_to_automatic_does_not_move_the_output(law: &Law) {
    let mut run = Loop::at_rest(law.limited::<f64>(-2.0, 2.0));
    run.run(3.0, PERIOD, 1.0);
    for sample in 0..40 {
        // The operator moves the output and the setpoint, far from where the law would be.
        let manual = if sample < 20 { 0.4 } else { -0.35 };
        let output =
            run.sample(&input(&run.clone(), if sample < 10 { 1.0 } else { 3.0 }, Mode::Manual(manual)));
        assert_eq!(output.manipulated_variable, manual);
        if let Some(estimate) = output.load_estimate {
            // Seated: the law would give just this. Three roundings of numbers near 2.
            assert!((run.state.unassisted - estimate - manual).abs() < 2e-15);
        }
    }
    // Even when the setpoint moves with the switch.
    let first = run.automatic(PERIOD, -2.0).manipulated_variable;
    assert_eq!(first, -0.35);
    let second = run.automatic(PERIOD, -2.0).manipulated_variable;
    // A predictor sees at once where its own output leads: Kr (r − y) Km Kr h, with r − y near 5.
    let slow = if law.predicts { 0.7 } else { SLOW };
    assert!((second - first).abs() < slow, "{first} then {second}");
    run.run(150.0, PERIOD, -2.0);
    assert!((run.controlled_variable + 2.0).abs() < 0.01, "{}", run.controlled_variable);
}

pub(crate) fn manual_output_may_begin_where_automatic_stood(law: &Law) {
    let mut run = Loop::at_rest(law.limited::<f64>(-2.0, 2.0));
    run.run(3.0, PERIOD, 1.0);
    let last = run.output;
    for _ in 0..20 {
        let held = run.sample(&input(&run.clone(), 1.0, Mode::Hold));
        assert_eq!((held.manipulated_variable, held.status), (last, Status::Good));
    }
    assert_eq!(run.automatic(PERIOD, 1.0).manipulated_variable, last);
}

pub(crate) fn other_settings_do_not_move_the_output(law: &Law) {
    let other = Law {
        proportional_gain: 0.6 * law.proportional_gain,
        integral_time: law.integral_time.map(|time| 2.0 * time),
        derivative: law.derivative.map(|(time, filter)| (0.5 * time, filter.map(|filter| 2.0 * filter))),
        weights: (0.8, 0.5),
        observer: law.observer.map(|(gain, lead)| (0.7 * gain, lead)),
        predicts: law.predicts,
    };
    let mut run = Loop::at_rest(law.settings::<f64>());
    run.load = if law.rejects_loads() { 0.2 } else { 0.0 };
    run.run(2.5, PERIOD, 1.0);
    let mut twin = run.clone();
    run.settings = other.settings();
    // At the very sample a setpoint moves: both laws answer it alike.
    let (changed, kept) = (run.automatic(PERIOD, 1.2), twin.automatic(PERIOD, 1.2));
    assert_eq!(changed.manipulated_variable, kept.manipulated_variable);
    assert!(run.state.law == *run.settings.law());
    let next = run.automatic(PERIOD, 1.2).manipulated_variable;
    assert!(
        (next - changed.manipulated_variable).abs() < SLOW,
        "{} then {next}",
        changed.manipulated_variable
    );
    run.run(200.0, PERIOD, 1.2);
    let rest = if law.rejects_loads() || law.weights.0 == 1.0 { 1.2 } else { run.controlled_variable };
    assert!((run.controlled_variable - rest).abs() < 0.3, "{}", run.controlled_variable);
}

pub(crate) fn a_return_of_the_measurement_does_not_move_the_output(law: &Law) {
    let mut run = Loop::at_rest(law.limited::<f64>(-2.0, 2.0));
    run.run(3.0, PERIOD, 1.0);
    let last = run.output;
    for _ in 0..20 {
        let bad = Input { controlled_variable: Some(f64::NAN), ..input(&run, 1.0, Mode::Automatic) };
        let output = run.sample(&bad);
        assert_eq!((output.manipulated_variable, output.status), (last, Status::MeasurementRejected));
    }
    let back = run.automatic(PERIOD, 1.0);
    assert_eq!((back.manipulated_variable, back.status), (last, Status::Good));
    run.run(150.0, PERIOD, 1.0);
    assert!((run.controlled_variable - 1.0).abs() < 0.01, "{}", run.controlled_variable);
}
