//! What a new tuning would do: margins over everything the record does not exclude, and the record run again with it.

use holdup_control::SettingError;
use serde::Serialize;
use thiserror::Error;

use super::controller::RunningController;
use super::identification::{Identification, IdentifiedProcess};
use super::identify::{Fit, Kind};
use super::replay::{Drive, Law, Steps, run};
use super::wording::three;
use super::{Record, diagnosis};
use crate::analysis::frequency::{FrequencyError, Margins, margins};
use crate::model::{ClosedLoop, Controller, ModelError, NoSampledLaw, Process, Radians, Seconds};
use crate::tuning::{Parameters, RuleError, Tuning, rule};

/// Gains that are tried at each dead time of the region.
const GAINS: u32 = 4;

/// Halvings of the search about the worst point that was tried.
const HALVINGS: u32 = 6;

/// Why there is no new tuning.
#[derive(Debug, Error)]
pub enum RetuneError {
    /// Nothing to tune for.
    #[error("the record was refused: there is no process to tune for")]
    Refused,
    /// A self-regulating process.
    #[error("the process is self-regulating: the rules here are for integrating processes")]
    SelfRegulating,
    /// The rule gives nothing.
    #[error(transparent)]
    Rule(#[from] RuleError),
    /// The loop cannot be analysed.
    #[error(transparent)]
    Frequency(#[from] FrequencyError),
    /// Settings out of range.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A controller that does not run in samples.
    #[error("the record cannot be run again with it: {0}")]
    Law(#[from] NoSampledLaw),
}

/// The worst over the confidence region, by trying many points and searching about the worst: not a proof.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Worst {
    /// Whether the loop is stable at every point that was tried.
    pub stable: bool,
    /// Greatest sensitivity peak; absent where a loop is unstable.
    pub sensitivity_peak: Option<f64>,
    /// Least gain margin.
    pub gain_margin: Option<f64>,
    /// Least phase margin [°].
    pub phase_margin_deg: Option<f64>,
    /// Process gain of the greatest sensitivity peak.
    pub process_gain: f64,
    /// Dead time of the greatest sensitivity peak [s].
    pub dead_time_s: f64,
    /// Points that were tried.
    pub points: usize,
}

/// A run over the record.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Replay {
    /// Standard deviation of the control error [output unit].
    pub standard_deviation: f64,
    /// Greatest control error [output unit].
    pub peak: f64,
    /// Sum of the manipulated variable's moves [input unit].
    pub travel: f64,
    /// Controlled variable at the rows.
    #[serde(skip)]
    pub controlled_variable: Vec<f64>,
    /// Manipulated variable at the rows.
    #[serde(skip)]
    pub manipulated_variable: Vec<f64>,
}

/// A new tuning and what it would do.
#[derive(Debug, Clone)]
pub struct Retuning {
    /// The tuning.
    pub tuning: Tuning,
    /// Why the rule's speed was chosen so.
    pub choice: String,
    /// The process that was tuned for.
    pub process: Process,
    /// Margins at the best values.
    pub nominal: Margins,
    /// Their worst over the region.
    pub worst: Worst,
    /// The record as it was.
    pub recorded: Replay,
    /// The record run again with the recovered controller: how far the replay can be believed.
    pub before: Option<Replay>,
    /// The record run again with the new tuning.
    pub after: Replay,
}

/// Tunes by a rule for the identified process, and shows what would change.
///
/// With `pi-simc` the closed-loop time is that which keeps the running controller's gain where that is safe, and never below
/// the longest dead time that the record does not exclude. The replay keeps everything that the input does not explain: load and
/// noise; the law of `holdup_control`, which is the one that runs in the plant, runs once a row.
///
/// # Errors
/// [`RetuneError`] where there is no process or the rule does not apply.
pub fn retune(record: &Record, answer: &Identification, id: &str) -> Result<Retuning, RetuneError> {
    let (Some(found), Some(confidence)) = (&answer.process, &answer.confidence) else {
        return Err(RetuneError::Refused);
    };
    if found.kind == Kind::FirstOrder {
        return Err(RetuneError::SelfRegulating);
    }
    let time = record.time();
    #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
    let row = (time[time.len() - 1] - time[0]) / (time.len() - 1) as f64;
    let process = found.process(Seconds(row))?;
    let entry = rule(id)?;
    let mut parameters = Parameters::new();
    let mut choice = "the rule's own speed".to_owned();
    if entry.parameters.iter().any(|parameter| parameter.name == "tau_c") {
        let longest = confidence.dead_time[1].max(process.dead_time());
        let present =
            answer.controller.as_ref().map(|running| running.proportional_gain.value * found.process_gain);
        let same = present.filter(|gain| *gain > 0.0).map(|gain| 1.0 / gain - process.dead_time());
        let speed = same.unwrap_or(0.0).max(longest);
        choice = if same.is_some_and(|same| same >= longest) {
            format!("closed-loop time {} s: the gain stays as it is", three(speed))
        } else {
            format!(
                "closed-loop time {} s: the longest dead time that the record does not exclude",
                three(speed)
            )
        };
        parameters = parameters.set("tau_c", speed);
    }
    let tuning = entry.tune(&process, &parameters)?;
    let nominal = margins(&ClosedLoop::new(&process, &tuning.controller))?;
    let worst = worst(answer, found, &tuning.controller, row)?;
    let rows = Rows::new(record, found);
    let running = answer.controller.as_ref();
    let delay = running.map_or(0, |running| running.delay_rows);
    let law = Law::designed(&process, &tuning.controller, Seconds(row), delay)?;
    let before = running.and_then(|running| rows.run(&Law::recovered(running).ok()?).ok());
    Ok(Retuning {
        choice,
        process,
        nominal,
        worst,
        recorded: rows.replay(record.controlled_variable().to_vec(), record.manipulated_variable().to_vec()),
        before,
        after: rows.run(&law).map_err(NoSampledLaw::from)?,
        tuning,
    })
}

/// The worst margins over the region: a grid over its slices, then ever closer about the greatest sensitivity peak.
fn worst(
    answer: &Identification,
    found: &IdentifiedProcess,
    controller: &Controller,
    row: f64,
) -> Result<Worst, RetuneError> {
    let mut worst = Worst {
        stable: true,
        sensitivity_peak: None,
        gain_margin: None,
        phase_margin_deg: None,
        process_gain: found.process_gain,
        dead_time_s: found.dead_time,
        points: 0,
    };
    let mut place = (0, 0.5);
    let mut at = |index: usize, share: f64, place: &mut (usize, f64)| -> Result<(), RetuneError> {
        let slice = &answer.region[index];
        let [low, high] = slice.process_gain;
        let gain = low + share * (high - low);
        let here =
            IdentifiedProcess { process_gain: gain, dead_time: slice.dead_time, lag: slice.lag, ..*found };
        let achieved = margins(&ClosedLoop::new(&here.process(Seconds(row))?, controller))?;
        worst.points += 1;
        worst.stable &= achieved.stable;
        let least = |a: Option<f64>, b: Option<f64>| match (a, b) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        };
        worst.gain_margin = least(worst.gain_margin, achieved.gain_margin);
        worst.phase_margin_deg = least(worst.phase_margin_deg, achieved.phase_margin.map(Radians::degrees));
        let peak = achieved.sensitivity_peak;
        if peak > worst.sensitivity_peak || !achieved.stable {
            worst.sensitivity_peak = peak;
            (worst.process_gain, worst.dead_time_s) = (gain, slice.dead_time);
            *place = (index, share);
        }
        Ok(())
    };
    for index in 0..answer.region.len() {
        for k in 0..=GAINS {
            at(index, f64::from(k) / f64::from(GAINS), &mut place)?;
        }
    }
    let mut reach = 0.5 / f64::from(GAINS);
    for _ in 0..HALVINGS {
        let (index, share) = place;
        for (index, share) in [
            (index, share + reach),
            (index, share - reach),
            (index + 1, share),
            (index.wrapping_sub(1), share),
        ] {
            if index < answer.region.len() && (0.0..=1.0).contains(&share) {
                at(index, share, &mut place)?;
            }
        }
        reach /= 2.0;
    }
    if !worst.stable {
        worst.sensitivity_peak = None;
    }
    Ok(worst)
}

/// The record as deviations from its first row, and what its input does not explain.
struct Rows<'r> {
    record: &'r Record,
    fit: Fit,
    setpoint: Vec<f64>,
    rest: Vec<f64>,
    limits: Option<[f64; 2]>,
}

impl<'r> Rows<'r> {
    fn new(record: &'r Record, found: &IdentifiedProcess) -> Self {
        let (time, output, input) =
            (record.time(), record.controlled_variable(), record.manipulated_variable());
        let fit = Fit {
            kind: found.kind,
            dead_time: found.dead_time,
            lag: found.lag.unwrap_or(1.0),
            gain: found.process_gain,
            squares: 0.0,
            column_squares: 0.0,
        };
        let moved: Vec<f64> = input.iter().map(|value| value - input[0]).collect();
        let mut steps = Steps::new(fit, time);
        let mut rest = vec![0.0];
        for k in 0..time.len() - 1 {
            rest.push(output[k + 1] - output[0] - steps.next(&moved[..=k], 0.0, k));
        }
        #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
        let mean = output.iter().sum::<f64>() / output.len() as f64;
        let setpoint = record.setpoint().map_or_else(
            || vec![mean - output[0]; time.len()],
            |setpoint| setpoint.iter().map(|value| value - output[0]).collect(),
        );
        // Percent of span where it looks like it, else as far as the actuator likes.
        let percent = input.iter().all(|value| (0.0..=100.0).contains(value));
        let limits = percent.then(|| [-input[0], 100.0 - input[0]]);
        Self { record, fit, setpoint, rest, limits }
    }

    fn run(&self, law: &Law) -> Result<Replay, SettingError> {
        let time = self.record.time();
        let nothing = vec![0.0; time.len()];
        let drive = Drive {
            setpoint: &self.setpoint,
            by_hand: &vec![None; time.len()],
            load: &nothing,
            disturbance: &self.rest,
        };
        let (output, input) = run(&law.within(self.limits)?, self.fit, time, &drive)?;
        let (first, stand) = (self.record.controlled_variable()[0], self.record.manipulated_variable()[0]);
        Ok(self.replay(
            output.into_iter().map(|value| value + first).collect(),
            input.into_iter().map(|value| value + stand).collect(),
        ))
    }

    fn replay(&self, controlled_variable: Vec<f64>, manipulated_variable: Vec<f64>) -> Replay {
        let first = self.record.controlled_variable()[0];
        let errors: Vec<f64> =
            controlled_variable.iter().zip(&self.setpoint).map(|(y, r)| r + first - y).collect();
        #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
        let rows = errors.len() as f64;
        Replay {
            standard_deviation: (errors.iter().map(|error| error * error).sum::<f64>() / rows).sqrt(),
            peak: errors.iter().fold(0.0, |most, error| f64::max(most, error.abs())),
            travel: manipulated_variable.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum(),
            controlled_variable,
            manipulated_variable,
        }
    }
}

/// The running controller as the library has it, for a table beside the new one.
#[must_use]
pub fn running_controller(running: &RunningController) -> Option<Controller> {
    diagnosis::controller(running)
}
