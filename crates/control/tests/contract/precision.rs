//! Rounding: f32, long runs, restarts.

use holdup_control::{Input, Limits, Segment, State};

use crate::laws::{Law, Line, PERIOD, SEGMENTS, at_rest};
use crate::plant::Loop;

pub(crate) fn f32_is_close_to_f64(law: &Law) {
    let mut single = Loop::at_rest(law.limited::<f32>(-0.8, 0.8));
    let mut double = Loop::at_rest(law.limited::<f64>(-0.8, 0.8));
    for sample in 0..1000 {
        let load = if sample > 400 && law.rejects_loads() { 0.3 } else { 0.0 };
        (single.load, double.load) = (load, load);
        single.automatic(PERIOD, 1.0);
        double.automatic(PERIOD, 1.0);
        // A slope is a difference of numbers near 1, rounded to 6e-8, over h = 0.1 s: 5e-7 with Kc Td, some times
        // over in the loop.
        let difference = (single.output - double.output).abs();
        assert!(difference < 5e-6, "{difference} at sample {sample}");
    }
}

pub(crate) fn a_constant_measurement_at_the_setpoint_moves_nothing(law: &Law) {
    constant_measurement(law, 1_000_000);
}

pub(crate) fn constant_measurement(law: &Law, samples: u32) {
    let settings = law.limited::<f32>(-0.8, 0.8);
    // The load that the law holds; without integral and observer there is none.
    let held = if law.rejects_loads() { -0.3 } else { 0.0 };
    let mut state = State::at_rest(&settings, [Segment::default(); SEGMENTS], 0.7, 0.7, held).unwrap();
    for sample in 0..samples {
        let sample_period = if sample & 1 == 0 { 0.07 } else { 0.11 };
        let output = state.update(&settings, &Input::automatic(sample_period, 0.7, 0.7)).manipulated_variable;
        assert_eq!(output, held, "at sample {sample}");
    }
}

pub(crate) fn a_constant_measurement_brings_the_state_back_to_itself(law: &Law) {
    // Bit for bit the same state and the same inputs: what holds for one round holds for ever.
    let settings = law.limited::<f32>(-0.8, 0.8);
    let held = if law.rejects_loads() { -0.3 } else { 0.0 };
    let mut state = State::at_rest(&settings, [Segment::default(); SEGMENTS], 0.7, 0.7, held).unwrap();
    let two_samples = |state: &mut State<f32, Line<f32>>| {
        for sample_period in [0.07, 0.11] {
            state.update(&settings, &Input::automatic(sample_period, 0.7, 0.7));
        }
    };
    for _ in 0..1000 {
        two_samples(&mut state);
    }
    let before = state;
    let returns = (0..1000).any(|_| {
        two_samples(&mut state);
        state == before
    });
    assert!(returns, "{before:?} became {state:?}");
}

pub(crate) fn a_restored_state_continues_bit_for_bit(law: &Law) {
    let mut run = Loop::at_rest(law.settings::<f64>());
    run.load = 0.1;
    run.run(12.3, PERIOD, 1.0);
    let saved = run.state;
    let mut restored = run.clone();
    run.run(1.0, PERIOD, 2.0);
    restored.state = saved;
    restored.run(1.0, PERIOD, 2.0);
    for _ in 0..100 {
        run.automatic(PERIOD, 2.0);
        restored.automatic(PERIOD, 2.0);
        assert_eq!(run.output.to_bits(), restored.output.to_bits());
        assert_eq!(run.state, restored.state);
    }
}

pub(crate) fn other_units_give_the_same_answer(law: &Law) {
    // Time in units four times as small, output in units half as large: powers of 2, so bit for bit.
    let scaled = Law {
        proportional_gain: 2.0 * law.proportional_gain,
        integral_time: law.integral_time.map(|time| 4.0 * time),
        derivative: law.derivative.map(|(time, filter)| (4.0 * time, filter.map(|filter| 4.0 * filter))),
        observer: law.observer.map(|(gain, lead)| (2.0 * gain, lead.map(|(td, tf)| (4.0 * td, 4.0 * tf)))),
        ..*law
    };
    let limits = |size: f64| Limits::new(Some(-size), Some(size)).unwrap();
    let settings = law.settings::<f64>().with_limits(limits(0.6)).unwrap();
    let scaled = scaled.settings_with_model(0.125, 4.0).with_limits(limits(1.2)).unwrap();
    let (mut state, mut twin) = (at_rest(&settings), at_rest(&scaled));
    for sample in 0..300_u32 {
        let y = f64::from(sample * 37 % 101) * 0.01;
        let u = state.update(&settings, &Input::automatic(PERIOD, 0.7, y)).manipulated_variable;
        let v = twin.update(&scaled, &Input::automatic(4.0 * PERIOD, 0.7, y)).manipulated_variable;
        assert_eq!(2.0 * u, v, "at sample {sample}");
    }
}
