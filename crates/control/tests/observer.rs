//! The disturbance observer: what it estimates, and what it must not.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use std::collections::VecDeque;

use holdup_control::{Input, Limits, Mode, Observer, Pid, Segment, Settings, State, Status};

const H: f64 = 0.01;
const KC: f64 = 0.4;
const KO: f64 = 0.3;

/// y' = u(t − 1) + load(t − 1) in steps of H, dead time 100 of them.
struct Process {
    inputs: VecDeque<f64>,
    y: f64,
}

impl Process {
    fn new() -> Self {
        Self { inputs: VecDeque::from(vec![0.0; 100]), y: 0.0 }
    }

    fn hold(&mut self, input: f64) {
        self.inputs.push_back(input);
        self.y += H * self.inputs.pop_front().unwrap();
    }
}

fn settings(observer_gain: f64, model_gain: f64, dead_time: f64) -> Settings<f64> {
    let observer = Observer::new(observer_gain, model_gain, dead_time, H).unwrap();
    Settings::new(Pid::proportional(KC).unwrap()).with_observer(observer).unwrap()
}

fn at_rest(settings: &Settings<f64>) -> State<f64, Vec<Segment<f64>>> {
    State::at_rest(settings, vec![Segment::default(); 220], 0.0, 0.0, 0.0).unwrap()
}

#[test]
fn the_estimate_of_a_load_step_follows_its_closed_form() {
    // With a perfect model D̂' = Ko (D − D̂)(t − 1): 0 until 1, Ko D (t − 1) until 2, less Ko² D (t − 2)²/2 until 3.
    let settings = settings(KO, 1.0, 1.0);
    let mut state = at_rest(&settings);
    let mut process = Process::new();
    let mut worst = 0.0_f64;
    for sample in 0..300_u32 {
        let t = f64::from(sample) * H;
        let output = state.update(&settings, &Input::automatic(H, 0.0, process.y));
        let linear = KO * (t - 1.0).max(0.0);
        let expected = linear - KO * KO * (t - 2.0).max(0.0).powi(2) / 2.0;
        worst = worst.max((output.load_estimate.unwrap() - expected).abs());
        process.hold(output.manipulated_variable + 1.0);
    }
    // The held D̂ lags by H at most: Ko² H t.
    assert!(worst < KO * KO * H, "{worst}");
}

#[test]
fn a_setpoint_move_is_no_load() {
    let settings = settings(KO, 1.0, 1.0);
    let mut state = at_rest(&settings);
    let mut process = Process::new();
    for _ in 0..2000 {
        let output = state.update(&settings, &Input::automatic(H, 1.0, process.y));
        // Perfect model: rounding of y and y_m alone, 2000 terms.
        assert!(output.load_estimate.unwrap().abs() < 1e-13);
        process.hold(output.manipulated_variable);
    }
}

#[test]
fn saturation_is_no_load_and_does_not_wind_the_observer_up() {
    let limits = Limits::new(Some(-0.1), Some(0.1)).unwrap().with_rate(0.05).unwrap();
    let settings = settings(KO, 1.0, 1.0).with_limits(limits).unwrap();
    let mut state = at_rest(&settings);
    let mut process = Process::new();
    for _ in 0..5000 {
        let output = state.update(&settings, &Input::automatic(H, 3.0, process.y));
        assert!(output.load_estimate.unwrap().abs() < 1e-12);
        process.hold(output.manipulated_variable);
    }
}

#[test]
fn a_load_is_found_while_the_actuator_saturates() {
    let settings = settings(KO, 1.0, 1.0).with_limits(Limits::new(Some(-0.1), Some(0.1)).unwrap()).unwrap();
    let mut state = at_rest(&settings);
    let mut process = Process::new();
    let mut estimate = 0.0;
    for _ in 0..4000 {
        let output = state.update(&settings, &Input::automatic(H, 100.0, process.y));
        assert_eq!(output.manipulated_variable, 0.1);
        estimate = output.load_estimate.unwrap();
        process.hold(output.manipulated_variable + 0.05);
    }
    // e^(−0.46 t) after 38 s, from the factor s + Ko e^(−s).
    assert!((estimate - 0.05).abs() < 1e-6, "{estimate}");
}

#[test]
fn the_actuator_that_sticks_is_told_from_a_load() {
    let settings = settings(KO, 1.0, 1.0);
    let mut state = at_rest(&settings);
    let mut process = Process::new();
    let mut stuck = 0.0;
    for sample in 0..3000 {
        let input = Input { applied: (sample > 0).then_some(stuck), ..Input::automatic(H, 1.0, process.y) };
        let output = state.update(&settings, &input);
        assert!(output.load_estimate.unwrap().abs() < 1e-12);
        if sample < 100 {
            stuck = output.manipulated_variable;
        }
        process.hold(stuck);
    }
}

#[test]
fn feed_forward_of_the_load_leaves_nothing_to_estimate() {
    let settings = settings(KO, 1.0, 1.0);
    let mut state = at_rest(&settings);
    let mut process = Process::new();
    for _ in 0..2000 {
        let input = Input { feed_forward: -0.5, ..Input::automatic(H, 0.0, process.y) };
        let output = state.update(&settings, &input);
        assert!(output.load_estimate.unwrap().abs() < 1e-13);
        process.hold(output.manipulated_variable + 0.5);
    }
    assert!(process.y.abs() < 1e-13);
}

#[test]
fn another_gain_or_model_leaves_the_estimate_where_it_is() {
    let others =
        [settings(0.1, 1.0, 1.0), settings(KO, 2.0, 1.0), settings(KO, 1.0, 0.4), settings(KO, 1.0, 1.9)];
    let plain = others.map(|after| (settings(KO, 1.0, 1.0), after));
    for (before, after) in plain.into_iter().chain(others.each_ref().map(predicting)) {
        let mut state = at_rest(&before);
        let mut process = Process::new();
        let mut outputs = Vec::new();
        for sample in 0..1000 {
            let settings = if sample < 500 { &before } else { &after };
            let output = state.update(settings, &Input::automatic(H, 1.0, process.y));
            outputs.push((output.load_estimate.unwrap(), output.manipulated_variable));
            process.hold(output.manipulated_variable + 0.3);
        }
        for pair in outputs[499..520].windows(2) {
            // Ko |y' − y_m'| H with rates below 1; reseated wrongly, D̂ would move by a third of itself, 0.1. With
            // another model a predictor sees another y, and D̂ takes that up so that the output does not move.
            let predicts = before.law().observer.unwrap().predicts();
            assert!(predicts || (pair[1].0 - pair[0].0).abs() < KO * H, "{pair:?}");
            assert!((pair[1].1 - pair[0].1).abs() < (KO + KC) * H, "{pair:?}");
        }
    }
}

/// The modified Smith predictor with the same numbers, before and after.
fn predicting(after: &Settings<f64>) -> (Settings<f64>, Settings<f64>) {
    let with = |observer: Observer<f64>| settings(KO, 1.0, 1.0).with_observer(observer.predicting()).unwrap();
    (with(Observer::new(KO, 1.0, 1.0, H).unwrap()), with(after.law().observer.unwrap()))
}

#[test]
fn a_dead_time_that_the_line_cannot_hold_is_refused_and_the_old_law_runs_on() {
    let before = settings(KO, 1.0, 1.0);
    let after = settings(KO, 1.0, 3.0);
    let mut state = at_rest(&before);
    let mut twin = at_rest(&before);
    assert_eq!(
        state.fits(&after).unwrap_err().to_string(),
        "the delay line has 220 segments: the dead time needs 303"
    );
    let input = Input::automatic(H, 1.0, 0.2);
    let (refused, kept) = (state.update(&after, &input), twin.update(&before, &input));
    assert_eq!(refused.status, Status::SettingsRejected);
    assert_eq!(refused.manipulated_variable, kept.manipulated_variable);
}

#[test]
fn after_manual_the_estimate_returns_to_the_load_at_its_own_rate() {
    let settings = settings(KO, 1.0, 1.0);
    let mut state = at_rest(&settings);
    let mut process = Process::new();
    let mut estimates = Vec::new();
    for sample in 0..6000 {
        let mode = if sample < 500 { Mode::Manual(0.25) } else { Mode::Automatic };
        let output = state.update(&settings, &Input { mode, ..Input::automatic(H, 0.5, process.y) });
        estimates.push(output.load_estimate.unwrap());
        process.hold(output.manipulated_variable - 0.2);
    }
    for pair in estimates[500..].windows(2) {
        // D̂' = Ko (D − D̂)(t − 1), and D̂ is seated within 1 of D.
        assert!((pair[1] - pair[0]).abs() < KO * H, "{pair:?}");
    }
    assert!((estimates.last().unwrap() + 0.2).abs() < 1e-6, "{:?}", estimates.last());
}

#[test]
fn one_sample_is_the_recipe_written_out() {
    // D̂ from y and the stored y_m; v = u_pd − D̂; u = limit(v); push u + D̂. At a constant period, dead time 7.
    let observer = Observer::new(KO, 0.5, 7.0, 1.0).unwrap();
    let settings = Settings::new(Pid::proportional(KC).unwrap()).with_observer(observer).unwrap();
    let settings = settings.with_limits(Limits::new(Some(-0.2), Some(0.3)).unwrap()).unwrap();
    let mut state = State::at_rest(&settings, [Segment::default(); 10], 0.0, 0.0, 0.0).unwrap();
    let mut line = VecDeque::from(vec![0.0; 7]);
    let mut model = 0.0;
    let mut limited = 0;
    for sample in 0..500_u32 {
        let y = f64::from(sample * 37 % 101) * 0.02 - 1.0;
        let estimate = KO * (y - model);
        let wanted = KC * (0.3 - y) - estimate;
        let u = wanted.clamp(-0.2, 0.3);
        limited += u32::from(u != wanted);
        line.push_back(u + estimate);
        model += 0.5 * line.pop_front().unwrap();

        let output = state.update(&settings, &Input::automatic(1.0, 0.3, y));
        // 500 roundings of numbers near 1.
        assert!((output.load_estimate.unwrap() - estimate).abs() < 1e-13);
        assert!((output.manipulated_variable - u).abs() < 1e-13);
    }
    assert!((100..400).contains(&limited), "limited at {limited} samples: the test does not test");
}

#[test]
fn with_a_slow_sensor_the_estimate_is_right_at_its_samples() {
    let settings = settings(KO, 1.0, 1.0);
    let mut state = at_rest(&settings);
    let mut process = Process::new();
    for sample in 0..4000 {
        // Read at every fiftieth update, half a second; switched from manual between two readings.
        let mode = if sample < 1020 { Mode::Manual(0.0) } else { Mode::Automatic };
        let measured = (sample % 50 == 0).then_some(process.y);
        let input = Input { mode, controlled_variable: measured, ..Input::automatic(H, 0.0, 0.0) };
        let output = state.update(&settings, &input);
        if sample == 1050 {
            // y = 0.1 (t − 1): seated at 10 s to Kc (0 − 0.9) − 0. In half a second y rises 0.05, and the model is
            // driven by the u_pd of one second before, Kc (0 − 0.8), so it falls 0.16.
            let expected = -KC * 0.9 + KO * (0.05 + KC * 0.8 * 0.5);
            assert!((output.load_estimate.unwrap() - expected).abs() < 1e-12, "{:?}", output.load_estimate);
        }
        process.hold(output.manipulated_variable + 0.1);
    }
}

#[test]
fn the_modified_smith_predictor_answers_the_setpoint_as_a_lag_after_the_dead_time() {
    // y/r = e^(−s)/(Tr s + 1), Tr = 1 (rules.json msp_matausek_micic_1996), whatever K0.
    let observer = Observer::new(0.5, 1.0, 1.0, H).unwrap().predicting();
    let settings = Settings::new(Pid::proportional(1.0).unwrap()).with_observer(observer).unwrap();
    let mut state = at_rest(&settings);
    let mut process = Process::new();
    for sample in 0..800_i32 {
        let output = state.update(&settings, &Input::automatic(H, 1.0, process.y));
        // Sampled: each sample takes H of the way that is left; exact, so only rounding remains.
        let expected = 1.0 - (1.0 - H).powi((sample - 100).max(0));
        assert!((process.y - expected).abs() < 1e-12, "{} not {expected} at {sample}", process.y);
        process.hold(output.manipulated_variable);
    }
}
