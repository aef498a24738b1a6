//! A loop run again at the rows of a record: what the setpoint and the hand alone would have done, or what another
//! controller would have done against the same load.

use super::identify::{Fit, Kind};

/// A controller in velocity form at the rows: Δu = Kc·(b·Δr − Δy + e·h/Ti − Td·Δ(y′)).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Law {
    pub(crate) proportional_gain: f64,
    pub(crate) integral_time: Option<f64>,
    pub(crate) derivative_time: f64,
    pub(crate) setpoint_weight: f64,
}

/// The process in steps between rows, its input held and delayed by any dead time.
pub(crate) struct Steps<'t> {
    fit: Fit,
    time: &'t [f64],
    /// Row whose input acts at the start of the next step.
    acting: usize,
    integrals: [f64; 2],
    lagged: f64,
}

impl<'t> Steps<'t> {
    /// At rest at the first row; inputs are deviations from what was before it.
    pub(crate) fn new(fit: Fit, time: &'t [f64]) -> Self {
        Self { fit, time, acting: 0, integrals: [0.0; 2], lagged: 0.0 }
    }

    /// The output at row `row` + 1 from the inputs up to `row`, with a load at the process input that holds between rows.
    pub(crate) fn next(&mut self, inputs: &[f64], load: f64, row: usize) -> f64 {
        let (mut at, end) = (self.time[row], self.time[row + 1]);
        let dead_time = self.fit.dead_time;
        while at < end {
            while self.acting < inputs.len() && self.time[self.acting] + dead_time <= at {
                self.acting += 1;
            }
            // Before the first row's input arrives the input is at rest.
            let input = if self.acting == 0 { 0.0 } else { inputs[self.acting - 1] };
            let change =
                if self.acting < inputs.len() { self.time[self.acting] + dead_time } else { f64::INFINITY };
            let to = change.min(end);
            self.hold(input + load, to - at);
            at = to;
        }
        match self.fit.kind {
            Kind::Integrating | Kind::IntegratingWithLag => self.fit.gain * self.integrals[0],
            Kind::DoubleIntegrating => self.fit.gain * self.integrals[1],
            Kind::FirstOrder => self.fit.gain * self.lagged,
        }
    }

    /// The states after the input has stood for so long.
    fn hold(&mut self, input: f64, time: f64) {
        let (before, lag) = (self.integrals[0], self.fit.lag);
        if self.fit.kind.has_lag() {
            let decay = (-time / lag).exp();
            let lagged = input + (self.lagged - input) * decay;
            self.integrals[0] += input * time - lag * (lagged - self.lagged);
            self.lagged = lagged;
        } else {
            self.integrals[0] += input * time;
            self.integrals[1] += time * (before + time * input / 2.0);
        }
    }
}

/// What acts on the loop at each row.
pub(crate) struct Drive<'d> {
    /// Setpoint, as deviation from the first.
    pub(crate) setpoint: &'d [f64],
    /// Where the manipulated variable was moved by another hand than the controller's: its change since the row before.
    pub(crate) by_hand: &'d [Option<f64>],
    /// Load at the process input, as deviation.
    pub(crate) load: &'d [f64],
    /// What is added to the output beside the process: initial movement and noise.
    pub(crate) disturbance: &'d [f64],
    /// Least and greatest manipulated variable, as deviation from the first.
    pub(crate) limits: [f64; 2],
}

/// Controlled and manipulated variable at the rows, as deviations.
pub(crate) fn run(law: &Law, fit: Fit, time: &[f64], drive: &Drive<'_>) -> (Vec<f64>, Vec<f64>) {
    let rows = time.len();
    let mut steps = Steps::new(fit, time);
    let (mut output, mut input) = (vec![drive.disturbance[0]], Vec::with_capacity(rows));
    let mut value = 0.0;
    for k in 0..rows {
        if let Some(change) = drive.by_hand[k] {
            value += change;
        } else if k > 0 {
            let step = time[k] - time[k - 1];
            let moved = output[k] - output[k - 1];
            let before =
                if k > 1 { (output[k - 1] - output[k - 2]) / (time[k - 1] - time[k - 2]) } else { 0.0 };
            let setpoint = drive.setpoint[k] - drive.setpoint[k - 1];
            let error = drive.setpoint[k] - output[k];
            let integral = law.integral_time.map_or(0.0, |time| error * step / time);
            let rate = law.derivative_time * (moved / step - before);
            value += law.proportional_gain * (law.setpoint_weight * setpoint - moved + integral - rate);
            value = value.clamp(drive.limits[0], drive.limits[1]);
        }
        input.push(value);
        if k + 1 < rows {
            output.push(drive.disturbance[k + 1] + steps.next(&input, drive.load[k], k));
        }
    }
    (output, input)
}
