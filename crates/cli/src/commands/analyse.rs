//! `holdup analyse`: stability and exact margins.

use std::fmt::Write as _;

use holdup::analysis::frequency::{Margins, dominant_poles, loop_without_observer, margins, observer_loop};
use holdup::model::{ClosedLoop, Controller, Process};
use serde_json::{Value, json};

use super::analyse_actuator;
use super::analyse_sampled::Sampled;
use super::view::{controller_line, margins_table, process_line};
use crate::args::AnalyseArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::input::closed_loop;
use crate::table::number;

/// Analyses the loop; one with an observer also in its parts.
pub(crate) fn run(args: &AnalyseArgs, console: Console) -> Result<Answer, Fault> {
    let (process, controller) = closed_loop(&args.of)?;
    let reach = analyse_actuator::of(&args.actuator, &process, &controller)?;
    let sampled = Sampled::of(args, &process, &controller)?;
    let closed = ClosedLoop::new(&process, &controller);
    let whole = margins(&closed).map_err(Fault::input)?;
    let parts = Parts::of(&process, &controller)?;
    let poles = dominant_poles(&closed).map_err(Fault::input)?;
    let mut warnings = whole.warnings.clone();
    let noise_gain = controller.noise_gain();
    if noise_gain.is_none() {
        warnings.push("The noise gain is infinite: the derivative action is not filtered.".to_owned());
    }
    warnings.extend(reach.iter().flat_map(|reach| reach.sentences.clone()));
    warnings.extend(sampled.warnings());
    let mut json = json!({
        "stable": whole.stable,
        "margins": &whole,
        "dominant_poles": poles.iter().map(|pole| pole_json(pole.re, pole.im)).collect::<Vec<_>>(),
        "noise_gain": noise_gain,
        "loops": parts.as_ref().map_or(Value::Null, Parts::json),
        "warnings": warnings,
    });
    if let Some(reach) = &reach {
        json["actuator"] = json!(reach);
        // Why a best is absent is said in the JSON; on standard error only what concerns the design.
        let reasons = reach.setpoint.best.reasons.iter().chain(&reach.load.best.reasons);
        json["warnings"] = json!(warnings.iter().chain(reasons).collect::<Vec<_>>());
    }
    sampled.add_to(&mut json);
    let mut text = String::new();
    if !console.json {
        let verdict = if whole.stable { "Stable" } else { "Unstable" };
        text =
            format!("{verdict}: {}\n        on {}\n\n", controller_line(&controller), process_line(&process));
        let mut columns: Vec<(&str, &Margins)> = parts.iter().flat_map(Parts::columns).collect();
        columns.push((if columns.is_empty() { "loop" } else { "whole loop" }, &whole));
        columns.extend(sampled.column());
        text += &margins_table(console, &columns);
        let poles: Vec<String> =
            poles.iter().filter(|pole| pole.im >= 0.0).map(|pole| root(pole.re, pole.im)).collect();
        let _ = writeln!(
            text,
            " dominant poles [1/s]  {}",
            if poles.is_empty() { "–".to_owned() } else { poles.join(", ") }
        );
        let _ =
            writeln!(text, " noise gain            {}", noise_gain.map_or_else(|| "∞".to_owned(), number));
        text += &reach.map_or_else(String::new, |reach| analyse_actuator::section(console, &reach));
        text += &sampled.lines();
    }
    Ok(Answer { json, text, warnings, ..Answer::default() })
}

/// Damping ratio of a pole [–]: 1 on the negative real axis, 0 on the imaginary axis, negative to the right of it.
fn damping_ratio(re: f64, im: f64) -> Option<f64> {
    Some(-re / re.hypot(im)).filter(|ratio| ratio.is_finite())
}

fn pole_json(re: f64, im: f64) -> Value {
    json!({"re": re, "im": im, "damping_ratio": damping_ratio(re, im)})
}

/// A pole for reading, a pair with its damping ratio.
fn root(re: f64, im: f64) -> String {
    match im {
        0.0 => number(re),
        _ => format!("{} ± {}j (damping {})", number(re), number(im.abs()), number(damping_ratio(re, im))),
    }
}

/// The loops that a loop with an observer is made of.
struct Parts {
    /// The loop without its observer.
    controller: Margins,
    /// The observer's own loop on its model: with a perfect model the sensitivity of the whole is the product of
    /// the two.
    observer: Margins,
}

impl Parts {
    fn of(process: &Process, controller: &Controller) -> Result<Option<Self>, Fault> {
        let of = |part: &ClosedLoop| margins(part).map_err(Fault::input);
        let Some(observer) = observer_loop(process, controller).map_err(Fault::input)? else {
            return Ok(None);
        };
        let controller = of(&loop_without_observer(process, controller))?;
        Ok(Some(Self { controller, observer: of(&observer)? }))
    }

    fn columns(&self) -> Vec<(&'static str, &Margins)> {
        vec![("without observer", &self.controller), ("observer loop", &self.observer)]
    }

    fn json(&self) -> Value {
        json!({"without_observer": &self.controller, "observer": &self.observer})
    }
}
