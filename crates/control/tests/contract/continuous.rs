//! The continuous loop, built apart from the crate: Euler's method on its equations with a tiny step.

use crate::laws::Law;

/// y at each whole second of a run to a setpoint of 1 at 0 and a load at 10 s.
pub(crate) fn outputs(law: &Law, load: f64, seconds: usize) -> Vec<f64> {
    const STEPS: usize = 2000; // steps a second
    let h = 1.0 / 2000.0;
    let delay = STEPS; // of 1 s
    let (b, c) = law.weights;
    let kc = law.proportional_gain;
    let (ko, lead) = law.observer.unwrap_or((0.0, None));
    let (mut y, mut model, mut free, mut integral) = (0.0, 0.0, 0.0, 0.0);
    // Filters by the state that follows their input; at rest before the setpoint moves.
    let (mut followed, mut followed_innovation) = (0.0, 0.0);
    let (mut inputs, mut drives) = (vec![0.0; delay], vec![0.0; delay]);
    let mut outputs = Vec::new();
    for step in 0..=seconds * STEPS {
        if step % STEPS == 0 {
            outputs.push(y);
        }
        let load = if step >= 10 * STEPS { load } else { 0.0 };
        // `free` is the model without dead time: what the modified Smith predictor adds is its lead.
        let seen = if law.predicts { y + free - model } else { y };
        let motion = inputs[step];
        let mut u = kc * (b - seen) + integral;
        match law.derivative {
            Some((td, Some(tf))) => {
                let slope = (c - seen - followed) / tf;
                followed += h * slope;
                u += kc * td * slope;
            }
            Some((td, None)) => u += kc * td * -motion,
            None => {}
        }
        if let Some(ti) = law.integral_time {
            integral += h * kc / ti * (1.0 - seen);
        }
        let innovation = y - model;
        let mut estimate = ko * innovation;
        if let Some((td, tf)) = lead {
            let slope = (innovation - followed_innovation) / tf;
            followed_innovation += h * slope;
            estimate += ko * (td - tf) * slope;
        }
        let drive = u;
        u -= estimate;
        y += h * motion;
        model += h * drives[step];
        free += h * drive;
        inputs.push(u + load);
        drives.push(drive);
    }
    outputs
}
