//! Rules of one's own, from a file: formulas in K, d and T, and controllers as a study has them.
//!
//! ```toml
//! [[rule]]
//! name = "ours"
//! Kc = "0.45/(K*d)"
//! Ti = "7*d"
//!
//! [[controller]]
//! name = "in the DCS today"
//! proportional_gain = 2.0
//! integral_time_s = 30.0
//! ```
//!
//! A rule has `name`, `about` and the settings Kc, Ti, Td, Tf (or N), b, c and Ko of the ideal form, each a number or a
//! [formula](crate::tuning::evaluate). A controller has the keys of the [study file](super::read_study); a whole study may be
//! given, whose controllers are taken and whose process, scenarios and families are not.

use super::Choice;
use super::file::{controller, named};
use crate::model::text::{Problem, TextError};
use crate::model::toml_section::{Document, Section};
use crate::model::{Controller, ModelError, Observer, Process, Seconds};
use crate::tuning::{Parameters, evaluate, rule};

/// The settings of a rule.
const SETTINGS: [&str; 8] = ["Kc", "Ti", "Td", "Tf", "N", "b", "c", "Ko"];

/// A controller with the name of the rule that gives it.
#[derive(Debug, Clone, PartialEq)]
pub struct OwnRule {
    /// The name in the file.
    pub name: String,
    /// What the rule gives for the process.
    pub controller: Controller,
}

/// Reads rules of one's own and what they give for a process.
///
/// ```
/// use holdup::model::{Process, Seconds};
/// let process = Process::integrating(0.05, Seconds(10.0))?;
/// let text = "[[rule]]\nname = \"ours\"\nKc = \"0.45/(K*d)\"\nTi = \"7*d\"\n";
/// let rules = holdup::study::read_rules(text, &process)?;
/// assert!((rules[0].controller.proportional_gain() - 0.9).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`TextError`] with line, key, value and what is allowed.
pub fn read_rules(text: &str, process: &Process) -> Result<Vec<OwnRule>, TextError> {
    let document = Document::parse(text)?;
    let root = document.root();
    root.only(&[
        "rule",
        "controller",
        "title",
        "about",
        "recomputes",
        "process",
        "sampled",
        "scenario",
        "family",
    ])?;
    let mut rules = Vec::new();
    for section in root.sections("rule")? {
        rules.push(OwnRule { name: named(&section)?, controller: by_formulas(&section, process)? });
    }
    for section in root.sections("controller")? {
        rules.push(OwnRule { name: named(&section)?, controller: of_study(&section, process)? });
    }
    if rules.is_empty() {
        return Err(root.missing("rule", "at least one table headed [[rule]] or [[controller]]"));
    }
    Ok(rules)
}

fn by_formulas(section: &Section<'_>, process: &Process) -> Result<Controller, TextError> {
    section.only(&[&["name", "about"][..], &SETTINGS].concat())?;
    let value = |key: &'static str| setting(section, key, process);
    let refused = |key: &'static str| move |error: ModelError| section.model_error(&error, |_| key);
    let Some(gain) = value("Kc")? else {
        return Err(section.missing("Kc", "a number or a formula such as \"0.45/(K*d)\""));
    };
    let mut controller = Controller::proportional(gain).map_err(refused("Kc"))?;
    if let Some(time) = value("Ti")? {
        controller = controller.with_integral_time(Seconds(time)).map_err(refused("Ti"))?;
    }
    if let Some(time) = value("Td")? {
        controller = controller.with_derivative_time(Seconds(time)).map_err(refused("Td"))?;
    }
    if let Some(bandwidth) = value("N")? {
        controller = controller.with_filter_bandwidth(bandwidth).map_err(refused("N"))?;
    }
    if let Some(time) = value("Tf")? {
        controller = controller.with_filter_time(Seconds(time)).map_err(refused("Tf"))?;
    }
    let weights = [value("b")?, value("c")?];
    if weights.iter().any(Option::is_some) {
        let [b, c] = weights.map(|weight| weight.unwrap_or(1.0));
        controller = controller.with_setpoint_weights(b, c).map_err(refused("b"))?;
    }
    if let Some(gain) = value("Ko")? {
        controller = controller.with_observer(Observer::new(gain).map_err(refused("Ko"))?);
    }
    Ok(controller)
}

/// A number, or a formula in K, d and T.
fn setting(section: &Section<'_>, key: &str, process: &Process) -> Result<Option<f64>, TextError> {
    let Ok(text) = section.text(key) else { return section.number(key) };
    let Some(formula) = text else { return Ok(None) };
    let lookup = |name: &str| match name {
        "K" => Some(process.process_gain()),
        "d" => Some(process.dead_time()),
        "T" => process.lag(),
        _ => None,
    };
    let value = evaluate(&formula, &lookup)
        .map_err(|error| section.error(key, Problem::Conflict { reason: error.to_string().into() }))?;
    if value.is_finite() {
        Ok(Some(value))
    } else {
        Err(section.refuse(key, &formula, "a formula with a finite value for this process"))
    }
}

/// A controller as a study has it.
fn of_study(section: &Section<'_>, process: &Process) -> Result<Controller, TextError> {
    let conflict = |reason: String| section.error("rule", Problem::Conflict { reason: reason.into() });
    match controller(section, process, None)?.choice {
        Choice::Settings(controller) => Ok(controller),
        Choice::Rule { id, parameters, extras } => {
            let set =
                parameters.iter().fold(Parameters::new(), |set, (name, value)| set.set(name.clone(), *value));
            let tuning = rule(&id)
                .and_then(|entry| entry.tune(process, &set))
                .map_err(|error| conflict(error.to_string()))?;
            extras.apply(tuning.controller).map_err(|error| conflict(error.to_string()))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Vec<OwnRule>, TextError> {
        read_rules(text, &Process::integrating(-0.05, Seconds(10.0)).unwrap())
    }

    #[test]
    fn formulas_and_the_controllers_of_a_study_are_read() {
        let text = r#"
            title = "a study"
            rule = [{ name = "ours", Kc = "0.3/(K*d)", Ti = "6*d", Td = "d/3", Tf = 1.5, b = 0.5, Ko = "0.1/(K*d)" }]
            controller = [
              { name = "SIMC", rule = "pi-simc", scenarios = ["not looked at"] },
              { name = "today", proportional_gain = -2.0 },
            ]
        "#;
        let rules = read(text).unwrap();
        let names: Vec<&str> = rules.iter().map(|rule| rule.name.as_str()).collect();
        assert_eq!(names, ["ours", "SIMC", "today"]);
        let ours = rules[0].controller;
        assert!((ours.proportional_gain() + 0.6).abs() < 1e-15 && ours.integral_time() == Some(60.0));
        assert!((ours.observer().unwrap().gain() + 0.2).abs() < 1e-15 && ours.setpoint_weight() == 0.5);
        assert_eq!(rules[1].controller.integral_time(), Some(80.0));
    }

    #[test]
    fn each_fault_is_named_with_its_line() {
        for (text, parts) in [
            ("[[rule]]\nname = \"a\"\nKc = \"0.4/(K*x)\"", &["3", "Kc", "x"][..]),
            ("[[rule]]\nname = \"a\"\nKc = \"0.4/(K*\"", &["3", "Kc", "expected"]),
            ("[[rule]]\nname = \"a\"\nKc = \"1/T\"", &["3", "T"]),
            ("[[rule]]\nname = \"a\"\nTi = 3", &["Kc"]),
            ("[[rule]]\nname = \"a\"\nKc = 1\nTi = -3", &["Ti", "-3"]),
            ("[[rule]]\nname = \"a\"\nKc = \"1/0\"", &["Kc", "finite"]),
            ("[[rule]]\nname = \"a\"\nkc = 1", &["kc"]),
            ("[[controller]]\nname = \"a\"\nrule = \"pi-simk\"", &["pi-simk", "pi-simc"]),
            ("title = \"nothing\"", &["[[rule]]"]),
        ] {
            let error = read(text).unwrap_err();
            let line = error.line.map_or_else(String::new, |line| line.to_string());
            let shown = format!("{line}: {error}");
            assert!(parts.iter().all(|part| shown.contains(part)), "{text}: {shown}");
        }
    }
}
