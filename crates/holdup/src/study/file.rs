//! The study file: one process, several controllers, several scenarios, as TOML.
//!
//! ```toml
//! title = "A tank level"
//! [process]
//! process_gain = 0.0506
//! dead_time_s = 6.0
//!
//! [[controller]]
//! name = "SIMC"
//! rule = "pi-simc"
//! [[controller]]
//! name = "in the DCS today"
//! proportional_gain = 2.0
//! integral_time_s = 30.0
//!
//! [[scenario]]
//! name = "servo plus regulatory"
//! setpoint = [[0.0, 1.0]]
//! load = [[100.0, 1.0]]
//! horizon_s = 300.0
//! ```
//!
//! A controller has the keys of the [loop file](crate::model::loop_file), or `rule` with `parameters`; beside
//! a rule the keys of filters, weights and observer may stand and replace what the rule gives. `scenarios`
//! restricts it to those named. `recomputes` names the published study whose printed numbers the report judges. A `[[family]]` runs one rule with one parameter varied: `name`, `rule`,
//! `parameters`, `vary`, `values`, `scenario`. `about` is free text, anywhere.
//!
//! A table `[sampled]` runs every loop sampled, too, with `holdup-control` and this equipment:
//!
//! ```toml
//! [sampled]
//! sample_period_s = 0.5        # the only key that must be there
//! limits = [0.0, 100.0]        # of the manipulated variable, in its own scale …
//! initial_manipulated = 40.0   # … in which it rests here
//! rate_limit = 5.0             # per second
//! stiction = [1.0, 0.5]        # stickband plus deadband S, slip jump J; or deadband = 1.0
//! output_quantum = 0.1
//! measurement_quantum = 0.01
//! noise = 0.02                 # standard deviation
//! seed = 1
//! jitter_s = 0.05
//! drop = 0.01                  # probability
//! computation_delay_s = 0.1
//! actual_process = { process_gain = 0.06, dead_time_s = 7.0 }
//! ```
//!
//! A scenario then may have `load_ramp = [[50.0, 150.0, 2.0]]`: start, end, change, in addition to the steps.

use std::collections::BTreeSet;

use super::published::PAPERS;
use super::sampled::{equipment_section, ramps};
use super::{Choice, Family, Study, StudyController, StudyScenario};
use crate::analysis::response::{Scenario, ScenarioError};
use crate::model::loop_file::{controller_section, extra_keys, extras_section, process_section, term_keys};
use crate::model::text::{Problem, TextError};
use crate::model::toml_section::{Document, Section};
use crate::model::{Process, Seconds};
use crate::tuning::{Parameters, RuleError, rule};

/// Reads a study.
///
/// ```
/// let text = r#"
/// title = "Two ways"
/// process = { process_gain = 0.0506, dead_time_s = 6.0 }
/// controller = [{ name = "SIMC", rule = "pi-simc" }, { name = "today", proportional_gain = 2.0 }]
/// scenario = [{ name = "step", setpoint = [[0.0, 1.0]], horizon_s = 200.0 }]
/// "#;
/// let study = holdup::study::read_study(text)?;
/// assert_eq!(study.controllers.len(), 2);
/// # Ok::<(), holdup::model::TextError>(())
/// ```
///
/// # Errors
/// [`TextError`] with line, key, value and what is allowed.
pub fn read_study(text: &str) -> Result<Study, TextError> {
    let document = Document::parse(text)?;
    let root = document.root();
    root.only(&["title", "about", "recomputes", "process", "sampled", "controller", "scenario", "family"])?;
    let process = process_section(&root.require_section("process")?)?;
    let sampled = root.section("sampled")?.map(|section| equipment_section(&section)).transpose()?;
    let read = |section: &Section<'_>| scenario(section, sampled.is_some());
    let scenarios = unique(root.sections("scenario")?, read, |scenario| &scenario.name)?;
    if scenarios.is_empty() {
        return Err(root.missing("scenario", "at least one table headed [[scenario]]"));
    }
    let names: Vec<&str> = scenarios.iter().map(|scenario| scenario.name.as_str()).collect();
    let read = |section: &Section<'_>| controller(section, &process, Some(&names));
    let controllers = unique(root.sections("controller")?, read, |controller| &controller.name)?;
    if controllers.is_empty() {
        return Err(root.missing("controller", "at least one table headed [[controller]]"));
    }
    let read = |section: &Section<'_>| family(section, &process, &names);
    let families = unique(root.sections("family")?, read, |family| &family.name)?;
    Ok(Study {
        title: root.text("title")?.unwrap_or_else(|| "Study".to_owned()),
        about: root.text("about")?,
        recomputes: recomputes(&root)?,
        process,
        sampled,
        controllers,
        scenarios,
        families,
    })
}

/// The published study that this one recomputes.
fn recomputes(root: &Section<'_>) -> Result<Option<String>, TextError> {
    let Some(paper) = root.text("recomputes")? else { return Ok(None) };
    if PAPERS.iter().any(|(known, _)| *known == paper) {
        return Ok(Some(paper));
    }
    Err(root.refuse("recomputes", &paper, "a published study that `holdup reproduce` knows"))
}

/// Reads tables of one kind, whose names differ.
fn unique<T>(
    sections: Vec<Section<'_>>,
    read: impl Fn(&Section<'_>) -> Result<T, TextError>,
    name: impl Fn(&T) -> &String,
) -> Result<Vec<T>, TextError> {
    let mut seen = BTreeSet::new();
    let mut items = Vec::with_capacity(sections.len());
    for section in sections {
        let item = read(&section)?;
        if !seen.insert(name(&item).clone()) {
            return Err(section.refuse("name", name(&item), "a name that no other table of its kind has"));
        }
        items.push(item);
    }
    Ok(items)
}

pub(super) fn named(section: &Section<'_>) -> Result<String, TextError> {
    section.text("name")?.ok_or_else(|| section.missing("name", "a text that is not empty"))
}

fn scenario(section: &Section<'_>, sampled: bool) -> Result<StudyScenario, TextError> {
    section.only(&["name", "about", "setpoint", "load", "load_ramp", "horizon_s", "initial"])?;
    if section.has("load_ramp") && !sampled {
        let reason = "needs the table [sampled]: the continuous loops know load steps only".into();
        return Err(section.error("load_ramp", Problem::Conflict { reason }));
    }
    let horizon = section.require_number("horizon_s")?;
    let (setpoint, load) = (section.pairs("setpoint")?, section.pairs("load")?);
    let load_ramps = ramps(section, horizon)?;
    let setpoint = match (setpoint, &load) {
        (None, None) if load_ramps.is_empty() => vec![(0.0, 1.0)],
        (setpoint, _) => setpoint.unwrap_or_default(),
    };
    let initial = section.number("initial")?.unwrap_or(0.0);
    // A ramp alone is an event, too: nothing else moves.
    let setpoint =
        if setpoint.is_empty() && !load_ramps.is_empty() { vec![(0.0, initial)] } else { setpoint };
    let scenario = Scenario::new(setpoint, load.unwrap_or_default(), Seconds(horizon), initial)
        .map_err(|error| scenario_error(section, &error))?;
    Ok(StudyScenario { name: named(section)?, about: section.text("about")?, scenario, load_ramps })
}

/// The refusal of a scenario, under the key of the file.
fn scenario_error(section: &Section<'_>, error: &ScenarioError) -> TextError {
    let key = |option: &'static str| if option == "horizon" { "horizon_s" } else { option };
    match *error {
        ScenarioError::OutOfRange { option, value, allowed } => {
            section.refuse(key(option), &value.to_string(), allowed)
        }
        ScenarioError::NotIncreasing { option, value, previous } => {
            let allowed = format!("later than the event before it, at {previous} s: times increase");
            section.refuse(key(option), &format!("at {value} s"), allowed)
        }
        ScenarioError::BeyondHorizon { option, value, horizon } => section.refuse(
            key(option),
            &format!("at {value} s"),
            format!("before the horizon of {horizon} s"),
        ),
    }
}

/// A controller; the scenarios it is restricted to must be among those named, where any are.
pub(super) fn controller(
    section: &Section<'_>,
    process: &Process,
    scenarios: Option<&[&str]>,
) -> Result<StudyController, TextError> {
    let keys = [&["name", "about", "rule", "scenarios"][..], term_keys(), extra_keys()].concat();
    section.only(&keys)?;
    let name = named(section)?;
    let choice = if section.has("rule") {
        if let Some(key) = term_keys().iter().find(|key| **key != "parameters" && section.has(key)) {
            let reason = "cannot stand beside rule: the rule gives it".into();
            return Err(section.error(key, Problem::Conflict { reason }));
        }
        let (id, parameters) = ruled(section, process)?;
        Choice::Rule { id, parameters, extras: extras_section(section)? }
    } else {
        let compensator = section.has("structure");
        if section.has("parameters") && !compensator {
            let reason = "needs a rule or a structure whose parameters they are".into();
            return Err(section.error("parameters", Problem::Conflict { reason }));
        }
        if !section.has("proportional_gain") && !compensator {
            return Err(
                section.missing("proportional_gain", "a finite number other than 0, or rule must be given")
            );
        }
        Choice::Settings(controller_section(section)?)
    };
    let only = section.texts("scenarios")?;
    for (wanted, scenarios) in only.iter().flatten().filter_map(|wanted| Some((wanted, scenarios?))) {
        known_scenario(section, "scenarios", wanted, scenarios)?;
    }
    Ok(StudyController { name, about: section.text("about")?, choice, scenarios: only, line: section.line() })
}

fn family(section: &Section<'_>, process: &Process, scenarios: &[&str]) -> Result<Family, TextError> {
    let keys = ["name", "about", "rule", "parameters", "vary", "values", "scenario"];
    section.only(&[&keys[..], extra_keys()].concat())?;
    let name = named(section)?;
    let (id, parameters) = ruled(section, process)?;
    let vary = section.text("vary")?.ok_or_else(|| section.missing("vary", "the name of a parameter"))?;
    let values = section.numbers("values")?.unwrap_or_default();
    if values.is_empty() {
        return Err(section.missing("values", "a list of at least one number"));
    }
    if parameters.iter().any(|(name, _)| *name == vary) {
        let reason = format!("{vary} is set in parameters, too").into();
        return Err(section.error("vary", Problem::Conflict { reason }));
    }
    for &value in &values {
        let mut parameters = parameters.clone();
        parameters.push((vary.clone(), value));
        check_rule(section, &id, &parameters, process, "values")?;
    }
    let scenario =
        section.text("scenario")?.ok_or_else(|| section.missing("scenario", "the name of a scenario"))?;
    known_scenario(section, "scenario", &scenario, scenarios)?;
    let extras = extras_section(section)?;
    let about = section.text("about")?;
    Ok(Family { name, about, rule: id, parameters, vary, values, scenario, extras, line: section.line() })
}

/// The rule and the parameters of a table, both known to the registry.
fn ruled(section: &Section<'_>, process: &Process) -> Result<(String, Vec<(String, f64)>), TextError> {
    let id = section.text("rule")?.ok_or_else(|| section.missing("rule", "the identifier of a rule"))?;
    let parameters = section.named_numbers("parameters")?.unwrap_or_default();
    check_rule(section, &id, &parameters, process, "parameters")?;
    Ok((id, parameters))
}

/// Refuses what the registry refuses; a specification that cannot be met is an answer and comes with the run.
fn check_rule(
    section: &Section<'_>,
    id: &str,
    parameters: &[(String, f64)],
    process: &Process,
    key: &str,
) -> Result<(), TextError> {
    let conflict = |key: &str, error: RuleError| {
        section.error(key, Problem::Conflict { reason: error.to_string().into() })
    };
    let entry = rule(id).map_err(|error| conflict("rule", error))?;
    let set = parameters.iter().fold(Parameters::new(), |set, (name, value)| set.set(name.clone(), *value));
    entry.check(process, &set).map_err(|error| match error {
        RuleError::DoesNotApply { .. } => conflict("rule", error),
        error => conflict(key, error),
    })
}

fn known_scenario(
    section: &Section<'_>,
    key: &str,
    wanted: &str,
    scenarios: &[&str],
) -> Result<(), TextError> {
    if scenarios.contains(&wanted) {
        return Ok(());
    }
    let names = scenarios.iter().map(|name| format!("'{name}'")).collect::<Vec<_>>().join(", ");
    Err(section.refuse(key, wanted, format!("the name of a scenario: {names}")))
}
