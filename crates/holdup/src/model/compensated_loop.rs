//! The states of a dead-time compensator: as few as its law needs, none of them with a pole of its own at the
//! origin.

use super::closed_loop::{Channel, ClosedLoop, Source, Sum, Window, process_states};
use super::compensator::{Compensator, CompensatorLaw, Lead};
use super::process::Process;

/// Channel of the compensator's model.
const MODEL: usize = 1;

/// What the controller makes of y, and what enters the channel of its model.
struct Law {
    output: Sum,
    model_input: Option<Sum>,
    load_estimate: Option<Sum>,
    windows: Vec<Window>,
}

/// The loop of this process and this compensator.
pub(super) fn compensated_loop(process: &Process, compensator: &Compensator) -> ClosedLoop {
    let mut rates = Vec::new();
    let (y, _) = process_states(&mut rates, process, process.process_gain(), 0);
    let model_gain = compensator.model_gain();
    let law = match compensator.law() {
        CompensatorLaw::ModifiedSmith { main_gain, disturbance_gain, lead } => {
            modified_smith(&mut rates, y, model_gain, main_gain, disturbance_gain, lead)
        }
        CompensatorLaw::TwoDegree { setpoint_time, a1, a2 } => {
            let beta = a1 + compensator.model_dead_time();
            two_degree(&mut rates, y, model_gain, [setpoint_time, a1, a2, beta])
        }
        CompensatorLaw::InverseModel { main_gain, filter_time } => {
            inverse_model(&mut rates, y, model_gain, main_gain, filter_time)
        }
        CompensatorLaw::DisturbanceRejection { controller_bandwidth, observer_bandwidth } => {
            disturbance_rejection(&mut rates, y, model_gain, controller_bandwidth, observer_bandwidth)
        }
    };
    let input = law.output.clone().plus(Source::Load, 1.0);
    let mut channels = vec![Channel { delay: process.dead_time(), input }];
    if let Some(input) = law.model_input {
        channels.push(Channel { delay: compensator.model_dead_time(), input });
    }
    ClosedLoop {
        rates,
        channels,
        windows: law.windows,
        controlled_variable: y,
        manipulated_variable: law.output,
        load_estimate: law.load_estimate,
    }
}

fn state(index: usize, weight: f64) -> Sum {
    Sum::default().plus(Source::State(index), weight)
}

/// The undelayed prediction is the one state of predictor and main control together; the model's output is that
/// state one dead time ago. Separate integrators for the two would leave a pole at the origin.
fn modified_smith(
    rates: &mut Vec<Sum>,
    y: usize,
    model_gain: f64,
    main_gain: f64,
    disturbance_gain: f64,
    lead: Option<Lead>,
) -> Law {
    let predicted = rates.len();
    let error = state(y, 1.0).plus(Source::Delayed(MODEL), -1.0);
    let main = Sum::default()
        .plus(Source::Setpoint, main_gain)
        .plus(Source::State(predicted), -main_gain)
        .plus_sum(&error, -main_gain);
    rates.push(Sum::default().plus_sum(&main, model_gain));
    let estimate = match lead {
        None => Sum::default().plus_sum(&error, disturbance_gain),
        Some(Lead { derivative_time, filter_time }) => {
            // The state is the filtered error plus the prediction: alone it would be nothing but rounding where the
            // model is perfect, and a simulation cannot resolve the shape of rounding.
            let shifted = rates.len();
            let ratio = derivative_time / filter_time;
            let filtered = state(shifted, 1.0).plus(Source::State(predicted), -1.0);
            rates.push(
                Sum::default()
                    .plus_sum(&error, 1.0 / filter_time)
                    .plus_sum(&filtered, -1.0 / filter_time)
                    .plus_sum(&main, model_gain),
            );
            Sum::default()
                .plus_sum(&error, disturbance_gain * ratio)
                .plus_sum(&filtered, disturbance_gain * (1.0 - ratio))
        }
    };
    Law {
        output: main.plus_sum(&estimate, -1.0),
        model_input: Some(state(predicted, 1.0)),
        load_estimate: Some(estimate),
        windows: Vec::new(),
    }
}

/// Divided by s, the law reads, with w the integral of u over the last dm and A = a2·s² + a1·s + 1,
/// `(a2·s + a1)·u − β·e^(−dm·s)·u + w = [A·r/(T·s + 1) − (β·s + 1)·y]/Km`,
/// and `A/(T·s + 1) = α1·s + α0 + α/(T·s + 1)`.
fn two_degree(rates: &mut Vec<Sum>, y: usize, model_gain: f64, [t, a1, a2, beta]: [f64; 4]) -> Law {
    let alpha_1 = a2 / t;
    let alpha_0 = (a1 - alpha_1) / t;
    let alpha = 1.0 - alpha_0;
    let (w, held) = (rates.len(), rates.len() + 1);
    // The state h is a2·u + (β·y − α1·r)/Km: its rate has no derivative in it.
    let output = state(held, 1.0 / a2)
        .plus(Source::State(y), -beta / (a2 * model_gain))
        .plus(Source::Setpoint, alpha_1 / (a2 * model_gain));
    rates.push(output.clone().plus(Source::Delayed(MODEL), -1.0));
    let mut rate = Sum::default()
        .plus_sum(&output, -a1)
        .plus(Source::Delayed(MODEL), beta)
        .plus(Source::State(w), -1.0)
        .plus(Source::State(y), -1.0 / model_gain)
        .plus(Source::Setpoint, alpha_0 / model_gain);
    // Where T is a root of A the setpoint needs no filter of its own; α is then the rounding of two quotients.
    if alpha.abs() > 8.0 * f64::EPSILON * (1.0 + (a1 + alpha_1) / t) {
        rate = rate.plus(Source::State(held + 1), alpha / model_gain);
        rates.push(rate);
        rates.push(Sum::default().plus(Source::Setpoint, 1.0 / t).plus(Source::State(held + 1), -1.0 / t));
    } else {
        rates.push(rate.plus(Source::Setpoint, alpha / model_gain));
    }
    Law {
        model_input: Some(output.clone()),
        output,
        load_estimate: None,
        windows: vec![Window { state: w, channel: MODEL }],
    }
}

/// `D̂ = y/(Km·Tf) − z` with `Tf·z' + z = y/(Km·Tf) + e^(−dm·s)·u`: the derivative of y is not formed.
fn inverse_model(rates: &mut Vec<Sum>, y: usize, model_gain: f64, kc: f64, tf: f64) -> Law {
    let z = rates.len();
    let level = 1.0 / (model_gain * tf);
    rates.push(state(z, -1.0 / tf).plus(Source::State(y), level / tf).plus(Source::Delayed(MODEL), 1.0 / tf));
    let estimate = state(y, level).plus(Source::State(z), -1.0);
    let output =
        Sum::default().plus(Source::Setpoint, kc).plus(Source::State(y), -kc).plus_sum(&estimate, -1.0);
    Law { model_input: Some(output.clone()), output, load_estimate: Some(estimate), windows: Vec::new() }
}

fn disturbance_rejection(rates: &mut Vec<Sum>, y: usize, b0: f64, wc: f64, wo: f64) -> Law {
    let (z1, z2) = (rates.len(), rates.len() + 1);
    let output = Sum::default()
        .plus(Source::Setpoint, wc / b0)
        .plus(Source::State(z1), -wc / b0)
        .plus(Source::State(z2), -1.0 / b0);
    let innovation = state(y, 1.0).plus(Source::State(z1), -1.0);
    rates.push(
        Sum::default()
            .plus(Source::Setpoint, wc)
            .plus(Source::State(z1), -wc)
            .plus_sum(&innovation, 2.0 * wo),
    );
    rates.push(Sum::default().plus_sum(&innovation, wo * wo));
    Law { output, model_input: None, load_estimate: Some(state(z2, 1.0 / b0)), windows: Vec::new() }
}
