//! Identified, weak or refused, and why.

use super::found::Found;
use crate::record::Survey;
use crate::record::confidence::{Confidence, Inflations, open_ended};
use crate::record::controller::RunningController;
use crate::record::excitation::Outside;
use crate::record::identification::{Identification, Verdict};
use crate::record::identify::Kind;
use crate::record::wording::{ends, three};

/// Relative half width of the gain's interval above which the verdict is weak, and above which there is none.
const WEAK: f64 = 0.35;
const NOTHING: f64 = 0.8;

/// Relative standard deviation of the gain by movement from outside alone, above which the same holds.
const WEAK_OUTSIDE: f64 = 0.2;
const NOTHING_OUTSIDE: f64 = 0.5;

/// Why constant setpoint and automatic identify nothing.
pub(super) fn nothing_from_outside(controller: Option<&RunningController>, survey: &Survey) -> String {
    let mut text = "in automatic at a constant setpoint the manipulated variable only answers the controlled one: no setpoint \
                    move, no hand, no limit tells the process apart from its controller, and what a fit returns would follow \
                    from what is assumed of the noise"
        .to_owned();
    if let (Some(seen), Some(controller)) = (survey.controlled_variable.oscillation, controller) {
        let frequency = std::f64::consts::TAU / seen.period_s;
        let lag = controller.integral_time.map_or(0.0, |time| 1.0 / (frequency * time.value));
        let size = controller.proportional_gain.value.abs() * lag.hypot(1.0);
        text += &format!(
            "; of the cycle of {} s the fit is perfect and returns the controller: K = ω/|C(jω)| = {} /s, ω·d = π/2 + \
             arg C(jω), d = {} s",
            three(seen.period_s),
            three(frequency / size),
            three((std::f64::consts::FRAC_PI_2 - lag.atan()) / frequency)
        );
    }
    text
}

/// The verdict with its reasons.
pub(super) fn verdict(
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
        good.push(format!("the process gain is known to ±{} %", three(100.0 * half)));
    }
    let [least, most] = confidence.dead_time;
    let [from, to] = ends(confidence.dead_time);
    if open_ended(confidence, *greatest, problem) {
        weak.push(format!("the dead time may be {to} s, the longest that was looked for, or more"));
    } else if most - least > (joint.fit.dead_time + 2.0 * step).max(4.0 * step) {
        weak.push(format!("the dead time is only known to lie between {from} s and {to} s"));
    } else {
        good.push(format!("the dead time lies between {from} s and {to} s"));
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
            "the process is self-regulating over this record (lag {} s): an integrator describes only its first part",
            three(joint.fit.lag)
        ));
    }
    match (refused.is_empty(), weak.is_empty()) {
        (false, _) => (Verdict::Refused, refused),
        (true, false) => (Verdict::Weak, weak.into_iter().chain(good).collect()),
        (true, true) => (Verdict::Identified, good),
    }
}
