//! Published studies, recomputed: every printed cell against the computed value, with a verdict.
//!
//! A paper is one folder-level file with its printed numbers beside it as data. A cell is judged under the
//! listed convention that comes closest; the verdicts come out of the computation.

pub mod kadam_2017;

use serde::Serialize;
use thiserror::Error;

use crate::analysis::frequency::FrequencyError;
use crate::analysis::response::{ResponseError, ScenarioError};
use crate::model::ModelError;
use crate::tuning::RuleError;

/// Why a paper cannot be recomputed: there is no such paper, or a defect of this software.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PublishedError {
    /// No published study has this identifier.
    #[error("'{0}' must be one of {known}", known = PAPERS.map(|(id, _)| id).join(", "))]
    Unknown(String),
    /// The printed numbers cannot be read.
    #[error("the printed numbers cannot be read: {0}")]
    Data(#[from] toml::de::Error),
    /// A process or controller cannot be built.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A rule refuses.
    #[error(transparent)]
    Rule(#[from] RuleError),
    /// A scenario cannot be built.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// A loop cannot be simulated.
    #[error(transparent)]
    Response(#[from] ResponseError),
    /// A loop cannot be analysed.
    #[error(transparent)]
    Frequency(#[from] FrequencyError),
}

/// What recomputing says of a printed number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Verdict {
    /// Within 0.5 %, or equal when rounded to the printed digits.
    #[serde(rename = "reproduced")]
    Reproduced,
    /// Within 5 %.
    #[serde(rename = "close")]
    Close,
    /// Farther than 5 %.
    #[serde(rename = "not reproduced")]
    NotReproduced,
    /// Breaks a bound that holds for every controller, or an exact identity of the stated loop.
    #[serde(rename = "impossible")]
    Impossible,
}

impl Verdict {
    /// The word for it, as in the JSON.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Reproduced => "reproduced",
            Self::Close => "close",
            Self::NotReproduced => "not reproduced",
            Self::Impossible => "impossible",
        }
    }
}

/// One way to read the paper, and what a cell comes to under it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Candidate {
    /// The convention in words.
    pub convention: String,
    /// Whether it is the one that the paper states.
    pub stated: bool,
    /// The computed value, in the unit of the table.
    pub computed: f64,
}

/// One printed cell and its judgement.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Cell {
    /// Name of the table.
    pub table: String,
    /// Name of the row.
    pub row: String,
    /// Name of the column, with its unit.
    pub column: String,
    /// The printed number, in the unit of the table.
    pub printed: f64,
    /// The computed number under `convention`, in the unit of the table.
    pub computed: f64,
    /// The convention that comes closest.
    pub convention: String,
    /// The judgement.
    pub verdict: Verdict,
    /// Why, where the convention is not the stated one or the verdict is not `reproduced`.
    pub reason: Option<String>,
    /// All conventions that were tried, the closest first.
    pub candidates: Vec<Candidate>,
}

/// How many cells got which verdict.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Summary {
    /// All cells.
    pub cells: usize,
    /// Cells judged `reproduced`.
    pub reproduced: usize,
    /// Cells judged `close`.
    pub close: usize,
    /// Cells judged `not reproduced`.
    pub not_reproduced: usize,
    /// Cells judged `impossible`.
    pub impossible: usize,
}

impl Summary {
    /// The count over these cells.
    #[must_use]
    pub fn of(cells: &[Cell]) -> Self {
        let mut summary = Self { cells: cells.len(), ..Self::default() };
        for cell in cells {
            *match cell.verdict {
                Verdict::Reproduced => &mut summary.reproduced,
                Verdict::Close => &mut summary.close,
                Verdict::NotReproduced => &mut summary.not_reproduced,
                Verdict::Impossible => &mut summary.impossible,
            } += 1;
        }
        summary
    }
}

/// A statement about the paper that a reader does not see in it, with the numbers that carry it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Finding {
    /// The finding in one line.
    pub title: String,
    /// What was computed, in sentences.
    pub text: String,
    /// The single facts, one a line.
    pub points: Vec<String>,
}

/// A published study, recomputed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reproduction {
    /// Citation of the paper.
    pub paper: String,
    /// Every printed cell.
    pub cells: Vec<Cell>,
    /// The count of the verdicts.
    pub summary: Summary,
    /// What the numbers show.
    pub findings: Vec<Finding>,
}

/// Recomputes one paper.
type Recompute = fn() -> Result<Reproduction, PublishedError>;

/// The published studies that can be recomputed, by identifier.
pub const PAPERS: [(&str, Recompute); 1] = [("kadam-2017", kadam_2017::reproduce)];

/// Recomputes the paper of this identifier; underscores count as hyphens.
///
/// # Errors
/// [`PublishedError::Unknown`] if there is no such paper; anything else is a defect of this software.
///
/// ```
/// use holdup::study::published::reproduce;
/// assert_eq!(reproduce("kadam-2017")?.cells.len(), 87);
/// assert!(reproduce("kadam-2018").is_err());
/// # Ok::<(), holdup::study::published::PublishedError>(())
/// ```
pub fn reproduce(id: &str) -> Result<Reproduction, PublishedError> {
    let wanted = id.replace('_', "-");
    match PAPERS.iter().find(|(known, _)| *known == wanted) {
        Some((_, recompute)) => recompute(),
        None => Err(PublishedError::Unknown(id.to_owned())),
    }
}

/// A lower limit of a cell that no computation can go below, and why.
#[derive(Debug, Clone)]
struct Floor {
    value: f64,
    why: String,
}

/// A number as printed: its value and half a unit of its last digit.
#[derive(Debug, Clone, Copy)]
struct Printed {
    value: f64,
    half_unit: f64,
}

impl Printed {
    fn parse(text: &str) -> Option<Self> {
        let value = text.parse::<f64>().ok()?;
        let decimals = text.split_once('.').map_or(0, |(_, fraction)| fraction.len());
        let decimals = i32::try_from(decimals).ok()?;
        Some(Self { value, half_unit: 0.5 * 10_f64.powi(-decimals) })
    }

    fn deviation(self, computed: f64) -> f64 {
        (computed - self.value).abs() / self.value.abs()
    }

    fn equals_when_rounded(self, computed: f64) -> bool {
        (computed - self.value).abs() <= self.half_unit * (1.0 + 1e-9)
    }

    fn verdict(self, computed: f64) -> Verdict {
        match self.deviation(computed) {
            _ if self.equals_when_rounded(computed) => Verdict::Reproduced,
            x if x <= 0.005 => Verdict::Reproduced,
            x if x <= 0.05 => Verdict::Close,
            _ => Verdict::NotReproduced,
        }
    }
}

/// Judges one cell: the closest candidate decides, a broken floor overrides it.
fn judge(
    (table, row, column): (&str, &str, &str),
    printed: Printed,
    mut candidates: Vec<Candidate>,
    floors: &[Floor],
) -> Option<Cell> {
    // Among candidates that all round to the printed digits the stated one is named.
    let distance = |c: &Candidate| {
        let exact = printed.equals_when_rounded(c.computed);
        (!exact, if exact { f64::from(u8::from(!c.stated)) } else { printed.deviation(c.computed) })
    };
    candidates.sort_by(|a, b| distance(a).partial_cmp(&distance(b)).unwrap_or(std::cmp::Ordering::Equal));
    let best = candidates.first()?.clone();
    let broken = floors.iter().find(|f| printed.value + printed.half_unit < f.value * (1.0 - 1e-9));
    let (verdict, reason) = if let Some(floor) = broken {
        (Verdict::Impossible, Some(floor.why.clone()))
    } else {
        let verdict = printed.verdict(best.computed);
        (verdict, reason_of(verdict, printed, &best, &candidates))
    };
    Some(Cell {
        table: table.to_owned(),
        row: row.to_owned(),
        column: column.to_owned(),
        printed: printed.value,
        computed: best.computed,
        convention: best.convention,
        verdict,
        reason,
        candidates,
    })
}

fn reason_of(verdict: Verdict, printed: Printed, best: &Candidate, all: &[Candidate]) -> Option<String> {
    let percent = |c: &Candidate| 100.0 * (c.computed - printed.value) / printed.value.abs();
    let mut reasons = Vec::new();
    if verdict != Verdict::Reproduced {
        reasons.push(format!(
            "the computed {:.6} is {:+.1} % from the printed value under the closest of {} listed convention{}",
            best.computed,
            percent(best),
            all.len(),
            if all.len() == 1 { "" } else { "s" },
        ));
    }
    if let (false, Some(stated)) = (best.stated, all.iter().find(|c| c.stated)) {
        reasons.push(format!(
            "the paper states \u{201c}{}\u{201d}, which gives {:.6} ({:+.1} %)",
            stated.convention,
            stated.computed,
            percent(stated)
        ));
    }
    (!reasons.is_empty()).then(|| reasons.join("; "))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn candidate(computed: f64, stated: bool) -> Candidate {
        Candidate { convention: format!("gives {computed}"), stated, computed }
    }

    fn cell(printed: &str, candidates: Vec<Candidate>, floors: &[Floor]) -> Cell {
        judge(("t", "r", "c"), Printed::parse(printed).unwrap(), candidates, floors).unwrap()
    }

    #[test]
    fn verdicts_follow_their_definitions_on_both_sides_of_each_limit() {
        let verdict = |computed| cell("100.0", vec![candidate(computed, true)], &[]).verdict;
        assert_eq!(verdict(100.5), Verdict::Reproduced);
        assert_eq!(verdict(100.51), Verdict::Close);
        assert_eq!(verdict(105.0), Verdict::Close);
        assert_eq!(verdict(94.9), Verdict::NotReproduced);
    }

    #[test]
    fn a_value_that_rounds_to_the_printed_digits_is_reproduced_however_coarse_they_are() {
        assert_eq!(cell("0.2", vec![candidate(0.249, true)], &[]).verdict, Verdict::Reproduced);
    }

    #[test]
    fn the_closest_convention_is_named_and_the_stated_one_explained() {
        let cell = cell("10.0", vec![candidate(12.0, true), candidate(10.01, false)], &[]);
        assert_eq!(cell.convention, "gives 10.01");
        assert!(cell.reason.unwrap().contains("gives 12"));
    }

    #[test]
    fn a_broken_bound_is_impossible_even_where_a_convention_comes_close() {
        let floor = Floor { value: 6.0, why: "the error is 1 during the dead time".to_owned() };
        assert_eq!(cell("5.9", vec![candidate(5.9, true)], &[floor]).verdict, Verdict::Impossible);
    }

    #[test]
    fn a_printed_value_within_rounding_of_a_bound_does_not_break_it() {
        let floor = Floor { value: 6.0, why: String::new() };
        assert_eq!(
            cell("5.96", vec![candidate(6.0, true)], std::slice::from_ref(&floor)).verdict,
            Verdict::Impossible
        );
        assert_eq!(cell("6.0", vec![candidate(6.02, true)], &[floor]).verdict, Verdict::Reproduced);
    }
}
