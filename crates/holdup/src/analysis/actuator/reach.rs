//! What a design asks of the actuator, and whether the actuator can give it.

use serde::Serialize;

use super::Actuator;
use super::best::{Best, best_after_load_step, best_after_setpoint_step};
use crate::analysis::frequency::{FrequencyError, margins};
use crate::analysis::response::{Extreme, OutputExtent, ResponseError, Scenario, output_extent};
use crate::model::{ClosedLoop, Controller, OutputFilter, Process, Seconds};

/// Dead times over which the response is followed: what comes later is nearer to the final value, which counts too.
const DEAD_TIMES: f64 = 200.0;

/// What one step asks of the actuator, by the linear loop.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Asked {
    /// Size of the step [output unit for a setpoint, input unit for a load].
    pub step: f64,
    /// The output asked for at once at the step [input unit], the output at rest included; absent for an impulse.
    pub kick: Option<f64>,
    /// Least output asked for [input unit], the output at rest included.
    pub least: Option<f64>,
    /// When it is asked for [s] from the step on; absent where it is the final value.
    pub least_at_s: Option<f64>,
    /// Greatest output asked for [input unit], the output at rest included.
    pub greatest: Option<f64>,
    /// When it is asked for [s] from the step on; absent where it is the final value.
    pub greatest_at_s: Option<f64>,
    /// Whether all of it is within the limits, so that the linear response is the real one.
    pub in_reach: bool,
    /// The least and the greatest step of which that is so.
    pub steps_in_reach: Option<(f64, f64)>,
    /// The best possible answer to this step within the limits.
    pub best: Best,
}

/// What the actuator allows and what the design asks of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reach {
    /// Lower and upper limit [input unit].
    pub limits: (f64, f64),
    /// Output at rest [input unit].
    pub output_at_rest: f64,
    /// The least and the greatest load step that can be held [input unit].
    pub loads_held: (f64, f64),
    /// The setpoint step.
    pub setpoint: Asked,
    /// The load step.
    pub load: Asked,
    /// What the reader must know, one sentence each: what cannot be held, and where the linear answer is out of reach.
    #[serde(skip)]
    pub sentences: Vec<String>,
}

/// Why the reach could not be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ReachError {
    /// The margins could not.
    #[error(transparent)]
    Frequency(#[from] FrequencyError),
    /// The response could not.
    #[error(transparent)]
    Response(#[from] ResponseError),
}

/// What a setpoint step [output unit] and a load step [input unit] ask of the actuator, and the best that the actuator
/// allows.
///
/// The linear loop is followed over 200 dead times, extrema exactly; its final value counts as well. Of an unstable
/// loop nothing is said but what can be held.
///
/// ```
/// use holdup::analysis::actuator::{Actuator, reach};
/// use holdup::model::{Process, Seconds, notation::read_controller};
/// let level = Process::integrating(0.0506, Seconds(6.0))?;
/// let pid = read_controller("Kc=2.95,Ti=15,Td=3,N=100")?;
/// let asked = reach(&level, &pid, &Actuator::new(0.0, 100.0, 50.0)?, 1.0, 1.0)?;
/// // Kc·(1 + Td·N) is 887.95 a unit of the setpoint.
/// assert!((asked.setpoint.kick.unwrap() - 937.95).abs() < 1e-9);
/// assert!(!asked.setpoint.in_reach && asked.load.in_reach);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ReachError`] if the loop is out of the reach of double precision, or does not settle within the budget of cells.
pub fn reach(
    process: &Process,
    controller: &Controller,
    actuator: &Actuator,
    setpoint_step: f64,
    load_step: f64,
) -> Result<Reach, ReachError> {
    let closed = ClosedLoop::new(process, controller);
    let stable = margins(&closed)?.stable;
    let horizon = Seconds(DEAD_TIMES * process.dead_time());
    let unit = |scenario: Result<Scenario, _>| -> Result<Option<OutputExtent>, ReachError> {
        match scenario {
            Ok(scenario) if stable => Ok(output_extent(&closed, &scenario)?),
            _ => Ok(None),
        }
    };
    let setpoint =
        Unit { extent: unit(Scenario::unit_setpoint_step(horizon))?, kick: kick(controller), last: 0.0 };
    let load = Unit { extent: unit(Scenario::unit_load_step(horizon))?, kick: Some(0.0), last: -1.0 };
    let mut reach = Reach {
        limits: (actuator.low(), actuator.high()),
        output_at_rest: actuator.rest(),
        loads_held: actuator.loads_held(),
        setpoint: setpoint.asked(
            actuator,
            setpoint_step,
            best_after_setpoint_step(process, actuator, setpoint_step),
        ),
        load: load.asked(actuator, load_step, best_after_load_step(process, actuator, load_step)),
        sentences: Vec::new(),
    };
    reach.sentences = sentences(&reach, actuator, stable);
    Ok(reach)
}

/// The output that a unit setpoint step asks for at once [input unit / output unit], `Kc·(b + c·Td/Tf)`; `None` where
/// it is an impulse (the derivative unfiltered). An output filter lets nothing through at once.
#[must_use]
pub fn kick(controller: &Controller) -> Option<f64> {
    if let Some(compensator) = controller.compensator() {
        return Some(compensator.main_gain());
    }
    let (b, c) = (controller.setpoint_weight(), controller.derivative_setpoint_weight());
    let derivative = controller.derivative_time().filter(|_| c != 0.0);
    match (derivative, controller.derivative_filter(), controller.output_filter()) {
        (None, _, None) => Some(controller.proportional_gain() * b),
        (Some(td), Some(filter), None) => {
            Some(controller.proportional_gain() * (b + c * td * filter.bandwidth()))
        }
        (Some(_), None, None) => None,
        // A first-order output filter turns the impulse into a jump; all else it smooths.
        (Some(td), None, Some(OutputFilter { a1, a2: 0.0 })) => {
            Some(controller.proportional_gain() * c * td / a1)
        }
        (_, _, Some(_)) => Some(0.0),
    }
}

/// The answer to a unit step, from 0 at rest.
struct Unit {
    /// Range over the horizon; absent of an unstable loop.
    extent: Option<OutputExtent>,
    /// Output at once; absent for an impulse.
    kick: Option<f64>,
    /// Output in the end.
    last: f64,
}

impl Unit {
    fn asked(&self, actuator: &Actuator, step: f64, best: Best) -> Asked {
        let rest = actuator.rest();
        let kick = self.kick.map(|kick| rest + kick * step);
        let nothing = Asked {
            step,
            kick,
            least: None,
            least_at_s: None,
            greatest: None,
            greatest_at_s: None,
            in_reach: false,
            steps_in_reach: None,
            best,
        };
        let Some(extent) = self.extent else { return nothing };
        if extent.impulsive {
            return Asked { in_reach: step == 0.0, steps_in_reach: Some((0.0, 0.0)), kick: None, ..nothing };
        }
        let or_last = |beyond: bool, extreme: Extreme| {
            if beyond { (self.last, None) } else { (extreme.value, Some(extreme.time)) }
        };
        let (least, least_at) = or_last(self.last < extent.least.value, extent.least);
        let (greatest, greatest_at) = or_last(self.last > extent.greatest.value, extent.greatest);
        // The greatest step whose answer, from `least` to `greatest` a unit, stays within these distances.
        let greatest_step = |below: f64, above: f64| {
            let up = if greatest > 0.0 { above / greatest } else { f64::INFINITY };
            let down = if least < 0.0 { below / -least } else { f64::INFINITY };
            up.min(down)
        };
        let (below, above) = (actuator.below(), actuator.above());
        let steps = (-greatest_step(above, below), greatest_step(below, above));
        let scaled =
            [(least, least_at), (greatest, greatest_at)].map(|(value, at)| (rest + step * value, at));
        let [low, high] = if step < 0.0 { [scaled[1], scaled[0]] } else { scaled };
        Asked {
            least: Some(low.0),
            least_at_s: low.1,
            greatest: Some(high.0),
            greatest_at_s: high.1,
            in_reach: low.0 >= actuator.low() && high.0 <= actuator.high(),
            steps_in_reach: (steps.0.is_finite() && steps.1.is_finite()).then_some(steps),
            ..nothing
        }
    }
}

fn sentences(reach: &Reach, actuator: &Actuator, stable: bool) -> Vec<String> {
    let mut sentences = Vec::new();
    let (least, greatest) = reach.loads_held;
    let number = |value: f64| {
        let text = format!("{value:.4}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    if !(least..=greatest).contains(&reach.load.step) {
        sentences.push(format!(
            "A load of {} cannot be held: loads from {} to {} can.",
            reach.load.step,
            number(least),
            number(greatest)
        ));
    }
    if !stable {
        sentences.push("The loop is unstable: what it asks of the actuator has no bound.".to_owned());
        return sentences;
    }
    for (name, asked) in [("setpoint step", &reach.setpoint), ("load step", &reach.load)] {
        if asked.in_reach {
            continue;
        }
        let limits = format!("the limits are {} to {}", actuator.low(), actuator.high());
        let out = "the linear response is out of the actuator's reach";
        let (Some(low), Some(high)) = (asked.least, asked.greatest) else {
            sentences.push(format!(
                "After a {name} of {} the controller asks for an impulse, and {limits}: {out}.",
                asked.step
            ));
            continue;
        };
        let above = high > actuator.high();
        let (value, at) = if above { (high, asked.greatest_at_s) } else { (low, asked.least_at_s) };
        let when = at.map_or_else(|| "in the end".to_owned(), |time| format!("at {} s", number(time)));
        let within = asked.steps_in_reach.map_or_else(String::new, |(from, to)| {
            format!(" Steps from {} to {} are within it.", number(from), number(to))
        });
        sentences.push(format!(
            "After a {name} of {} the controller asks for {} {when}, and {limits}: {out}.{within}",
            asked.step,
            number(value)
        ));
    }
    sentences
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::notation::{read_controller, read_process};

    fn asked(controller: &str, actuator: (f64, f64, f64), setpoint: f64, load: f64) -> Reach {
        let process = read_process("K=0.0506,d=6").unwrap();
        let actuator = Actuator::new(actuator.0, actuator.1, actuator.2).unwrap();
        reach(&process, &read_controller(controller).unwrap(), &actuator, setpoint, load).unwrap()
    }

    #[test]
    fn the_kick_is_what_the_exact_response_starts_with() {
        for (controller, kick) in [
            ("Kc=2.95,Ti=15", 2.95),
            ("Kc=2.95,Ti=15,b=0.4", 2.95 * 0.4),
            ("Kc=2.95,Ti=15,Td=3,N=100", 2.95 * 301.0),
            ("Kc=2.95,Ti=15,Td=3,N=100,c=0", 2.95),
            ("Kc=1.5321,Td=1.0343,N=100,Ko=0.5", 1.5321 * 104.43),
            ("Kc=2.95,Ti=15,Td=3,a1=0.5", 2.95 * 6.0),
            ("Kc=2.95,Ti=15,Td=3,N=100,a1=0.5", 0.0),
        ] {
            let process = read_process("K=0.0506,d=6").unwrap();
            let design = read_controller(controller).unwrap();
            assert!((super::kick(&design).unwrap() - kick).abs() < 1e-12 * (1.0 + kick), "{controller}");
            let closed = ClosedLoop::new(&process, &design);
            let step = Scenario::unit_setpoint_step(Seconds(60.0)).unwrap();
            let start = crate::analysis::response::trajectory(&closed, &step, &[0.0])
                .unwrap()
                .manipulated_variable[0];
            assert!((start - kick).abs() < 1e-9 * (1.0 + kick), "{controller}: {start}");
        }
    }

    #[test]
    fn steps_within_reach_are_those_whose_linear_answer_touches_no_limit() {
        for (setpoint, load) in [(1.0, 1.0), (-1.0, -1.0)] {
            let reach = asked("Kc=2.95,Ti=15,Td=3,N=1", (0.0, 100.0, 30.0), setpoint, load);
            for (asked_for, name) in [(&reach.setpoint, "setpoint"), (&reach.load, "load")] {
                let (from, to) = asked_for.steps_in_reach.unwrap();
                for (edge, inside) in
                    [(from * 0.999, true), (to * 0.999, true), (from * 1.001, false), (to * 1.001, false)]
                {
                    let again = asked("Kc=2.95,Ti=15,Td=3,N=1", (0.0, 100.0, 30.0), edge, edge);
                    let again = if name == "setpoint" { again.setpoint } else { again.load };
                    assert_eq!(again.in_reach, inside, "{name} {edge}");
                }
            }
        }
    }

    #[test]
    fn a_load_at_the_end_takes_the_whole_output_and_one_beyond_is_said() {
        let reach = asked("Kc=1.647,Ti=48", (0.0, 100.0, 40.0), 1.0, 45.0);
        assert!(
            reach
                .sentences
                .iter()
                .any(|s| s.contains("A load of 45 cannot be held: loads from -60 to 40 can"))
        );
        assert!(reach.load.best.iae.is_none() && !reach.load.in_reach);
        // SIMC's output after a load overshoots the load: 40 can be held, but not by the linear response.
        let edge = asked("Kc=1.647,Ti=48", (0.0, 100.0, 40.0), 1.0, 40.0);
        assert!(edge.load.least.unwrap() < 0.0 && !edge.load.in_reach);
        // Without overshoot the final value is the extreme: proportional control of a quiet loop.
        let quiet = asked("Kc=0.5", (0.0, 100.0, 40.0), 1.0, 39.0);
        assert!(quiet.load.in_reach && quiet.load.least == Some(1.0) && quiet.load.least_at_s.is_none());
    }

    #[test]
    fn impulses_and_unstable_loops_are_out_of_reach() {
        let impulse = asked("Kc=1.5321,Td=1.0343", (0.0, 100.0, 40.0), 1.0, 1.0);
        assert!(impulse.setpoint.kick.is_none() && !impulse.setpoint.in_reach && impulse.load.in_reach);
        assert!(impulse.sentences[0].contains("impulse"));
        let unstable = asked("Kc=60", (0.0, 100.0, 40.0), 1.0, 1.0);
        assert!(unstable.setpoint.greatest.is_none() && unstable.sentences[0].contains("unstable"));
    }
}
