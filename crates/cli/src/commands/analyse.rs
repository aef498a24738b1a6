//! `holdup analyse`: stability and exact margins.

use holdup::analysis::frequency::{Margins, margins};
use holdup::model::{ClosedLoop, Controller, Process};
use serde_json::{Value, json};

use super::view::{controller_line, margins_table, process_line};
use crate::args::LoopArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::input::closed_loop;
use crate::table::number;

/// Analyses the loop; one with an observer also in its parts.
pub(crate) fn run(args: &LoopArgs, console: Console) -> Result<Answer, Fault> {
    let (process, controller) = closed_loop(args)?;
    let closed = ClosedLoop::new(&process, &controller);
    let whole = margins(&closed).map_err(Fault::input)?;
    let parts = Parts::of(&process, &controller)?;
    let poles: Vec<Pole> = Vec::new();
    let mut warnings = whole.warnings.clone();
    let noise_gain = controller.noise_gain();
    if noise_gain.is_none() {
        warnings.push("The noise gain is infinite: the derivative action is not filtered.".to_owned());
    }
    let json = json!({
        "stable": whole.stable,
        "margins": &whole,
        "dominant_poles": poles.iter().map(|pole| json!({"re": pole.re, "im": pole.im})).collect::<Vec<_>>(),
        "noise_gain": noise_gain,
        "loops": parts.as_ref().map_or(Value::Null, Parts::json),
        "warnings": warnings,
    });
    let mut text = String::new();
    if !console.json {
        let verdict = if whole.stable { "Stable" } else { "Unstable" };
        text =
            format!("{verdict}: {}\n        on {}\n\n", controller_line(&controller), process_line(&process));
        let mut columns: Vec<(&str, &Margins)> = parts.iter().flat_map(Parts::columns).collect();
        columns.push((if columns.is_empty() { "loop" } else { "whole loop" }, &whole));
        text += &margins_table(console, &columns);
        let poles: Vec<String> = poles.iter().map(|pole| root(pole.re, pole.im)).collect();
        text += &format!(
            " dominant poles [1/s]  {}\n",
            if poles.is_empty() { "–".to_owned() } else { poles.join(", ") }
        );
        text += &format!(" noise gain            {}\n", noise_gain.map_or_else(|| "∞".to_owned(), number));
    }
    Ok(Answer { json, text, warnings, ..Answer::default() })
}

/// A pole for reading.
fn root(re: f64, im: f64) -> String {
    if im == 0.0 { number(re) } else { format!("{} ± {}j", number(re), number(im.abs())) }
}

/// The loops that a loop with an observer is made of.
struct Parts {
    /// The loop without its observer.
    controller: Margins,
    /// The loop of the observer alone: only with a perfect model does the whole factorise into the two.
    observer: Option<Margins>,
}

impl Parts {
    fn of(process: &Process, controller: &Controller) -> Result<Option<Self>, Fault> {
        let Some(observer) = controller.observer() else { return Ok(None) };
        let of = |part: &Controller| margins(&ClosedLoop::new(process, part)).map_err(Fault::input);
        let perfect = observer.model_gain().is_none_or(|gain| gain == process.process_gain())
            && observer.model_dead_time().is_none_or(|dead_time| dead_time == process.dead_time());
        let alone = Controller::proportional(observer.gain()).map_err(Fault::input)?;
        Ok(Some(Self {
            controller: of(&controller.without_observer())?,
            observer: if perfect { Some(of(&alone)?) } else { None },
        }))
    }

    fn columns(&self) -> Vec<(&'static str, &Margins)> {
        let controller = std::iter::once(("without observer", &self.controller));
        controller.chain(self.observer.iter().map(|margins| ("observer loop", margins))).collect()
    }

    fn json(&self) -> Value {
        json!({"without_observer": &self.controller, "observer": &self.observer})
    }
}

/// MERGE: replaced by the poles of analysis/frequency.
struct Pole {
    re: f64,
    im: f64,
}
