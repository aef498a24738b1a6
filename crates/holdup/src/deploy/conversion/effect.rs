//! What it costs a loop that a block cannot represent its controller: the margins of both.

use crate::analysis::frequency::{FrequencyError, Margins, margins};
use crate::model::{ClosedLoop, Controller, Process};

/// A margin is worth a sentence where it changes by more than this.
const WORTH: f64 = 0.01;

/// The margins of the loop as it was designed, and as the block runs it.
#[derive(Debug, Clone, PartialEq)]
pub struct Effect {
    /// With the controller as designed.
    pub designed: Margins,
    /// With the controller that the block runs.
    pub run: Margins,
}

impl Effect {
    /// Both margins on a process. Sampling is not in them.
    ///
    /// # Errors
    /// [`FrequencyError`] as [`margins`].
    pub fn of(process: &Process, designed: &Controller, run: &Controller) -> Result<Self, FrequencyError> {
        let of = |controller| margins(&ClosedLoop::new(process, controller));
        Ok(Self { designed: of(designed)?, run: of(run)? })
    }

    /// What changes, one sentence each; nothing where the block runs what was designed.
    #[must_use]
    pub fn sentences(&self) -> Vec<String> {
        let Self { designed, run } = self;
        match (designed.stable, run.stable) {
            (true, false) => return vec!["The loop is unstable with what the block runs.".to_owned()],
            (false, true) => {
                return vec![
                    "The loop is unstable as designed, and stable with what the block runs.".to_owned(),
                ];
            }
            (false, false) => {
                return vec!["The loop is unstable, as designed and as the block runs it.".to_owned()];
            }
            (true, true) => {}
        }
        let degrees = |margins: &Margins| margins.phase_margin.map(crate::model::Radians::degrees);
        let seconds = |margins: &Margins| margins.delay_margin.map(|time| time.0);
        [
            ("gain margin", "", designed.gain_margin, run.gain_margin),
            ("phase margin", "°", degrees(designed), degrees(run)),
            ("delay margin", " s", seconds(designed), seconds(run)),
            ("sensitivity peak", "", designed.sensitivity_peak, run.sensitivity_peak),
        ]
        .into_iter()
        .filter_map(|(name, unit, before, after)| {
            let (before, after) = (before?, after?);
            let changes = (after - before).abs() > WORTH * before.abs();
            let digits = |value: f64| format!("{value:.3}");
            changes.then(|| {
                format!("The {name} becomes {}{unit} instead of {}{unit}.", digits(after), digits(before))
            })
        })
        .collect()
    }
}
