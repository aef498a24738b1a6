//! The crate `differential-equations` on the loop of the paper.
//!
//! Dormand–Prince with dense history and error control. It is started when the first input arrives, so that the jump of
//! the start is no step's concern; the integrals are states. Several tolerances, because only some reach an accuracy that
//! can be compared.

use std::hint::black_box;
use std::time::Duration;

use differential_equations::prelude::*;
use serde_json::json;

use crate::work::{DEAD_TIME, GAIN};
use crate::{best, report};

const KC: f64 = 2.95;
const TI: f64 = 15.0;
const TD: f64 = 3.0;
const TF: f64 = TD / 100.0;
const LOAD_AT: f64 = 100.0;
const HORIZON: f64 = 200.0;

/// y, the integral of the error, the filtered error; then IAE, ISE, ITAE and control energy.
struct Loop;

fn controller_output([y, area, filtered]: [f64; 3]) -> f64 {
    let error = 1.0 - y;
    KC * (error + area / TI + TD / TF * (error - filtered))
}

impl DDE<1, f64, [f64; 7]> for Loop {
    fn diff(&self, t: f64, x: &[f64; 7], delayed: &[[f64; 7]; 1], rate: &mut [f64; 7]) {
        let [y, area, filtered, ..] = delayed[0];
        let load = f64::from(t - DEAD_TIME >= LOAD_AT);
        let error = 1.0 - x[0];
        rate[0] = GAIN * (controller_output([y, area, filtered]) + load);
        rate[1] = error;
        rate[2] = (error - x[2]) / TF;
        rate[3] = error.abs();
        rate[4] = error * error;
        rate[5] = t * error.abs();
        rate[6] = controller_output([x[0], x[1], x[2]]).powi(2);
    }

    fn lags(&self, _t: f64, _x: &[f64; 7], lags: &mut [f64; 1]) {
        lags[0] = DEAD_TIME;
    }
}

/// What happens before the first input arrives: the output rests, the controller sees an error of 1.
fn at_rest(t: f64) -> [f64; 7] {
    let t = t.max(0.0);
    let decay = (-t / TF).exp();
    // u/Kc = 1 + t/Ti + (Td/Tf)·e^(−t/Tf), squared and integrated.
    let ramp = TI / 3.0 * ((1.0 + t / TI).powi(3) - 1.0);
    let mixed = 2.0 * TD * (1.0 - decay + (TF - (t + TF) * decay) / TI);
    let pulse = TD * TD / (2.0 * TF) * (1.0 - decay * decay);
    [0.0, t, 1.0 - decay, t, t, t * t / 2.0, KC * KC * (ramp + mixed + pulse)]
}

fn integrals(tolerance: f64) -> Option<[f64; 4]> {
    let method = ExplicitRungeKutta::dopri5()
        .rtol(tolerance)
        .atol(tolerance)
        .max_delay(DEAD_TIME + 1.0)
        .max_steps(100_000_000);
    let start = at_rest(DEAD_TIME);
    let solution = IVP::dde(&Loop, DEAD_TIME, HORIZON, start, at_rest).method(method).solve().ok()?;
    let [.., iae, ise, itae, energy] = *solution.y.last()?;
    Some([iae, ise, itae, energy])
}

pub(crate) fn run() {
    for exponent in [4, 5, 6, 7, 8, 9, 10, 11] {
        let tolerance = 10_f64.powi(-exponent);
        let Some(values) = integrals(tolerance) else {
            report("metrics", u64::from(exponent.unsigned_abs()), f64::NAN, json!(null));
            continue;
        };
        let seconds = best(Duration::from_millis(200), || {
            _ = black_box(integrals(black_box(tolerance)));
        });
        report("metrics", u64::from(exponent.unsigned_abs()), seconds, json!(values));
    }
}
