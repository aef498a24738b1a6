//! Whatever comes in, the output is finite and within its limits, and the loop comes back.

use holdup_control::{Input, Mode, Watch};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

use crate::laws::{Law, PERIOD};
use crate::plant::Loop;

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -2.0..2.0,
        1 => prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(f64::NEG_INFINITY), Just(0.0), Just(-0.0)],
        1 => prop_oneof![Just(f64::MAX), Just(f64::MIN), Just(f64::MIN_POSITIVE), Just(1e300), Just(-1e12)],
        1 => any::<f64>(),
    ]
}

fn input() -> impl Strategy<Value = Input<f64>> {
    let period = prop_oneof![4 => 0.01..0.3, 1 => number()];
    let mode =
        prop_oneof![4 => Just(Mode::Automatic), 1 => number().prop_map(Mode::Manual), 1 => Just(Mode::Hold)];
    let optional = || prop_oneof![number().prop_map(Some), Just(None)];
    (period, number(), optional(), number(), optional(), mode).prop_map(
        |(sample_period, setpoint, controlled_variable, feed_forward, applied, mode)| Input {
            sample_period,
            setpoint,
            controlled_variable,
            feed_forward,
            applied,
            mode,
        },
    )
}

fn run(cases: u32, test: impl Fn(Vec<Input<f64>>) -> Result<(), TestCaseError>) {
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    TestRunner::new(config).run(&prop::collection::vec(input(), 1..60), test).unwrap();
}

pub(crate) fn any_input_gives_a_finite_output_within_the_limits(law: &Law) {
    run(300, |inputs| {
        let watch = Watch::none().with_stale_time(1.0).unwrap().with_failure(3.0, 0.25).unwrap();
        let mut double = Loop::at_rest(law.limited::<f64>(-0.5, 0.5).with_watch(watch).unwrap());
        let mut single = Loop::at_rest(law.limited::<f32>(-0.5, 0.5));
        let mut free = Loop::at_rest(law.settings::<f64>());
        for input in &inputs {
            let u = double.state.update(&double.settings, input).manipulated_variable;
            prop_assert!((-0.5..=0.5).contains(&u), "{u}");
            let u = single.state.update(&single.settings, &narrow(input)).manipulated_variable;
            prop_assert!((-0.5..=0.5).contains(&u), "{u} in f32");
            let u = free.state.update(&free.settings, input).manipulated_variable;
            prop_assert!(u.is_finite(), "{u} without limits");
        }
        Ok(())
    });
}

#[expect(clippy::cast_possible_truncation, reason = "any f32 will do, infinite ones included")]
fn narrow(input: &Input<f64>) -> Input<f32> {
    Input {
        sample_period: input.sample_period as f32,
        setpoint: input.setpoint as f32,
        controlled_variable: input.controlled_variable.map(|value| value as f32),
        feed_forward: input.feed_forward as f32,
        applied: input.applied.map(|value| value as f32),
        mode: match input.mode {
            Mode::Manual(value) => Mode::Manual(value as f32),
            Mode::Automatic => Mode::Automatic,
            Mode::Hold => Mode::Hold,
        },
    }
}

pub(crate) fn the_loop_returns_to_the_setpoint_after_any_input(law: &Law) {
    run(40, |inputs| {
        let watch = Watch::none().with_stale_time(1.0).unwrap().with_failure(3.0, 0.25).unwrap();
        let watch = watch.with_range(-20.0, 20.0).unwrap();
        let mut run = Loop::at_rest(law.limited::<f64>(-0.5, 0.5).with_watch(watch).unwrap());
        for input in &inputs {
            // A setpoint, a load or an actuator that is said to stand at 1e300 is believed: not asked here.
            let sane = |value: f64| if value.abs() < 20.0 { value } else { f64::NAN };
            let input = Input {
                setpoint: sane(input.setpoint),
                feed_forward: sane(input.feed_forward),
                applied: input.applied.map(sane),
                sample_period: sane(input.sample_period),
                ..*input
            };
            let u = run.state.update(&run.settings, &input).manipulated_variable;
            run.controlled_variable = run.plant.hold(u, PERIOD);
        }
        run.run(300.0, PERIOD, 1.0);
        prop_assert!((run.controlled_variable - 1.0).abs() < 0.01, "{}", run.controlled_variable);
        Ok(())
    });
}
