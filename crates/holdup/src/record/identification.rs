//! What a record says about its process, with a verdict.

use serde::Serialize;

use super::advice::SafeTest;
use super::confidence::{Confidence, Slice};
use super::controller::RunningController;
use super::diagnosis::Diagnosis;
use super::excitation::Excitation;
use super::identify::{Hold, Kind, Load, Noise};
use super::load::RecoveredLoad;
use super::load_steps::LoadStep;
use crate::model::{ModelError, Process, Seconds};

/// How far the result can be trusted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// The intervals are narrow enough to tune by.
    Identified,
    /// There is a result with honest intervals, too wide or too conditional to tune by without care.
    Weak,
    /// The record does not identify the process; there is no result.
    Refused,
}

impl Verdict {
    /// The word that reports and JSON use.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Identified => "identified",
            Self::Weak => "weak",
            Self::Refused => "refused",
        }
    }
}

/// What is known or wanted beforehand.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct IdentifyOptions {
    /// The greatest dead time that is looked for [s]; a quarter of the record and at most 2000 rows where absent.
    pub greatest_dead_time: Option<f64>,
    /// The kind of process; chosen from all where absent.
    pub kind: Option<Kind>,
    /// How the input goes between rows.
    pub hold: Hold,
    /// What the load is taken for beside its random part.
    pub load: Load,
    /// The greatest number of sudden changes of the load that are looked for; 3 where absent, 0 for none.
    pub load_steps: Option<usize>,
    /// How far the controlled variable may move in a test [output unit]; its own spread in the record where absent.
    pub excursion: Option<f64>,
}

/// The process that was found.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct IdentifiedProcess {
    /// Kind of process.
    #[serde(skip)]
    pub kind: Kind,
    /// Process gain [output unit/(input unit·s)], over s once more for the double integrator.
    pub process_gain: f64,
    /// Dead time [s].
    #[serde(rename = "dead_time_s")]
    pub dead_time: f64,
    /// Lag [s], where the model has one.
    #[serde(rename = "lag_s")]
    pub lag: Option<f64>,
    /// Gain at rest [output unit/input unit] of a self-regulating process.
    pub static_gain: Option<f64>,
}

impl IdentifiedProcess {
    /// The process as the rest of the library has it. A dead time of less than half a row is taken as half a row, which
    /// sampling alone costs. A self-regulating process is taken for the integrating one that it begins as.
    ///
    /// # Errors
    /// Where gain or times are out of range.
    pub fn process(&self, row: Seconds) -> Result<Process, ModelError> {
        let dead_time = Seconds(self.dead_time.max(row.0 / 2.0));
        match (self.kind, self.lag) {
            (Kind::DoubleIntegrating, _) => Process::double_integrating(self.process_gain, dead_time),
            (Kind::IntegratingWithLag, Some(lag)) => {
                Process::integrating(self.process_gain, dead_time)?.with_lag(Seconds(lag))
            }
            _ => Process::integrating(self.process_gain, dead_time),
        }
    }
}

/// One kind of process beside the record.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Candidate {
    /// Kind of process.
    pub kind: Kind,
    /// The best of this kind.
    pub process: IdentifiedProcess,
    /// Schwarz's criterion (G. Schwarz, Ann. Statist. 6 (1978) 461) less that of the chosen kind: 0 is best, above 10 is
    /// strong evidence against.
    pub criterion: f64,
}

/// How the fit goes with the record.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FitQuality {
    /// Rows that were fitted, or blocks of rows.
    pub rows: usize,
    /// Rows in each block.
    pub block_rows: usize,
    /// Standard deviation of the whitened residual as one-row prediction error [output unit].
    pub prediction_error: f64,
    /// The noise model.
    pub noise: Noise,
    /// Time of each row [s].
    #[serde(skip)]
    pub time: Vec<f64>,
    /// The model's controlled variable in each row.
    #[serde(skip)]
    pub model: Vec<f64>,
    /// What it leaves.
    #[serde(skip)]
    pub residual: Vec<f64>,
}

/// The answer of an identification.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Identification {
    /// How far it can be trusted.
    pub verdict: Verdict,
    /// Why.
    pub reasons: Vec<String>,
    /// The kind of process that goes with the record best; absent when refused.
    pub model: Option<Kind>,
    /// The process; absent when refused.
    pub process: Option<IdentifiedProcess>,
    /// Intervals of 95 %; absent when refused.
    pub confidence: Option<Confidence>,
    /// The joint region of 95 % of gain and dead time; empty when refused.
    #[serde(skip)]
    pub region: Vec<Slice>,
    /// Why this kind was chosen.
    pub choice: String,
    /// All kinds that were compared, the chosen first; empty when refused before a fit.
    pub candidates: Vec<Candidate>,
    /// What moved the loop from outside.
    pub excitation: Excitation,
    /// The controller that was running, where one is seen.
    pub controller: Option<RunningController>,
    /// Sudden changes of the load, in the order of their times; empty when refused.
    pub load_steps: Vec<LoadStep>,
    /// The load that explains the rest.
    pub load: Option<RecoveredLoad>,
    /// The fit.
    pub fit: Option<FitQuality>,
    /// What is wrong with the loop as it runs.
    pub diagnosis: Diagnosis,
    /// The smallest safe test that would suffice, where the verdict is weak or refused and one is known.
    pub test: Option<SafeTest>,
}
