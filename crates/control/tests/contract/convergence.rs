//! The sampled loop against the continuous one.

use holdup_control::Input;

use crate::continuous;
use crate::laws::Law;
use crate::plant::Loop;

const SECONDS: usize = 25;

fn load(law: &Law) -> f64 {
    if law.rejects_loads() { 0.2 } else { 0.0 }
}

/// The largest difference of y at whole seconds.
fn error(law: &Law, reference: &[f64], sample_period: f64) -> f64 {
    let mut run = Loop::at_rest(law.settings::<f64>());
    let mut worst = 0.0_f64;
    for (second, expected) in reference.iter().enumerate() {
        worst = worst.max((run.controlled_variable - expected).abs());
        run.load = if second >= 10 { load(law) } else { 0.0 };
        run.run(1.0, sample_period, 1.0);
    }
    worst
}

pub(crate) fn the_sampled_loop_tends_to_the_continuous_one_in_first_order(law: &Law) {
    let reference = continuous::outputs(law, load(law), SECONDS);
    let errors = [0.1, 0.05, 0.025].map(|sample_period| error(law, &reference, sample_period));
    assert!(errors[0] < 0.1, "{errors:?}");
    // Half the sample period, half the error; the terms of second order and the reference's own error (its step
    // is 1/50 of the smallest here) leave this much.
    for pair in errors.windows(2) {
        assert!((1.6..2.5).contains(&(pair[0] / pair[1])), "{errors:?}");
    }
}

pub(crate) fn early_and_late_samples_change_little(law: &Law) {
    let reference = continuous::outputs(law, load(law), SECONDS);
    let regular = error(law, &reference, 0.05);
    let mut run = Loop::at_rest(law.settings::<f64>());
    let mut worst = 0.0_f64;
    let mut elapsed = 0.05;
    for (second, expected) in reference.iter().enumerate() {
        worst = worst.max((run.controlled_variable - expected).abs());
        run.load = if second >= 10 { load(law) } else { 0.0 };
        // 20 samples a second, up to half a sample early or late; each is told the time since the one before.
        for period in [0.03, 0.06, 0.075, 0.035, 0.05].into_iter().cycle().take(20) {
            let input = Input::automatic(elapsed, 1.0, run.controlled_variable);
            let output = run.state.update(&run.settings, &input).manipulated_variable;
            run.controlled_variable = run.plant.hold(output + run.load, period);
            elapsed = period;
        }
    }
    // A law that took the sample period for granted would be wrong by half of every integral.
    assert!(worst < 1.5 * regular, "{worst} with jitter, {regular} without");
}
