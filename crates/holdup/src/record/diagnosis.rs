//! What is wrong with the loop as it runs: tuning, valve, or a cycle from outside.

use serde::Serialize;

use super::controller::RunningController;
use super::wording::three;
use super::{Oscillation, Shape, Survey};
use crate::analysis::frequency::dominant_poles;
use crate::model::{ClosedLoop, Controller, Process, Seconds};

/// Damping below which a loop swings visibly.
const SWINGS: f64 = 0.6;

/// Damping below which a loop keeps swinging for many periods.
const RINGS: f64 = 0.15;

/// The diagnosis of a loop.
#[derive(Debug, Clone, PartialEq, Serialize, Default)]
pub struct Diagnosis {
    /// Damping ratio of the slowest pair of closed-loop poles; absent without process or controller, or without a pair.
    pub damping: Option<f64>,
    /// Period of that pair [s].
    #[serde(rename = "period_s")]
    pub period: Option<f64>,
    /// Whether the loop of the identified process and the recovered controller is stable.
    pub stable: Option<bool>,
    /// Period of the oscillation in the record [s], where there is one.
    #[serde(rename = "oscillation_period_s")]
    pub oscillation_period: Option<f64>,
    /// What is found, in sentences.
    pub findings: Vec<String>,
}

/// The controller of the library with the recovered settings.
pub(crate) fn controller(of: &RunningController) -> Option<Controller> {
    let mut controller = Controller::proportional(of.proportional_gain.value).ok()?;
    if let Some(time) = of.integral_time {
        controller = controller.with_integral_time(Seconds(time.value)).ok()?;
    }
    if let Some(time) = of.derivative_time {
        controller = controller.with_derivative_time(Seconds(time.value)).ok()?;
    }
    Some(controller)
}

/// The diagnosis of the recovered controller on the process, where there is one; `survey` is of what the setpoint does not
/// explain, where that is known, and `valve` is what is wrong with the valve.
pub(crate) fn diagnose(
    process: Option<&Process>,
    running: Option<&RunningController>,
    survey: &Survey,
    closed_loop: bool,
    valve: Option<String>,
) -> Diagnosis {
    let mut diagnosis = Diagnosis::default();
    let seen = survey.controlled_variable.oscillation.filter(|seen| closed_loop && seen.strength > 0.4);
    diagnosis.oscillation_period = seen.map(|seen| seen.period_s);
    if let (Some(process), Some(running)) = (process, running) {
        poles(&mut diagnosis, process, running);
    }
    if let Some(valve) = valve {
        diagnosis.findings.insert(0, valve);
    } else if let Some(seen) = seen {
        cycle(&mut diagnosis, &seen, running, survey);
    }
    diagnosis
}

/// Damping and period from the exact poles, and the two ways in which an integral time is too short.
fn poles(diagnosis: &mut Diagnosis, process: &Process, running: &RunningController) {
    let Some(controller) = controller(running) else { return };
    let Ok(poles) = dominant_poles(&ClosedLoop::new(process, &controller)) else { return };
    diagnosis.stable = poles.first().map(|pole| pole.re < 0.0);
    if let Some(pole) = poles.iter().find(|pole| pole.im > 0.0) {
        diagnosis.damping = Some(-pole.re / pole.re.hypot(pole.im));
        diagnosis.period = Some(std::f64::consts::TAU / pole.im);
    }
    let (gain, dead_time) = (process.process_gain() * running.proportional_gain.value, process.dead_time());
    let Some(integral) = running.integral_time.map(|time| time.value) else {
        if gain < 0.0 {
            diagnosis.findings.push("the controller acts in the wrong direction for this process".to_owned());
        }
        return;
    };
    if integral <= dead_time {
        diagnosis.findings.push(format!(
            "the integral time of {} s is not above the dead time of {} s: unstable at every gain",
            three(integral),
            three(dead_time)
        ));
    } else if let Some(damping) = diagnosis.damping.filter(|damping| *damping < SWINGS) {
        let rule = 0.5 * (gain * integral).max(0.0).sqrt();
        // Where the rule of thumb for small K·Kc·d tells the damping, the integral time is what is wrong.
        if gain * dead_time < 0.6 && (damping - rule).abs() < 0.3 * rule.max(0.1) {
            diagnosis.findings.push(format!(
                "reset too fast: the integral time of {} s is too short for the gain, so that the loop swings \
                 slowly (damping {damping:.2}, period {} s); damping is about ½√(K·Kc·Ti) = {rule:.2}, so lowering the \
                 gain makes it worse: an integral time of 4/(K·Kc) = {} s ends it",
                three(integral),
                three(diagnosis.period.unwrap_or_default()),
                three(4.0 / gain)
            ));
        } else {
            diagnosis.findings.push(format!(
                "the gain is too high for the dead time: damping {damping:.2}, period {} s",
                three(diagnosis.period.unwrap_or_default())
            ));
        }
    }
}

/// Where a steady cycle comes from. The shape test is that of Q. P. He, J. Wang, M. Pottmann and S. J. Qin, Ind. Eng. Chem.
/// Res. 46 (2007) 4549: a valve that sticks jumps, an integrating process makes triangles of a square wave, while a loop that
/// is near its limit, or swings along with another, is round.
fn cycle(
    diagnosis: &mut Diagnosis,
    seen: &Oscillation,
    running: Option<&RunningController>,
    survey: &Survey,
) {
    let (period, said) = (seen.period_s, three(seen.period_s));
    let output = survey.manipulated_variable.oscillation;
    let own_period = diagnosis.period.filter(|own| (own / period - 1.0).abs() < 0.3);
    let text = if seen.shape == Shape::Triangular
        || output.is_some_and(|output| output.shape == Shape::Square)
    {
        format!(
            "a steady cycle of {said} s with straight flanks, as an integrating process makes them of a valve that \
             sticks and jumps: check the valve (stroke it in manual by small steps) before tuning"
        )
    } else if let (Some(own), true) = (own_period, diagnosis.damping.is_some_and(|damping| damping < RINGS)) {
        format!("a steady round cycle of {said} s at the loop's own period of {} s: tuning", three(own))
    } else if diagnosis.stable == Some(true) {
        format!(
            "a steady round cycle of {said} s that is not the loop's own: it comes from outside; look for another loop \
             with that period"
        )
    } else {
        let angle = running.and_then(|running| {
            let integral = running.integral_time?.value;
            Some((-1.0 / (std::f64::consts::TAU / period * integral)).atan().to_degrees())
        });
        let phase = angle
            .map_or_else(String::new, |angle| format!("; the recovered controller turns it by {angle:.0}°"));
        format!(
            "a steady round cycle of {said} s{phase}: no sign of a sticking valve, but whether it is the loop's own or \
             comes from outside this record does not say; put the loop in manual for two periods: a cycle that stays comes \
             from outside"
        )
    };
    diagnosis.findings.push(text);
}
