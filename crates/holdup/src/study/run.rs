//! Running a study: every controller on its scenarios, as plain data. Reports are views of it.

use std::collections::BTreeMap;

use serde::Serialize;
use thiserror::Error;

use super::sampled::{self, SampledLoops, SampledRow};
use super::{Choice, Family, Study, StudyController, StudyScenario};
use crate::analysis::bounds::Bounds;
use crate::analysis::frequency::{FrequencyError, Margins, margins};
use crate::analysis::metrics::Metrics;
use crate::analysis::response::{ResponseError, Scenario, simulate};
use crate::model::description::{ControllerDescription, ProcessDescription};
use crate::model::{ClosedLoop, Controller, ModelError, Process};
use crate::tuning::{Infeasible, Parameters, RuleError, Specification, Tuning, rule};

/// Why a study has no result: the table of the file, and what is wrong with it.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("'{name}': {problem}")]
pub struct StudyError {
    /// Name of the controller or family.
    pub name: String,
    /// Line of its table in the study file.
    pub line: usize,
    /// What is wrong.
    pub problem: StudyProblem,
}

/// What may keep a controller of a study from running.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum StudyProblem {
    /// Its rule refuses.
    #[error(transparent)]
    Rule(#[from] RuleError),
    /// What is added to its rule does not fit.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// Its margins cannot be computed.
    #[error(transparent)]
    Frequency(#[from] FrequencyError),
    /// Its response cannot be computed.
    #[error("scenario '{scenario}': {error}")]
    Response {
        /// Name of the scenario.
        scenario: String,
        /// What is wrong.
        error: ResponseError,
    },
}

/// The result of a study.
#[derive(Debug, Clone, Serialize)]
pub struct StudyResult {
    /// Title of the study.
    pub title: String,
    /// What it is about.
    pub about: Option<String>,
    /// The process.
    pub process: ProcessDescription,
    /// The runs, by scenario.
    pub scenarios: Vec<ScenarioResult>,
    /// The controllers and what they achieve.
    pub controllers: Vec<ControllerResult>,
    /// The families of one rule with one parameter varied.
    pub families: Vec<FamilyResult>,
    /// What must be known, one sentence each.
    pub warnings: Vec<String>,
}

/// One scenario with the runs of its controllers.
#[derive(Debug, Clone, Serialize)]
pub struct ScenarioResult {
    /// Name of the scenario.
    pub name: String,
    /// What it is about.
    pub about: Option<String>,
    /// Setpoint moves: time [s] and value.
    pub setpoint: Vec<(f64, f64)>,
    /// Load steps: time [s] and value.
    pub load: Vec<(f64, f64)>,
    /// Load ramps, of the sampled loops: start [s], end [s] and change.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub load_ramp: Vec<(f64, f64, f64)>,
    /// Horizon [s].
    pub horizon_s: f64,
    /// The output at rest before.
    pub initial: f64,
    /// One row per controller.
    pub rows: Vec<Row>,
    /// The scenario itself.
    #[serde(skip)]
    pub scenario: Scenario,
    /// The sampled loops of the rows that have one, for drawing.
    #[serde(skip)]
    pub sampled: SampledLoops,
}

/// One controller on one scenario.
#[derive(Debug, Clone, Serialize)]
pub struct Row {
    /// Name of the controller.
    pub controller: String,
    /// What it does.
    pub metrics: Metrics,
    /// What no controller beats.
    pub bounds: Bounds,
    /// 100 · bound / metric: 100 is the best any controller can do.
    pub percent_of_best: PercentOfBest,
    /// The end of the run.
    #[serde(rename = "final")]
    pub end: End,
    /// What it does sampled, where the study has a table `[sampled]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sampled: Option<SampledRow>,
    /// When the response of an unstable loop left the numbers [s]; null where it did not.
    pub overflow_at_s: Option<f64>,
    /// What must be known, one sentence each.
    pub warnings: Vec<String>,
}

/// The end of a run.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct End {
    /// Controlled variable at the horizon.
    pub controlled_variable: Option<f64>,
    /// Manipulated variable at the horizon.
    pub manipulated_variable: Option<f64>,
}

/// How near a run comes to the best possible [%].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct PercentOfBest {
    /// Of the integral of the absolute error.
    pub iae: Option<f64>,
    /// Of the integral of the squared error.
    pub ise: Option<f64>,
    /// Of the integral of time times absolute error.
    pub itae: Option<f64>,
    /// Of the peak of the error.
    pub peak: Option<f64>,
}

impl PercentOfBest {
    /// From what was achieved and what is possible; absent where either is.
    #[must_use]
    pub fn of(metrics: &Metrics, bounds: &Bounds) -> Self {
        let percent = |bound: Option<f64>, value: Option<f64>| match (bound, value) {
            (Some(bound), Some(value)) if value > 0.0 => Some(100.0 * bound / value),
            _ => None,
        };
        Self {
            iae: percent(bounds.iae, metrics.iae),
            ise: percent(bounds.ise, metrics.ise),
            itae: percent(bounds.itae, metrics.itae),
            peak: percent(bounds.peak, metrics.peak),
        }
    }
}

/// One controller and what it achieves.
#[derive(Debug, Clone, Serialize)]
pub struct ControllerResult {
    /// Name of the controller.
    pub name: String,
    /// What it is about.
    pub about: Option<String>,
    /// The rule it comes from.
    pub rule: Option<&'static str>,
    /// The parameters that were set.
    pub parameters: BTreeMap<String, f64>,
    /// Its settings; null where no controller meets what was asked.
    pub controller: Option<ControllerDescription>,
    /// What was asked for, where it comes from a rule.
    pub specification: Option<Specification>,
    /// What is achieved; null where there is no controller.
    pub achieved: Option<Margins>,
    /// What is achieved sampled, where the study has a table `[sampled]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub achieved_sampled: Option<Margins>,
    /// High-frequency gain from measurement to controller output; null where it is infinite.
    pub noise_gain: Option<f64>,
    /// Why no controller meets what was asked, and what can be had.
    pub infeasible: Option<Box<Infeasible>>,
    /// What must be known, one sentence each.
    pub warnings: Vec<String>,
    /// The controller itself.
    #[serde(skip)]
    pub chosen: Option<Controller>,
}

/// One rule with one parameter varied, on one scenario.
#[derive(Debug, Clone, Serialize)]
pub struct FamilyResult {
    /// Name of the family.
    pub name: String,
    /// What it is about.
    pub about: Option<String>,
    /// The rule.
    pub rule: String,
    /// The parameter that varies.
    pub vary: String,
    /// Name of the scenario.
    pub scenario: String,
    /// One member per value.
    pub members: Vec<Member>,
}

/// One member of a family.
#[derive(Debug, Clone, Serialize)]
pub struct Member {
    /// The value of the parameter that varies.
    pub value: f64,
    /// Its controller and what it achieves.
    #[serde(flatten)]
    pub controller: ControllerResult,
    /// Its run; null where there is no controller.
    pub run: Option<Row>,
}

/// Runs a study.
///
/// A rule that finds no controller for what was asked is an answer: its `infeasible` says why.
///
/// # Errors
/// [`StudyError`] if a controller cannot be tuned, analysed or simulated at all.
pub fn run_study(study: &Study) -> Result<StudyResult, StudyError> {
    let process = &study.process;
    let mut controllers = Vec::with_capacity(study.controllers.len());
    for controller in &study.controllers {
        let mut result = result_of(process, controller).map_err(|problem| at(controller, problem))?;
        sampled::achieved(study, &mut result);
        controllers.push(result);
    }
    let mut scenarios = Vec::with_capacity(study.scenarios.len());
    for scenario in &study.scenarios {
        let mut rows = Vec::new();
        for (given, result) in study.controllers.iter().zip(&controllers) {
            let wanted = given.scenarios.as_ref().is_none_or(|names| names.contains(&scenario.name));
            if let (true, Some(chosen)) = (wanted, &result.chosen) {
                let row = run(study, &given.name, chosen, scenario);
                rows.push(row.map_err(|problem| at(given, problem))?);
            }
        }
        scenarios.push(ScenarioResult {
            name: scenario.name.clone(),
            about: scenario.about.clone(),
            setpoint: scenario.scenario.setpoint().to_vec(),
            load: scenario.scenario.load().to_vec(),
            load_ramp: scenario.load_ramps.iter().map(|r| (r.start(), r.end(), r.change())).collect(),
            horizon_s: scenario.scenario.horizon(),
            initial: scenario.scenario.initial(),
            sampled: SampledLoops::of(study, scenario, &rows, &controllers),
            rows,
            scenario: scenario.scenario.clone(),
        });
    }
    let families = study.families.iter().map(|family| run_family(study, family));
    let families = families.collect::<Result<_, _>>()?;
    let warnings = told(&controllers, &scenarios);
    Ok(StudyResult {
        title: study.title.clone(),
        about: study.about.clone(),
        process: ProcessDescription::from(process),
        scenarios,
        controllers,
        families,
        warnings,
    })
}

/// Every warning of the parts, with the name of its controller, each once.
fn told(controllers: &[ControllerResult], scenarios: &[ScenarioResult]) -> Vec<String> {
    let of_controllers = controllers.iter().flat_map(|controller| {
        controller.warnings.iter().map(|warning| format!("{}: {warning}", controller.name))
    });
    let of_rows = scenarios.iter().flat_map(|scenario| {
        scenario.rows.iter().flat_map(|row| {
            row.warnings.iter().map(|warning| format!("{}, {}: {warning}", scenario.name, row.controller))
        })
    });
    let mut warnings: Vec<String> = Vec::new();
    for warning in of_controllers.chain(of_rows) {
        if !warnings.contains(&warning) {
            warnings.push(warning);
        }
    }
    warnings
}

fn at(controller: &StudyController, problem: StudyProblem) -> StudyError {
    StudyError { name: controller.name.clone(), line: controller.line, problem }
}

fn result_of(process: &Process, given: &StudyController) -> Result<ControllerResult, StudyProblem> {
    let (name, about) = (given.name.clone(), given.about.clone());
    match &given.choice {
        Choice::Settings(controller) => achieved(process, name, about, controller, None),
        Choice::Rule { id, parameters, extras } => {
            let tuned = tune(process, id, parameters);
            let tuning = match tuned {
                Ok(tuning) => tuning,
                Err(RuleError::Infeasible(infeasible)) => {
                    return Ok(no_controller(name, about, parameters, infeasible));
                }
                Err(error) => return Err(error.into()),
            };
            let controller = extras.apply(tuning.controller)?;
            let result = achieved(process, name, about, &controller, Some(tuning))?;
            Ok(ControllerResult { parameters: parameters.iter().cloned().collect(), ..result })
        }
    }
}

fn tune(process: &Process, id: &str, parameters: &[(String, f64)]) -> Result<Tuning, RuleError> {
    let set = parameters.iter().fold(Parameters::new(), |set, (name, value)| set.set(name.clone(), *value));
    rule(id)?.tune(process, &set)
}

fn no_controller(
    name: String,
    about: Option<String>,
    parameters: &[(String, f64)],
    infeasible: Box<Infeasible>,
) -> ControllerResult {
    ControllerResult {
        name,
        about,
        rule: Some(infeasible.rule),
        parameters: parameters.iter().cloned().collect(),
        controller: None,
        specification: Some(infeasible.asked),
        achieved: None,
        achieved_sampled: None,
        noise_gain: None,
        warnings: vec![infeasible.to_string()],
        infeasible: Some(infeasible),
        chosen: None,
    }
}

fn achieved(
    process: &Process,
    name: String,
    about: Option<String>,
    controller: &Controller,
    tuning: Option<Tuning>,
) -> Result<ControllerResult, StudyProblem> {
    let achieved = margins(&ClosedLoop::new(process, controller))?;
    let mut description = ControllerDescription::from(controller);
    let mut warnings = Vec::new();
    if let Some(tuning) = &tuning {
        description.published = serde_json::to_value(&tuning.published).unwrap_or_default();
        warnings.extend(tuning.warnings.iter().cloned());
    }
    warnings.extend(achieved.warnings.iter().cloned());
    let noise_gain = controller.noise_gain();
    if noise_gain.is_none() {
        warnings.push("the noise gain is infinite: the derivative is not filtered".to_owned());
    }
    Ok(ControllerResult {
        name,
        about,
        rule: tuning.as_ref().map(|tuning| tuning.rule),
        parameters: BTreeMap::new(),
        controller: Some(description),
        specification: tuning.map(|tuning| tuning.specification),
        achieved: Some(achieved),
        achieved_sampled: None,
        noise_gain,
        infeasible: None,
        warnings,
        chosen: Some(*controller),
    })
}

fn run(
    study: &Study,
    name: &str,
    controller: &Controller,
    scenario: &StudyScenario,
) -> Result<Row, StudyProblem> {
    let process = &study.process;
    let response = simulate(&ClosedLoop::new(process, controller), &scenario.scenario)
        .map_err(|error| StudyProblem::Response { scenario: scenario.name.clone(), error })?;
    let mut row = Row {
        controller: name.to_owned(),
        percent_of_best: PercentOfBest::default(),
        metrics: response.metrics,
        bounds: Bounds::of(process, &scenario.scenario),
        end: End {
            controlled_variable: finite(response.final_controlled_variable),
            manipulated_variable: finite(response.final_manipulated_variable),
        },
        sampled: None,
        overflow_at_s: response.overflow_at.map(|time| time.0),
        warnings: response.warnings,
    };
    if !scenario.load_ramps.is_empty() {
        // The continuous run knows nothing of the ramps: its numbers would be those of another scenario.
        (row.metrics, row.end, row.overflow_at_s) = (Metrics::default(), End::default(), None);
        row.bounds = Bounds::default();
        row.warnings = vec!["continuous loops are not simulated under load ramps".to_owned()];
    }
    row.percent_of_best = PercentOfBest::of(&row.metrics, &row.bounds);
    match sampled::run(study, controller, scenario) {
        Ok(sampled) => row.sampled = sampled,
        Err(reason) => row.warnings.push(reason),
    }
    Ok(row)
}

impl Row {
    /// The metrics of this row with the name of their loop: the continuous one where it was run, then the sampled one.
    pub fn lines(&self) -> impl Iterator<Item = (String, &Metrics)> {
        let continuous = (self.metrics != Metrics::default() || self.sampled.is_none())
            .then(|| (self.controller.clone(), &self.metrics));
        let sampled =
            self.sampled.as_ref().map(|run| (format!("{}, sampled", self.controller), &run.metrics));
        continuous.into_iter().chain(sampled)
    }
}

/// The value, where it is one.
pub(super) fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

fn run_family(study: &Study, family: &Family) -> Result<FamilyResult, StudyError> {
    let at = |problem| StudyError { name: family.name.clone(), line: family.line, problem };
    let scenario = study.scenarios.iter().find(|scenario| scenario.name == family.scenario);
    let mut members = Vec::with_capacity(family.values.len());
    for &value in &family.values {
        let mut parameters = family.parameters.clone();
        parameters.push((family.vary.clone(), value));
        let choice = Choice::Rule { id: family.rule.clone(), parameters, extras: family.extras };
        let name = format!("{} = {value}", family.vary);
        let given = StudyController { name, about: None, choice, scenarios: None, line: family.line };
        let controller = result_of(&study.process, &given).map_err(at)?;
        let row = match (&controller.chosen, scenario) {
            (Some(chosen), Some(scenario)) => Some(run(study, &given.name, chosen, scenario).map_err(at)?),
            _ => None,
        };
        members.push(Member { value, controller, run: row });
    }
    Ok(FamilyResult {
        name: family.name.clone(),
        about: family.about.clone(),
        rule: family.rule.clone(),
        vary: family.vary.clone(),
        scenario: family.scenario.clone(),
        members,
    })
}
