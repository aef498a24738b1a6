//! What is refused, and how it is said.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use holdup_control::{
    Action, DelayLine, Limits, Observer, Pid, Segment, SettingError, Settings, State, Watch,
};

fn message<T: std::fmt::Debug>(result: Result<T, SettingError>) -> String {
    result.unwrap_err().to_string()
}

#[test]
fn a_refusal_names_the_parameter_the_value_and_what_is_allowed() {
    let pid = Pid::proportional(1.0).unwrap();
    let cases = [
        (message(Pid::proportional(0.0)), "proportional_gain = 0: must be finite and not 0"),
        (message(pid.with_integral(-3.0)), "integral_time = -3: must be finite and above 0"),
        (message(pid.with_derivative(-1.0, None)), "derivative_time = -1: must be finite and not below 0"),
        (message(pid.with_derivative(1.0, Some(0.0))), "filter_time = 0: must be finite and above 0"),
        (message(pid.with_setpoint_weights(f64::NAN, 0.0)), "setpoint_weight = NaN: must be finite"),
        (message(pid.with_tracking_time(-1.0)), "tracking_time = -1: must be finite and not below 0"),
        (message(pid.with_bias(0.0, Some(0.0))), "bleed_time = 0: must be finite and above 0"),
        (message(Limits::new(Some(100.0), Some(0.0))), "output_low = 100: must be below output_high"),
        (message(Limits::none().with_rate(0.0)), "rate_limit = 0: must be finite and above 0"),
        (message(Observer::new(1.0, -1.0, 1.0, 0.1)), "observer_gain = 1: must have the sign of model_gain"),
        (message(Observer::new(1.0, 1.0, f64::INFINITY, 0.1)), "dead_time = inf: must be finite and above 0"),
        (message(Watch::none().with_range(1.0, 1.0)), "measurement_low = 1: must be below measurement_high"),
        (message(Watch::none().with_stale_time(0.0)), "stale_time = 0: must be finite and above 0"),
        (
            message(DelayLine::new([Segment::default(); 9], 1.0, 0.0)),
            "sample_period = 0: must be finite and above 0",
        ),
    ];
    for (said, expected) in cases {
        assert_eq!(said, expected);
    }
}

#[test]
fn settings_that_contradict_each_other_are_refused() {
    let settings = Settings::new(Pid::proportional(1.0).unwrap());
    let limits = Limits::new(Some(0.0), Some(100.0)).unwrap();
    let watch = Watch::none().with_failure(10.0, -5.0).unwrap();
    let expected = "safe_output = -5: must be within the output limits";
    assert_eq!(message(settings.with_watch(watch).unwrap().with_limits(limits)), expected);
    assert_eq!(message(settings.with_limits(limits).unwrap().with_watch(watch)), expected);

    let hasty = Watch::none().with_stale_time(20.0).unwrap().with_failure(10.0, 5.0).unwrap();
    assert_eq!(message(settings.with_watch(hasty)), "failure_time = 10: must not be below stale_time");

    let outlet = Observer::new(-0.3, -1.0, 1.0, 0.1).unwrap();
    let expected = "proportional_gain = 1: must, with its action, have the sign of model_gain";
    assert_eq!(message(settings.with_observer(outlet)), expected);
    let direct = Settings::new(Pid::proportional(1.0).unwrap().with_action(Action::Direct));
    assert!(direct.with_observer(outlet).is_ok());
}

#[test]
fn a_state_needs_a_line_for_the_dead_time_of_its_observer() {
    let observer = Observer::new(0.3_f32, 1.0, 10.0, 0.1).unwrap();
    let settings = Settings::new(Pid::proportional(0.4).unwrap()).with_observer(observer).unwrap();
    let short = State::at_rest(&settings, [Segment::default(); 20], 0.0, 0.0, 0.0);
    assert_eq!(
        message(short),
        format!("the delay line has 20 segments: the dead time needs {}", settings.segments_needed())
    );
    assert!(
        State::at_rest(&settings, vec![Segment::default(); settings.segments_needed()], 0.0, 0.0, 0.0)
            .is_ok()
    );
}

#[test]
fn a_start_whose_terms_overflow_is_refused() {
    let observer = Observer::new(1.0, 1.0, 1.0, 0.5).unwrap();
    let law = |bias: f64| {
        let pid = Pid::proportional(1.0).unwrap().with_bias(bias, None).unwrap();
        Settings::new(pid).with_observer(observer).unwrap()
    };
    let line = [Segment::default(); 5];
    // Found by the fuzz target `controller`: the load estimate was infinite, and the law never came to itself.
    let apart = State::switched_on(&law(1e308), line, -1e308).unwrap_err();
    assert!(apart.to_string().contains("manipulated_variable"), "{apart}");
    let far = State::at_rest(&law(0.0), line, 1e308, -1e308, 0.0).unwrap_err();
    assert!(far.to_string().contains("controlled_variable"), "{far}");
    assert!(State::at_rest(&law(0.0), line, 1e300, 0.0, 0.0).is_ok());
}
