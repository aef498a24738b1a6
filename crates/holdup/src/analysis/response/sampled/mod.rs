//! The response of a sampled loop: the very law of `holdup-control`, real equipment, and the process exact between
//! samples.
//!
//! The output is held from sample to sample, so what drives the process is a chain of straight lines, and the process
//! answers with polynomials and, where it has a lag, one exponential: closed form at every instant, whatever fraction
//! of a sample the dead time is. The metrics are those of the continuous response, from the same integrals,
//! extrema and roots; they see what happens between samples.

mod equipment;
mod error;
mod load;
mod plant;
mod run;
mod sensor;
mod trajectory;
mod valve;

pub use equipment::{Equipment, EquipmentError, EquipmentSettings, LoadRamp};
pub use error::SampledError;
pub use trajectory::SampledTrajectory;

use holdup_control::Settings;

use super::cell::{Cell, Outcome, Watch};
use super::legendre::TERMS;
use super::measure::Measure;
use super::{Response, Scenario, measure_of, response};
use crate::analysis::frequency::margins;
use crate::analysis::frequency::sampled::{is_stable, largest_stable_period};
use crate::model::{ClosedLoop, Controller, Process, Seconds, sampled_law};
use run::{Count, Moment, Run};
use trajectory::Sampler;

/// Samples that a run may have.
const MOST_SAMPLES: u32 = 20_000_000;

/// Samples that a dead time may have.
const MOST_IN_DEAD_TIME: u32 = 1_000_000;

/// A controller that runs sample by sample, its equipment and the process that it acts on.
///
/// ```
/// use holdup::analysis::response::Scenario;
/// use holdup::analysis::response::sampled::{Equipment, EquipmentSettings, SampledLoop};
/// use holdup::model::{Process, Seconds, notation::read_controller};
/// let level = Process::integrating(0.0506, Seconds(6.0))?;
/// let controller = read_controller("Kc=1.5321,Td=1.0343,N=100,Ko=1.5321")?;
/// let equipment = Equipment::new(EquipmentSettings { sample_period: 0.5, ..Default::default() })?;
/// let sampled = SampledLoop::new(&level, &controller, &equipment)?;
/// let step = Scenario::unit_setpoint_step(Seconds(100.0))?;
/// let (run, _) = sampled.simulate(&step, &[], &[])?;
/// assert_eq!(run.samples, 201);
/// assert!(run.response.metrics.iae > Some(6.0)); // no controller beats the dead time
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct SampledLoop {
    settings: Settings<f64>,
    controller: Controller,
    designed_on: Process,
    process: Process,
    equipment: Equipment,
}

/// The numbers of one sampled response.
#[derive(Debug, Clone, PartialEq)]
pub struct SampledResponse {
    /// What a continuous response has, too, with the valve's travel among the metrics. Energy and variation are
    /// those of the law's output about its rest.
    pub response: Response,
    /// Valve position at the end [input unit].
    pub final_valve_position: f64,
    /// Number of samples taken.
    pub samples: u64,
    /// Number of measurements lost.
    pub lost_samples: u64,
    /// Number of samples at which a limit held the output.
    pub limited_samples: u64,
}

impl SampledLoop {
    /// The loop of a controller designed on `process`, and acting on it.
    ///
    /// # Errors
    /// [`SampledError`] if there is no sampled law for this controller, or if the sample period is longer than the dead
    /// time or less than a millionth of it.
    pub fn new(
        process: &Process,
        controller: &Controller,
        equipment: &Equipment,
    ) -> Result<Self, SampledError> {
        let h = equipment.settings().sample_period;
        let dead_time = process.dead_time();
        if h > dead_time {
            return Err(SampledError::SlowerThanDeadTime { value: h, dead_time });
        }
        check_count(h, dead_time, "dead time", MOST_IN_DEAD_TIME)?;
        let law = sampled_law(process, controller, Seconds(h))?;
        let mut settings = Settings::new(law.pid);
        if let Some(observer) = law.observer {
            settings = settings.with_observer(observer)?;
            let dead_time = observer.dead_time();
            if h > dead_time {
                return Err(SampledError::SlowerThanDeadTime { value: h, dead_time });
            }
            check_count(h, dead_time, "dead time of the model", MOST_IN_DEAD_TIME)?;
        }
        let equipment = equipment.clone();
        Ok(Self { settings, controller: *controller, designed_on: *process, process: *process, equipment })
    }

    /// The same controller acting on another process than the one it was designed on: its model does not follow.
    #[must_use]
    pub fn on(self, actual: &Process) -> Self {
        Self { process: *actual, ..self }
    }

    /// The same loop without sampling and with ideal equipment. None where there is no such loop: an observer's
    /// model is that of the process it was designed on, and the continuous one has always the structure of the
    /// process that it acts on.
    #[must_use]
    pub fn continuous(&self) -> Option<ClosedLoop> {
        let mut controller = self.controller;
        if let Some(observer) = controller.observer().filter(|_| self.process != self.designed_on) {
            if !self.process.is_plain() {
                return None;
            }
            let gain = observer.model_gain().unwrap_or(self.designed_on.process_gain());
            let dead_time = observer.model_dead_time().unwrap_or(self.designed_on.dead_time());
            let observer =
                observer.with_model_gain(gain).ok()?.with_model_dead_time(Seconds(dead_time)).ok()?;
            controller = controller.with_observer(observer);
        }
        Some(ClosedLoop::new(&self.process, &controller))
    }

    /// Refuses sampling that is too slow for the loop: where the loop is stable without sampling, and with it is not.
    ///
    /// # Errors
    /// [`SampledError::SlowerThanStable`] with the largest sample period up to which it is stable.
    pub fn require_stable(&self) -> Result<(), SampledError> {
        let settings = self.equipment.settings();
        let (value, delay) = (settings.sample_period, Seconds(settings.computation_delay));
        let law = *self.settings.law();
        if is_stable(&law, &self.process, value, delay) {
            return Ok(());
        }
        let stable_without = self.continuous().is_none_or(|closed| margins(&closed).is_ok_and(|m| m.stable));
        let at = |h| sampled_law(&self.designed_on, &self.controller, Seconds(h)).ok();
        match largest_stable_period(&self.process, at, delay).filter(|_| stable_without) {
            Some(largest) if largest < value => Err(SampledError::SlowerThanStable { value, largest }),
            _ => Ok(()),
        }
    }

    /// The settings with which `holdup-control` runs, without limits.
    #[must_use]
    pub fn law(&self) -> &Settings<f64> {
        &self.settings
    }

    /// The process that the controller acts on.
    #[must_use]
    pub fn process(&self) -> &Process {
        &self.process
    }

    /// The equipment.
    #[must_use]
    pub fn equipment(&self) -> &Equipment {
        &self.equipment
    }

    /// Simulates the loop over a scenario with load ramps; also the signals at these times [s], in any order.
    ///
    /// # Errors
    /// [`SampledError`] if a time or a ramp is outside 0 … horizon, or the horizon has more than 20 million samples.
    pub fn simulate(
        &self,
        scenario: &Scenario,
        ramps: &[LoadRamp],
        times: &[f64],
    ) -> Result<(SampledResponse, SampledTrajectory), SampledError> {
        let (horizon, h) = (scenario.horizon(), self.equipment.settings().sample_period);
        check_count(h, horizon, "horizon", MOST_SAMPLES)?;
        if let Some(ramp) = ramps.iter().find(|ramp| ramp.end() > horizon) {
            return Err(SampledError::RampBeyondHorizon { value: ramp.end(), horizon });
        }
        if let Some(&value) = times.iter().find(|time| !(**time >= 0.0 && **time <= horizon)) {
            return Err(SampledError::TimeOutside { value, horizon });
        }
        let rest = self.equipment.settings().initial_manipulated;
        let run = Run::new(&self.settings, &self.process, &self.equipment, scenario, ramps)?;
        // Overshoot and settling are about one setpoint move and nothing else.
        let mut measure = if ramps.is_empty() { measure_of(scenario) } else { Measure::new(None) };
        let mut sampler = Sampler::new(scenario, rest, self.settings.law().observer.is_some(), times);
        let mut position = 0.0;
        let delay = Seconds(self.equipment.settings().computation_delay);
        let count = run.run(Seconds(h), delay, |moment| {
            cells(moment, &mut measure);
            sampler.take(moment, horizon);
            position = moment.valve.0 + moment.valve.1 * moment.piece.length;
        });
        let outcome = Outcome { overflow_at: count.overflow_at, impulsive: false };
        let mut response = response(scenario, measure, outcome);
        response.final_manipulated_variable += rest;
        if count.overflow_at.is_none() {
            response.metrics.valve_travel = Some(count.travel);
        }
        let Count { samples, lost, limited, .. } = count;
        let response = SampledResponse {
            response,
            final_valve_position: rest + position,
            samples,
            lost_samples: lost,
            limited_samples: limited,
        };
        Ok((response, sampler.finish()))
    }

    /// Times for drawing [s]: `points` uniform ones, the samples (of the first `points`) and the events, each twice, just before
    /// and at it, so that a held signal is drawn as steps.
    #[must_use]
    pub fn plot_times(&self, scenario: &Scenario, ramps: &[LoadRamp], points: usize) -> Vec<f64> {
        let horizon = scenario.horizon();
        let points = u32::try_from(points.clamp(2, 1 << 24)).unwrap_or(u32::MAX);
        let mut times: Vec<f64> =
            (0..points).map(|i| horizon * (f64::from(i) / f64::from(points - 1))).collect();
        let settings = self.equipment.settings();
        let outputs = (0..points).map(|k| f64::from(k) * settings.sample_period + settings.computation_delay);
        for time in outputs.take_while(|time| *time < horizon).chain(load::changes(scenario, ramps)) {
            // One part in 1e9 of a sample: below what a pixel shows, above rounding.
            times.push((time - 1e-9 * settings.sample_period).max(0.0));
            times.push((time + 1e-9 * settings.sample_period).min(horizon));
        }
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }
}

/// Refuses a sample period that gives more than `most` samples in this time [s].
fn check_count(h: f64, time: f64, of: &'static str, most: u32) -> Result<(), SampledError> {
    if time / h <= f64::from(most) {
        return Ok(());
    }
    Err(SampledError::TooManySamples { value: h, least: time / f64::from(most), of, most })
}

/// Shows a piece of the response as the cells that the measures are made for.
fn cells(moment: &Moment<'_>, watch: &mut impl Watch) {
    let mut manipulated = [0.0; TERMS];
    manipulated[0] = moment.manipulated;
    let estimate = moment.load_estimate.map(|value| {
        let mut estimate = [0.0; TERMS];
        estimate[0] = value;
        estimate
    });
    moment.piece.polynomials(|from, length, output| {
        let mut error = output.map(|c| -c);
        error[0] += moment.setpoint;
        watch.cell(&Cell {
            start: moment.piece.start + from,
            length,
            setpoint: moment.setpoint,
            error: &error,
            manipulated: &manipulated,
            load_estimate: estimate.as_ref(),
        });
    });
}
