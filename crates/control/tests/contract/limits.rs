//! Limits, and the way back from them.

use holdup_control::{Input, Limited, Limits};

use crate::laws::{Law, PERIOD};
use crate::plant::Loop;

pub(crate) fn the_limits_are_never_exceeded(law: &Law) {
    let limits = Limits::new(Some(-0.2), Some(0.3)).unwrap().with_rate(0.5).unwrap();
    let mut run = Loop::at_rest(law.settings().with_limits(limits).unwrap());
    let mut met = Vec::new();
    let mut last = 0.0_f64;
    for sample in 0..600 {
        run.load = if sample > 300 { 0.1 } else { 0.0 };
        let setpoint = [1.0, -3.0, 4.0, 0.0][sample / 150];
        let output = run.automatic(PERIOD, setpoint);
        let u = output.manipulated_variable;
        assert!((-0.2..=0.3).contains(&u), "{u} at sample {sample}");
        // The step is computed as last + 0.05: one rounding of each.
        assert!((u - last).abs() <= 0.5 * PERIOD + 1e-15, "{last} to {u} at sample {sample}");
        last = u;
        if !met.contains(&output.limited) {
            met.push(output.limited);
        }
    }
    for limit in [Limited::No, Limited::Low, Limited::High, Limited::Rate] {
        assert!(met.contains(&limit), "{limit:?} was never met");
    }
}

pub(crate) fn saturation_ends_when_the_setpoint_is_reached(law: &Law) {
    // 40 s at the limit; a law that winds up would stay there long after.
    let mut run = Loop::at_rest(law.limited::<f64>(-0.1, 0.1));
    let mut saturated_until = 0.0;
    let mut reached = f64::INFINITY;
    while run.plant.time() < 150.0 {
        if run.automatic(PERIOD, 4.0).limited == Limited::High {
            saturated_until = run.plant.time();
        }
        if run.controlled_variable >= 4.0 {
            reached = reached.min(run.plant.time());
        }
    }
    assert!(saturated_until > 20.0, "the test does not saturate");
    // One sample later at the latest; a law without overshoot never gets quite there.
    assert!(
        saturated_until <= reached + 2.0 * PERIOD,
        "reached at {reached}, saturated until {saturated_until}"
    );
    assert!((run.controlled_variable - 4.0).abs() < 0.01, "{}", run.controlled_variable);
}

pub(crate) fn the_loop_recovers_from_an_output_that_was_not_applied(law: &Law) {
    // Somebody closes a hand valve for 30 s; the controller is told what was applied.
    let mut run = Loop::at_rest(law.settings::<f64>());
    while run.plant.time() < 150.0 {
        let shut = run.plant.time() < 30.0;
        let input =
            Input { applied: shut.then_some(0.0), ..Input::automatic(PERIOD, 1.0, run.controlled_variable) };
        let u = run.state.update(&run.settings, &input).manipulated_variable;
        run.controlled_variable = run.plant.hold(if shut { 0.0 } else { u }, PERIOD);
        assert!(run.controlled_variable < 1.6, "{} at {}", run.controlled_variable, run.plant.time());
    }
    assert!((run.controlled_variable - 1.0).abs() < 0.01, "{}", run.controlled_variable);
}
