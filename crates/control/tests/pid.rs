//! The PID terms against their formulas, and what surrounds them.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use holdup_control::{Action, Input, Limited, Limits, Mode, Pid, Segment, Settings, State, Status, Watch};

type Plain = State<f64, [Segment<f64>; 0]>;

fn at_rest(settings: &Settings<f64>) -> Plain {
    State::at_rest(settings, [], 0.0, 0.0, 0.0).unwrap()
}

fn pid() -> Pid<f64> {
    let pid = Pid::proportional(2.0).unwrap().with_integral(10.0).unwrap();
    pid.with_derivative(3.0, Some(0.5)).unwrap().with_setpoint_weights(0.7, 0.2).unwrap()
}

/// The output at these (sample period, setpoint, measurement).
fn outputs(settings: &Settings<f64>, state: &mut Plain, samples: &[(f64, f64, f64)]) -> Vec<f64> {
    let update = |&(h, r, y): &(f64, f64, f64)| {
        state.update(settings, &Input::automatic(h, r, y)).manipulated_variable
    };
    samples.iter().map(update).collect()
}

#[test]
fn the_output_is_the_sum_of_the_sampled_terms() {
    let settings = Settings::new(pid());
    let samples = [(0.5, 1.0, 0.0), (0.25, 1.0, 0.1), (1.0, 0.5, 0.4)];
    let mut integral = 0.0;
    let mut slope = 0.0;
    let (mut r0, mut y0) = (0.0, 0.0);
    for (u, (h, r, y)) in outputs(&settings, &mut at_rest(&settings), &samples).into_iter().zip(samples) {
        integral += 2.0 / 10.0 * (r - y) * h;
        // Backward difference of Td s/(1 + Tf s).
        slope = (0.5 * slope + (0.2 * (r - r0) - (y - y0))) / (0.5 + h);
        (r0, y0) = (r, y);
        let expected = 2.0 * (0.7 * r - y) + integral + 2.0 * 3.0 * slope;
        // A dozen roundings of numbers near 3.
        assert!((u - expected).abs() < 1e-14, "{u}, not {expected}");
    }
}

#[test]
fn direct_action_is_a_negative_gain() {
    let direct = Settings::new(pid().with_action(Action::Direct));
    let reverse = Settings::new(pid());
    let samples = [(0.5, 1.0, 0.0), (0.5, 1.0, 0.1), (0.5, 0.5, 0.4)];
    let up = outputs(&reverse, &mut at_rest(&reverse), &samples);
    let down = outputs(&direct, &mut at_rest(&direct), &samples);
    assert_eq!(up.iter().map(|u| -u).collect::<Vec<_>>(), down);
}

#[test]
fn an_unfiltered_derivative_is_the_slope_of_the_last_sample() {
    let pd = Pid::proportional(2.0).unwrap().with_derivative(3.0, None).unwrap();
    let settings = Settings::new(pd);
    let u =
        outputs(&settings, &mut at_rest(&settings), &[(0.5, 0.0, 0.0), (0.25, 0.0, 0.5), (0.5, 0.0, 0.5)]);
    assert_eq!(u, [0.0, -2.0 * 0.5 - 2.0 * 3.0 * 0.5 / 0.25, -2.0 * 0.5]);
}

#[test]
fn the_derivative_moves_only_with_a_new_sample() {
    let pd = Pid::proportional(2.0).unwrap().with_derivative(3.0, None).unwrap();
    let settings = Settings::new(pd);
    let mut state = at_rest(&settings);
    // The sensor is read at every fifth update: no false peak at the fifth, no false zero between.
    for update in 1..=50_u32 {
        let time = f64::from(update) * 0.2;
        let measured = (update % 5 == 0).then_some(0.1 * time);
        let input = Input { controlled_variable: measured, ..Input::automatic(0.2, 0.0, 0.0) };
        let u = state.update(&settings, &input).manipulated_variable;
        if update >= 5 {
            let held = 0.1 * f64::from(update / 5);
            // A dozen roundings of numbers near 2.
            assert!((u - (-2.0 * held - 2.0 * 3.0 * 0.1)).abs() < 1e-14, "{u} at update {update}");
        }
    }
}

#[test]
fn the_integral_follows_the_applied_output_within_the_tracking_time() {
    let pi = Pid::proportional(2.0).unwrap().with_integral(10.0).unwrap();
    let limits = Limits::new(Some(-1.0), Some(1.0)).unwrap();
    for (tracking_time, wound) in [(0.0, 2.4), (10.0, 6.0)] {
        let settings =
            Settings::new(pi.with_tracking_time(tracking_time).unwrap()).with_limits(limits).unwrap();
        let mut state = at_rest(&settings);
        let mut output = state.update(&settings, &Input::automatic(1.0, 2.0, 0.0));
        for _ in 0..200 {
            output = state.update(&settings, &Input::automatic(1.0, 2.0, 0.0));
        }
        assert_eq!(output.limited, Limited::High);
        // At rest Kc h/Ti e = (v − u) h/(Tt + h), so v = u + Kc e (Tt + h)/Ti: 1.4 and 5.4; far from the 80 of ∫.
        let expected = 1.0 + 2.0 * 2.0 * (tracking_time + 1.0) / 10.0;
        assert!((output.wanted - expected).abs() < 1e-6, "{}", output.wanted);
        assert!(output.wanted < wound);
    }
}

#[test]
fn the_bias_bleeds_in_a_straight_line_over_the_bleed_time() {
    let settings = Settings::new(Pid::proportional(2.0).unwrap().with_bias(0.5, Some(4.0)).unwrap());
    let mut state = State::switched_on(&settings, [], 3.5).unwrap();
    // At the setpoint the law gives its bias, 0.5; it is switched on at 3.5.
    let u = outputs(&settings, &mut state, &[(1.0, 7.0, 7.0); 7]);
    assert_eq!(u, [3.5, 2.75, 2.0, 1.25, 0.5, 0.5, 0.5]);

    let settings = Settings::new(Pid::proportional(2.0).unwrap());
    let mut state = State::switched_on(&settings, [], 3.5).unwrap();
    assert_eq!(outputs(&settings, &mut state, &[(1.0, 7.0, 7.0); 3]), [3.5; 3]);
}

#[test]
fn a_small_error_is_not_lost_in_f32() {
    let settings = Settings::new(Pid::proportional(1.0_f32).unwrap().with_integral(10.0).unwrap());
    let mut state = State::at_rest(&settings, [], 0.0, 0.0, 1000.0).unwrap();
    for _ in 0..1_000_000 {
        state.update(&settings, &Input::automatic(0.1, 0.001, 0.0));
    }
    // 1e6 · 0.1/10 · 0.001 = 10; each step, 1e-5, is a sixth of half the spacing of f32 at 1000.
    assert!((state.manipulated_variable - 1010.0).abs() < 0.003, "{}", state.manipulated_variable);
}

#[test]
fn feed_forward_goes_straight_to_the_output() {
    let settings = Settings::new(pid());
    let mut state = at_rest(&settings);
    let input = Input { feed_forward: 1.25, ..Input::automatic(1.0, 0.0, 0.0) };
    assert_eq!(state.update(&settings, &input).manipulated_variable, 1.25);
    assert_eq!(outputs(&settings, &mut state, &[(1.0, 0.0, 0.0)]), [0.0]);
}

#[test]
fn a_schedule_of_gains_at_every_sample_still_controls() {
    // A law that froze the output at each change of settings would never move.
    let mut state = at_rest(&Settings::new(pid()));
    let mut y = 0.0;
    for sample in 0..4000_u32 {
        let gain = 0.5 + 0.001 * f64::from(sample % 100);
        let settings = Settings::new(Pid::proportional(gain).unwrap().with_integral(10.0).unwrap());
        y += 0.1 * state.update(&settings, &Input::automatic(0.1, 1.0, y)).manipulated_variable;
    }
    assert!((y - 1.0).abs() < 1e-3, "{y}");
}

#[test]
fn an_integral_taken_away_or_given_does_not_move_the_output() {
    let with = Settings::new(pid());
    let without = Settings::new(Pid::proportional(2.0).unwrap().with_bias(0.0, Some(100.0)).unwrap());
    let mut state = at_rest(&with);
    outputs(&with, &mut state, &[(0.1, 1.0, 0.9); 300]);
    for settings in [&with, &without, &without, &with, &with, &without, &with] {
        let before = state.manipulated_variable;
        let after = outputs(settings, &mut state, &[(0.1, 1.0, 0.9)])[0];
        // The integral's own motion, 2/10 · 0.1 · 0.1, and the bias's, a thousandth of what it bleeds.
        assert!((after - before).abs() < 0.003, "{before} then {after}");
    }
}

#[test]
fn a_missing_measurement_holds_the_output_and_then_takes_the_safe_one() {
    let watch = Watch::none().with_stale_time(2.0).unwrap().with_failure(5.0, -0.5).unwrap();
    let settings = Settings::new(pid()).with_watch(watch).unwrap();
    let mut state = at_rest(&settings);
    let mut last = state.update(&settings, &Input::automatic(1.0, 1.0, 0.5)).manipulated_variable;
    let silent = Input { controlled_variable: None, ..Input::automatic(1.0, 1.0, 0.0) };
    for (second, status) in [
        Status::Good,
        Status::Good,
        Status::MeasurementStale,
        Status::MeasurementStale,
        Status::MeasurementStale,
    ]
    .into_iter()
    .enumerate()
    {
        let output = state.update(&settings, &silent);
        assert_eq!(output.status, status, "after {} s", second + 1);
        if status == Status::MeasurementStale {
            assert_eq!(output.manipulated_variable, last);
        }
        last = output.manipulated_variable;
    }
    let failed = state.update(&settings, &silent);
    assert_eq!((failed.manipulated_variable, failed.status), (-0.5, Status::MeasurementFailed));
    // The operator keeps the output.
    let manual = state.update(&settings, &Input { mode: Mode::Manual(0.8), ..silent });
    assert_eq!((manual.manipulated_variable, manual.status), (0.8, Status::MeasurementFailed));
    // And the law comes back from where it stands.
    let back = state.update(&settings, &Input::automatic(1.0, 1.0, 0.4));
    assert_eq!((back.manipulated_variable, back.status), (0.8, Status::Good));
}

#[test]
fn a_measurement_out_of_its_range_is_none() {
    let settings = Settings::new(pid()).with_watch(Watch::none().with_range(0.0, 100.0).unwrap()).unwrap();
    let mut state = at_rest(&settings);
    let output = state.update(&settings, &Input::automatic(1.0, 1.0, 101.0));
    assert_eq!((output.manipulated_variable, output.status), (0.0, Status::MeasurementRejected));
}

#[test]
fn a_bad_setpoint_leaves_the_last_one() {
    let settings = Settings::new(pid());
    let (mut state, mut twin) = (at_rest(&settings), at_rest(&settings));
    for setpoint in [1.0, f64::NAN, f64::INFINITY] {
        let output = state.update(&settings, &Input::automatic(1.0, setpoint, 0.5));
        let expected = twin.update(&settings, &Input::automatic(1.0, 1.0, 0.5));
        assert_eq!(output.manipulated_variable, expected.manipulated_variable);
        assert_eq!(output.status, if setpoint == 1.0 { Status::Good } else { Status::InputRejected });
    }
}

#[test]
fn a_clock_that_stands_or_goes_back_moves_nothing() {
    let settings = Settings::new(pid());
    let mut state = at_rest(&settings);
    state.update(&settings, &Input::automatic(1.0, 1.0, 0.5));
    let before = state;
    for sample_period in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let output = state.update(&settings, &Input::automatic(sample_period, 5.0, 9.0));
        assert_eq!(output.status, Status::SamplePeriodRejected);
        assert_eq!(state, before);
    }
}
