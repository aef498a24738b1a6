//! From a record to an answer: fit, compare, judge, advise.

use thiserror::Error;

use super::advice::safe_test;
use super::confidence::{Confidence, Inflations, Profile, inflations, open_ended};
use super::controller::{RunningController, recover};
use super::diagnosis::diagnose;
use super::excitation::{Excitation, Outside, outside};
use super::identification::{
    Candidate, FitQuality, Identification, IdentifiedProcess, IdentifyOptions, Verdict,
};
use super::identify::{
    Hold, Joint, Kind, Noise, Problem, Whitened, exact, greatest_dead_time, joint, starting_noises,
};
use super::load::recover_load;
use super::{CompressionKind, Record, Survey};
use crate::model::Seconds;

/// Least rows.
const LEAST_ROWS: usize = 20;

/// Rows above which neighbours are taken together.
const MOST_ROWS: usize = 3000;

/// Another kind than the plain integrator must be better by so much of Schwarz's criterion.
const EVIDENCE: f64 = 6.0;

/// A kind counts only if its gain is so many variances from 0.
const ACTS: f64 = 16.0;

/// Relative half width of the gain's interval above which the verdict is weak, and above which there is none.
const WEAK: f64 = 0.35;
const NOTHING: f64 = 0.8;

/// Relative standard deviation of the gain by movement from outside alone, above which the same holds.
const WEAK_OUTSIDE: f64 = 0.2;
const NOTHING_OUTSIDE: f64 = 0.5;

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
        load: None,
        fit: None,
        diagnosis: diagnose(None, None, &survey, excitation.closed_loop),
        test: None,
    };
    let found = Found::of(record, options, &excitation);
    if !excitation.any() {
        answer.reasons.push(nothing_from_outside(answer.controller.as_ref(), &survey));
        answer.diagnosis = diagnose(None, answer.controller.as_ref(), &survey, true);
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

/// Why constant setpoint and automatic identify nothing.
fn nothing_from_outside(controller: Option<&RunningController>, survey: &Survey) -> String {
    let mut text = "in automatic at a constant setpoint the manipulated variable only answers the controlled one: no setpoint \
                    move, no hand, no limit tells the process apart from its controller, and what a fit returns would follow \
                    from what is assumed of the noise"
        .to_owned();
    if let (Some(seen), Some(controller)) = (survey.controlled_variable.oscillation, controller) {
        let frequency = std::f64::consts::TAU / seen.period_s;
        let lag = controller.integral_time.map_or(0.0, |time| 1.0 / (frequency * time.value));
        let size = controller.proportional_gain.value.abs() * lag.hypot(1.0);
        text += &format!(
            "; of the cycle of {:.4} s the fit is perfect and returns the controller: K = ω/|C(jω)| = {:.4e} /s, ω·d = π/2 + \
             arg C(jω), d = {:.4} s",
            seen.period_s,
            frequency / size,
            (std::f64::consts::FRAC_PI_2 - lag.atan()) / frequency
        );
    }
    text
}

/// The fits of all kinds, the chosen first.
struct Found<'r> {
    problem: Problem<'r>,
    joint: Joint,
    candidates: Vec<(Joint, f64)>,
    choice: String,
    greatest: f64,
    step: f64,
    block: usize,
}

impl<'r> Found<'r> {
    fn of(record: &'r Record, options: &IdentifyOptions, excitation: &Excitation) -> Option<Self> {
        let time = record.time();
        #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
        let step = (time[time.len() - 1] - time[0]) / (time.len() - 1) as f64;
        let mut greatest = options.greatest_dead_time.unwrap_or_else(|| greatest_dead_time(record));
        let rest = at_rest(record, excitation.closed_loop);
        let mut block = record.len().div_ceil(MOST_ROWS);
        let of = |greatest: f64, block: usize| {
            let from = if rest { 0 } else { time.partition_point(|t| t - time[0] < greatest) };
            let from = from.min(record.len() - LEAST_ROWS / 2);
            Problem::new(record, from, block, options.hold, options.load)
        };
        let mut problem = of(greatest, block);
        let first = options.kind.unwrap_or(Kind::Integrating);
        let mut plain = joint(&problem, first, step, greatest, &starting_noises(problem.step()))?;
        if !rest && options.greatest_dead_time.is_none() {
            // What a long dead time would need of the record's start is free once the dead time is known to be short.
            let inflation = inflations(&problem, &plain, 0.0);
            let whitener = plain.whitener(&problem);
            let whitened = Whitened::new(&problem, &whitener, first);
            let ends = Profile::new(&whitened, &plain, greatest, inflation).confidence().dead_time;
            let shorter = (1.5 * ends[1] + 5.0 * step).min(greatest);
            if shorter < 0.8 * greatest {
                greatest = shorter;
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "from 1 to some thousand"
                )]
                let most = (shorter / step / 4.0).floor().max(1.0) as usize;
                block = block.min(most);
                problem = of(greatest, block);
                plain = joint(&problem, first, step, greatest, &[plain.noise, Noise::WHITE])?;
            }
        }
        let mut candidates = vec![plain];
        if options.kind.is_none() && !exact(&problem, &plain.fit) {
            for kind in &Kind::ALL[1..] {
                candidates.extend(joint(&problem, *kind, step, greatest, &[plain.noise, Noise::WHITE]));
            }
        }
        // A working loop has K·Kc > 0, so a candidate of the other sign is none.
        let sign = excitation.sign * f64::from(u8::from(excitation.closed_loop));
        candidates.retain(|joint| joint.fit.kind == first || sign * joint.fit.gain >= 0.0);
        let (candidates, choice) = choose(&problem, &candidates);
        Some(Self { joint: candidates[0].0, problem, candidates, choice, greatest, step, block })
    }

    fn test(&self, record: &Record, options: &IdentifyOptions) -> Option<super::advice::SafeTest> {
        let values = record.controlled_variable();
        let [low, high] = values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &value| {
            [low.min(value), high.max(value)]
        });
        safe_test(&self.joint, self.step, options.excursion.unwrap_or((high - low) / 2.0))
    }
}

/// Whether the input may be taken as constant before the record: it is at the start, or it is a hand's that seldom moves.
fn at_rest(record: &Record, closed_loop: bool) -> bool {
    let input = record.manipulated_variable();
    let first = input.iter().position(|value| *value != input[0]).unwrap_or(input.len());
    let moves = input.windows(2).filter(|pair| pair[0] != pair[1]).count();
    first >= 4 || (!closed_loop && first >= 2 && 10 * moves < input.len())
}

/// Orders the candidates by Schwarz's criterion, the plain integrator in front unless another is clearly better.
fn choose(problem: &Problem<'_>, joints: &[Joint]) -> (Vec<(Joint, f64)>, String) {
    #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
    let rows = problem.len() as f64;
    let criterion = |joint: &Joint| {
        // Own columns, gain, dead time, lag; the noise costs all kinds the same.
        #[expect(clippy::cast_precision_loss, reason = "a handful")]
        let fitted = problem.own_columns(joint.fit.kind, joint.fit.lag.max(1e-9)).len() as f64;
        let fitted = fitted + 2.0 + f64::from(u8::from(joint.fit.kind.has_lag()));
        fitted * rows.ln() - 2.0 * joint.likelihood
    };
    let mut ranked: Vec<(Joint, f64)> = joints.iter().map(|joint| (*joint, criterion(joint))).collect();
    let plain = ranked[0].1;
    // A simulation without noise: the simplest kind that leaves rounding only.
    if let Some(place) = joints.iter().position(|joint| exact(problem, &joint.fit)) {
        ranked.swap(0, place);
        let kind = ranked[0].0.fit.kind;
        return (ranked, format!("{kind}: it leaves rounding only"));
    }
    ranked.sort_by(|a, b| a.1.total_cmp(&b.1));
    let best = ranked[0];
    // A first order so slow that the record does not see it settle is an integrator, a lag below a row is none.
    let real = match best.0.fit.kind {
        Kind::FirstOrder => best.0.fit.lag < 2.0 * problem.span(),
        Kind::IntegratingWithLag => best.0.fit.lag > 0.5 * problem.step(),
        _ => true,
    };
    // Nor is one whose input explains nothing: its noise does the work.
    let acts =
        best.0.fit.gain.powi(2) * best.0.fit.column_squares * best.0.freedom > ACTS * best.0.fit.squares;
    let clearly = plain - best.1 > EVIDENCE && real && acts;
    if !clearly && let Some(place) = ranked.iter().position(|(joint, _)| joint.fit.kind == joints[0].fit.kind)
    {
        let plain = ranked.remove(place);
        ranked.insert(0, plain);
    }
    let chosen = ranked[0];
    for candidate in &mut ranked {
        candidate.1 -= chosen.1;
    }
    let kind = chosen.0.fit.kind;
    let choice = if ranked.len() == 1 {
        format!("{kind}: the only one compared")
    } else if clearly && kind != joints[0].fit.kind {
        format!(
            "{kind}: Schwarz's criterion is lower by {:.0} than for {} (above {EVIDENCE:.0} is clear)",
            plain - best.1,
            joints[0].fit.kind
        )
    } else {
        let next = ranked[1..].iter().map(|(_, criterion)| *criterion).fold(f64::INFINITY, f64::min);
        format!(
            "{kind}: the simplest, and no other is clearly better (Schwarz's criterion of the next: {next:+.0})"
        )
    };
    (ranked, choice)
}

fn process_of(joint: &Joint) -> IdentifiedProcess {
    let fit = &joint.fit;
    IdentifiedProcess {
        kind: fit.kind,
        process_gain: fit.process_gain(),
        dead_time: fit.dead_time,
        lag: fit.kind.has_lag().then_some(fit.lag),
        static_gain: (fit.kind == Kind::FirstOrder).then_some(fit.gain),
    }
}

/// The typical step from one archived point to the next, where rows between them lie on straight lines: an archive keeps a
/// point when it is farther off than its band, so that the band is not wider.
fn archived_step(record: &Record) -> f64 {
    let (time, values) = (record.time(), record.controlled_variable());
    let slope = |k: usize| (values[k + 1] - values[k]) / (time[k + 1] - time[k]);
    let bends = |k: &usize| {
        let (before, after) = (slope(k - 1), slope(*k));
        (after - before).abs() > 1e-6 * before.abs().max(after.abs())
    };
    let corners: Vec<f64> = (1..values.len() - 1).filter(bends).map(|k| values[k]).collect();
    let mut steps: Vec<f64> = corners.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    if steps.is_empty() {
        return 0.0;
    }
    let middle = steps.len() / 2;
    *steps.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// How far single rows are from the truth by what the historian did, where that is above the noise.
fn resolution(record: &Record, survey: &Survey, noise: &Noise) -> (f64, Option<String>) {
    let signal = &survey.controlled_variable;
    let spread = noise.white.hypot(noise.coloured);
    if let Some(compression) = &signal.compression
        && compression.kind != CompressionKind::OnChange
        && compression.share > 0.1
    {
        let text = format!("the controlled variable was compressed ({})", compression.evidence);
        return (spread.max(archived_step(record)), Some(text));
    }
    match &signal.quantisation {
        Some(quantisation) if quantisation.quantum > spread => {
            let text = format!(
                "the controlled variable is rounded to {:.3}, more than the noise",
                quantisation.quantum
            );
            (quantisation.quantum / 4.0, Some(text))
        }
        _ => (0.0, None),
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
    if verdict == Verdict::Refused {
        answer.diagnosis = diagnose(None, answer.controller.as_ref(), survey, answer.excitation.closed_loop);
        return;
    }
    let process = process_of(joint);
    answer.model = Some(process.kind);
    answer.process = Some(process);
    answer.confidence = Some(confidence);
    answer.region = profile.region();
    answer.load = recover_load(record, problem, joint);
    let model = process.process(Seconds(found.step)).ok().filter(|_| process.kind != Kind::FirstOrder);
    answer.diagnosis =
        diagnose(model.as_ref(), answer.controller.as_ref(), survey, answer.excitation.closed_loop);
}

fn verdict(
    answer: &Identification,
    found: &Found<'_>,
    outside: Option<&Outside>,
    confidence: &Confidence,
    inflation: &Inflations,
    rounded: Option<&str>,
) -> (Verdict, Vec<String>) {
    let Found { problem, joint, greatest, step, .. } = found;
    let (mut refused, mut weak, mut good) = (Vec::new(), Vec::new(), Vec::new());
    let gain = joint.fit.process_gain();
    let half = (confidence.process_gain[1] - confidence.process_gain[0]) / 2.0 / gain.abs();
    if confidence.process_gain[0] <= 0.0 && confidence.process_gain[1] >= 0.0 {
        refused.push(
            "the interval of the process gain holds 0: the record does not show that the input acts"
                .to_owned(),
        );
    } else if half > NOTHING {
        refused.push(format!("the process gain is known to ±{:.0} % only", 100.0 * half));
    } else if half > WEAK {
        weak.push(format!("the process gain is known to ±{:.0} %", 100.0 * half));
    } else {
        good.push(format!("the process gain is known to ±{:.2} %", 100.0 * half));
    }
    let [least, most] = confidence.dead_time;
    if open_ended(confidence, *greatest, problem) {
        weak.push(format!("the dead time may be {most:.4} s, the longest that was looked for, or more"));
    } else if most - least > (joint.fit.dead_time + 2.0 * step).max(4.0 * step) {
        weak.push(format!("the dead time is only known to lie between {least:.4} s and {most:.4} s"));
    } else {
        good.push(format!("the dead time lies between {least:.4} s and {most:.4} s"));
    }
    if answer.excitation.closed_loop {
        match outside {
            Some(outside) => {
                let text = format!(
                    "what came from outside ({}) alone tells the process gain to a standard deviation of {:.0} %",
                    answer.excitation.text(),
                    100.0 * outside.relative_deviation.min(9.99)
                );
                match outside.relative_deviation {
                    known if known > NOTHING_OUTSIDE => {
                        refused.push(text + ": the rest would be the controller or an assumption on the noise");
                    }
                    known if known > WEAK_OUTSIDE => weak.push(text),
                    _ => good.push(text),
                }
                if outside.disagreement > 4.0 {
                    weak.push(format!(
                        "the setpoint moves alone give another process gain, {:.1} standard deviations away: the loop is not \
                         linear, or another load came at the same time",
                        outside.disagreement
                    ));
                }
            }
            None => weak.push(
                "the record is in automatic, but no P, PI or PID law explains the manipulated variable: how much comes from \
                 outside is not known"
                    .to_owned(),
            ),
        }
    }
    if let Some(text) = rounded {
        let most = inflation.gain.bias.max(inflation.dead_time.bias);
        if most > 1.0 {
            weak.push(format!("{text}: that, not the noise, sets the width of the intervals"));
        } else {
            good.push(format!("{text}: the intervals allow for it"));
        }
    }
    if joint.fit.kind == Kind::FirstOrder {
        good.push(format!(
            "the process is self-regulating over this record (lag {:.4} s): an integrator describes only its first part",
            joint.fit.lag
        ));
    }
    match (refused.is_empty(), weak.is_empty()) {
        (false, _) => (Verdict::Refused, refused),
        (true, false) => (Verdict::Weak, weak.into_iter().chain(good).collect()),
        (true, true) => (Verdict::Identified, good),
    }
}

fn quality(found: &Found<'_>, whitened: &Whitened<'_, '_>) -> FitQuality {
    let Found { problem, joint, .. } = found;
    let fit = &joint.fit;
    // The part of initial state and load by the whitened fit, put back on the rows themselves.
    let own = problem.own_columns(fit.kind, fit.lag);
    let column = problem.column(fit.kind.shape(fit.lag), fit.dead_time);
    let rest: Vec<f64> = problem.response.iter().zip(&column).map(|(y, v)| y - fit.gain * v).collect();
    let smooth = super::identify::generalised(whitened.whitener, &own, &rest);
    let model: Vec<f64> = smooth.iter().zip(&column).map(|(own, v)| own + fit.gain * v).collect();
    let residual = problem.response.iter().zip(&model).map(|(y, m)| y - m).collect();
    FitQuality {
        rows: problem.len(),
        block_rows: found.block,
        prediction_error: (fit.squares / joint.freedom).sqrt() * whitened.whitener.innovation(),
        noise: joint.noise,
        time: problem.times.clone(),
        model,
        residual,
    }
}
