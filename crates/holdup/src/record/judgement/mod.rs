//! From a record to an answer: fit, compare, judge, advise.

mod found;
mod resolution;
mod verdict;

use thiserror::Error;

use super::confidence::{Profile, inflations};
use super::controller::{RunningController, recover};
use super::diagnosis::diagnose;
use super::excitation::{Excitation, moved_from_outside, outside};
use super::identification::{Candidate, Identification, IdentifyOptions, Verdict};
use super::identify::{Hold, Joint, Kind, Whitened, exact};
use super::load::recover_load;
use super::load_steps::load_steps;
use super::valve::fault;
use super::{Record, Survey};
use crate::model::Seconds;
use found::{Found, process_of, quality};
use resolution::resolution;
use verdict::{nothing_from_outside, verdict};

/// Least rows.
const LEAST_ROWS: usize = 20;

/// Why a record cannot be identified at all.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum IdentifyError {
    /// The input has one value.
    #[error(
        "the manipulated variable stands at {value} throughout: nothing can be identified without its movement"
    )]
    Still {
        /// The value.
        value: f64,
    },
    /// The output has one value.
    #[error("the controlled variable stands at {value} throughout: a dead signal")]
    Dead {
        /// The value.
        value: f64,
    },
    /// Too few rows.
    #[error("the record has {found} rows: at least {LEAST_ROWS} are needed")]
    TooShort {
        /// Rows that are there.
        found: usize,
    },
    /// A limit that is no time.
    #[error("the greatest dead time is {value} s: must be above 0 and shorter than the record")]
    DeadTime {
        /// The value.
        value: f64,
    },
}

/// Identifies the process of a record, or says why it cannot be, with the controller that was running and the load.
///
/// # Errors
/// [`IdentifyError`] where there is nothing to work on. A record that does not identify its process is an answer: the verdict
/// is then [`Verdict::Refused`].
///
/// ```
/// use holdup::record::{IdentifyOptions, Record, Verdict, identify};
///
/// // A tank: the valve opened by 10 % from 60 s to 120 s; gain 0.002 /s, dead time 7.3 s; the level read to 0.001.
/// let time: Vec<f64> = (0..300).map(f64::from).collect();
/// let valve: Vec<f64> = time.iter().map(|t| if (60.0..120.0).contains(t) { 60.0 } else { 50.0 }).collect();
/// let level = |t: f64| 40.0 + 0.02 * (t - 67.3).clamp(0.0, 60.0) + 0.004 * (7.0 * t).sin();
/// let level = time.iter().map(|t| (1000.0 * level(*t)).round() / 1000.0).collect();
/// let answer = identify(&Record::new(time, level, valve)?, &IdentifyOptions::default())?;
/// assert_eq!(answer.verdict, Verdict::Identified);
/// let process = answer.process.ok_or("none")?;
/// assert!((process.process_gain - 0.002).abs() < 1e-4 && (process.dead_time - 7.3).abs() < 0.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn identify(record: &Record, options: &IdentifyOptions) -> Result<Identification, IdentifyError> {
    check(record, options)?;
    let survey = Survey::of(record);
    let controller = recover(record);
    let excitation = Excitation::of(record, controller.as_ref());
    let mut answer = Identification {
        verdict: Verdict::Refused,
        reasons: Vec::new(),
        model: None,
        process: None,
        confidence: None,
        region: Vec::new(),
        choice: String::new(),
        candidates: Vec::new(),
        excitation,
        controller,
        load_steps: Vec::new(),
        load: None,
        fit: None,
        diagnosis: diagnose(None, None, &survey, excitation.closed_loop, None),
        test: None,
    };
    let found = Found::of(record, options, &excitation);
    if !excitation.any() {
        answer.reasons.push(nothing_from_outside(answer.controller.as_ref(), &survey));
        answer.diagnosis = diagnose(None, answer.controller.as_ref(), &survey, true, None);
        answer.test = found.and_then(|found| found.test(record, options));
        return Ok(answer);
    }
    let Some(found) = found else {
        answer.reasons.push("no dead time gives the input any effect on the controlled variable".to_owned());
        return Ok(answer);
    };
    judge(&mut answer, &found, record, options, &survey);
    Ok(answer)
}

fn check(record: &Record, options: &IdentifyOptions) -> Result<(), IdentifyError> {
    if record.len() < LEAST_ROWS {
        return Err(IdentifyError::TooShort { found: record.len() });
    }
    let same = |values: &[f64]| values.windows(2).all(|pair| pair[0] == pair[1]);
    if same(record.manipulated_variable()) {
        return Err(IdentifyError::Still { value: record.manipulated_variable()[0] });
    }
    if same(record.controlled_variable()) {
        return Err(IdentifyError::Dead { value: record.controlled_variable()[0] });
    }
    let span = record.time()[record.len() - 1] - record.time()[0];
    match options.greatest_dead_time {
        Some(value) if !(value > 0.0 && value < 0.9 * span) => Err(IdentifyError::DeadTime { value }),
        _ => Ok(()),
    }
}

/// Intervals, verdict and what follows.
fn judge(
    answer: &mut Identification,
    found: &Found<'_>,
    record: &Record,
    options: &IdentifyOptions,
    survey: &Survey,
) {
    let Found { problem, joint, greatest, .. } = found;
    let without_noise = exact(problem, &joint.fit);
    let (resolution, rounded) =
        if without_noise { (0.0, None) } else { resolution(record, survey, &joint.noise) };
    let mut inflation = inflations(problem, joint, resolution);
    let outside = answer
        .controller
        .as_ref()
        .filter(|_| answer.excitation.closed_loop)
        .map(|controller| outside(record, problem, joint, controller));
    if let Some(outside) = &outside {
        // What the controller's answer to the noise says holds only as far as the noise model does: it does not count.
        inflation.gain.factor *= outside.excess[0];
        inflation.dead_time.factor *= outside.excess[1];
    }
    let whitener = joint.whitener(problem);
    let whitened = Whitened::new(problem, &whitener, joint.fit.kind);
    let profile = Profile::new(&whitened, joint, *greatest, inflation);
    let mut confidence = profile.confidence();
    let between = answer.controller.as_ref().is_some_and(|controller| controller.between_rows);
    if answer.excitation.closed_loop && between && options.hold == Hold::Constant {
        // The input that the rows show as steps moved between them, on average half a row earlier.
        confidence.dead_time[1] += found.step / 2.0;
    }
    answer.candidates = found
        .candidates
        .iter()
        .map(|(joint, criterion)| Candidate {
            kind: joint.fit.kind,
            process: process_of(joint),
            criterion: *criterion,
        })
        .collect();
    answer.choice.clone_from(&found.choice);
    answer.fit = Some(quality(found, &whitened));
    let (verdict, reasons) =
        verdict(answer, found, outside.as_ref(), &confidence, &inflation, rounded.as_deref());
    answer.verdict = verdict;
    answer.reasons = reasons;
    if verdict != Verdict::Identified {
        answer.test = found.test(record, options);
    }
    let (controller, closed_loop) = (answer.controller.as_ref(), answer.excitation.closed_loop);
    if verdict == Verdict::Refused {
        answer.diagnosis = diagnose(None, controller, survey, closed_loop, None);
        return;
    }
    let process = process_of(joint);
    answer.model = Some(process.kind);
    answer.process = Some(process);
    answer.confidence = Some(confidence);
    answer.region = profile.region();
    answer.load_steps = load_steps(problem, joint, &whitener, &inflation.gain);
    answer.load = recover_load(record, problem, joint);
    let model = process.process(Seconds(found.step)).ok().filter(|_| process.kind != Kind::FirstOrder);
    let rest = controller.and_then(|controller| not_from_outside(record, joint, controller));
    let survey = rest.as_ref().unwrap_or(survey);
    let valve = if closed_loop && !without_noise { fault(record, problem, joint) } else { None };
    answer.diagnosis = diagnose(model.as_ref(), controller, survey, closed_loop, valve);
}

/// The survey of what setpoint, hand and limits do not explain: a cycle beside their moves.
fn not_from_outside(record: &Record, joint: &Joint, controller: &RunningController) -> Option<Survey> {
    let (level, output) = moved_from_outside(record, joint.fit, controller)?;
    let less = |values: &[f64], moved: &[f64]| values.iter().zip(moved).map(|(a, b)| a - b).collect();
    let rest = Record::new(
        record.time().to_vec(),
        less(record.controlled_variable(), &level),
        less(record.manipulated_variable(), &output),
    );
    Some(Survey::of(&rest.ok()?))
}
