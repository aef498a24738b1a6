//! A loop run again at the rows of a record: what the setpoint and the hand alone would have done, or what another
//! controller would have done against the same load. The law is the one that runs in the plant, `holdup_control`.

use holdup_control::{Input, Limits, Mode, Pid, Segment, SettingError, Settings, State, segments_needed};

use super::controller::RunningController;
use super::identify::{Fit, Kind};
use crate::model::{Controller, NoSampledLaw, Process, Seconds, sampled_law};

/// A controller that runs once a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Law {
    settings: Settings<f64>,
    /// Rows after which the controller answers the controlled variable.
    delay: usize,
}

impl Law {
    /// The recovered controller.
    pub(crate) fn recovered(running: &RunningController) -> Result<Self, SettingError> {
        let mut pid = Pid::proportional(running.proportional_gain.value)?
            .with_setpoint_weights(running.setpoint_weight.unwrap_or(1.0), 0.0)?;
        if let Some(time) = running.integral_time {
            pid = pid.with_integral(time.value)?;
        }
        if let Some(time) = running.derivative_time {
            pid = pid.with_derivative(time.value, None)?;
        }
        Ok(Self { settings: Settings::new(pid), delay: running.delay_rows })
    }

    /// A controller designed on a process, with rows a mean `row` apart, which answers after so many rows.
    pub(crate) fn designed(
        process: &Process,
        controller: &Controller,
        row: Seconds,
        delay: usize,
    ) -> Result<Self, NoSampledLaw> {
        let law = sampled_law(process, controller, row)?;
        let mut settings = Settings::new(law.pid);
        if let Some(observer) = law.observer {
            settings = settings.with_observer(observer)?;
        }
        Ok(Self { settings, delay })
    }

    /// The same within the least and the greatest manipulated variable, as deviations.
    pub(crate) fn within(self, limits: Option<[f64; 2]>) -> Result<Self, SettingError> {
        let Some([low, high]) = limits else { return Ok(self) };
        let settings = self.settings.with_limits(Limits::new(Some(low), Some(high))?)?;
        Ok(Self { settings, ..self })
    }

    /// The delay line that an observer needs over rows of any distance.
    fn line(&self, time: &[f64]) -> Vec<Segment<f64>> {
        let Some(observer) = self.settings.law().observer else { return Vec::new() };
        let shortest = time.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
        let segments = segments_needed(observer.dead_time(), shortest);
        vec![Segment::default(); segments.min(1 << 22).max(self.settings.segments_needed())]
    }
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
}

/// Controlled and manipulated variable at the rows, as deviations. At the first row the controller is at rest.
pub(crate) fn run(
    law: &Law,
    fit: Fit,
    time: &[f64],
    drive: &Drive<'_>,
) -> Result<(Vec<f64>, Vec<f64>), SettingError> {
    let rows = time.len();
    let mut steps = Steps::new(fit, time);
    let (mut output, mut input) = (vec![drive.disturbance[0]], Vec::with_capacity(rows));
    let mut state = State::at_rest(&law.settings, law.line(time), drive.setpoint[0], output[0], 0.0)?;
    for k in 0..rows {
        let mut value = state.manipulated_variable;
        if k > 0 {
            let seen = output[k.saturating_sub(law.delay)];
            let mode = drive.by_hand[k].map_or(Mode::Automatic, |change| Mode::Manual(value + change));
            let given = Input::automatic(time[k] - time[k - 1], drive.setpoint[k], seen);
            value = state.update(&law.settings, &Input { mode, ..given }).manipulated_variable;
        }
        input.push(value);
        if k + 1 < rows {
            output.push(drive.disturbance[k + 1] + steps.next(&input, drive.load[k], k));
        }
    }
    Ok((output, input))
}
