//! Comparing loops and telling what was found.

pub mod atlas;
pub mod figures;
mod file;
pub mod output;
mod own_rules;
pub mod published;
#[cfg(feature = "report")]
pub mod record_report;
#[cfg(feature = "report")]
pub mod report;
mod run;
pub mod runs;
mod sampled;

use crate::analysis::response::Scenario;
use crate::analysis::response::sampled::LoadRamp;
use crate::model::settings::Extras;
use crate::model::{Controller, Process};

pub use file::read_study;
pub use own_rules::{OwnRule, read_rules};
pub use run::{
    ControllerResult, End, FamilyResult, Member, PercentOfBest, Row, ScenarioResult, StudyError,
    StudyProblem, StudyResult, run_study,
};
pub use sampled::{SampledLoops, SampledRow, StudyEquipment};

/// Several controllers on several scenarios, for one process.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// Title for reading.
    pub title: String,
    /// What it is about.
    pub about: Option<String>,
    /// Identifier of the published study whose printed numbers it recomputes.
    pub recomputes: Option<String>,
    /// The process that all controllers control.
    pub process: Process,
    /// Sampling and equipment, where every loop is run sampled, too.
    pub sampled: Option<StudyEquipment>,
    /// The controllers, their names all different; at least one.
    pub controllers: Vec<StudyController>,
    /// The scenarios, their names all different; at least one.
    pub scenarios: Vec<StudyScenario>,
    /// Families of one rule with one parameter varied.
    pub families: Vec<Family>,
}

/// One controller of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyController {
    /// Name, unique in the study.
    pub name: String,
    /// What it is about.
    pub about: Option<String>,
    /// Where its settings come from.
    pub choice: Choice,
    /// The scenarios it runs in; all where this is absent.
    pub scenarios: Option<Vec<String>>,
    /// Line of its table in the study file.
    pub line: usize,
}

/// Where the settings of a controller come from.
#[derive(Debug, Clone, PartialEq)]
pub enum Choice {
    /// They are given.
    Settings(Controller),
    /// A rule gives them.
    Rule {
        /// Identifier of the rule.
        id: String,
        /// Parameters that are set.
        parameters: Vec<(String, f64)>,
        /// What is added to the controller of the rule.
        extras: Extras,
    },
}

/// One scenario of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyScenario {
    /// Name, unique in the study.
    pub name: String,
    /// What it is about.
    pub about: Option<String>,
    /// Setpoint, load, horizon and initial level.
    pub scenario: Scenario,
    /// Ramps of the load, of the sampled loops.
    pub load_ramps: Vec<LoadRamp>,
}

/// One rule with one of its parameters varied.
#[derive(Debug, Clone, PartialEq)]
pub struct Family {
    /// Name, unique among the families.
    pub name: String,
    /// What it is about.
    pub about: Option<String>,
    /// Identifier of the rule.
    pub rule: String,
    /// Parameters that stay.
    pub parameters: Vec<(String, f64)>,
    /// Name of the parameter that varies.
    pub vary: String,
    /// Its values; at least one.
    pub values: Vec<f64>,
    /// Name of the scenario.
    pub scenario: String,
    /// What is added to the controllers of the rule.
    pub extras: Extras,
    /// Line of its table in the study file.
    pub line: usize,
}
