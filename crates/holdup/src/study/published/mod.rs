//! Papers whose printed numbers are recomputed, and what recomputing says of each.

mod judge;
mod kadam_2017;

use serde::Serialize;
use thiserror::Error;

use super::StudyProblem;
use crate::model::TextError;

/// Identifiers of the papers.
pub const PAPERS: [&str; 1] = ["kadam-2017"];

/// Why a paper cannot be recomputed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PaperError {
    /// No paper has this identifier.
    #[error("'{0}' is no paper known here: must be kadam-2017")]
    Unknown(String),
    /// The printed numbers cannot be read.
    #[error("printed numbers: {0}")]
    Printed(#[from] TextError),
    /// A loop of the paper cannot be tuned, analysed or simulated.
    #[error(transparent)]
    Problem(#[from] StudyProblem),
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
    /// All verdicts, the best first.
    pub const ALL: [Self; 4] = [Self::Reproduced, Self::Close, Self::NotReproduced, Self::Impossible];

    /// The word for reading.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Reproduced => "reproduced",
            Self::Close => "close",
            Self::NotReproduced => "not reproduced",
            Self::Impossible => "impossible",
        }
    }
}

/// One printed number with what was computed for it, in the unit of its table.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Cell {
    /// Label of the table in the source.
    pub table: &'static str,
    /// Row.
    pub row: &'static str,
    /// Column, with its unit.
    pub column: &'static str,
    /// The number as printed.
    pub printed: f64,
    /// The number computed under the convention.
    pub computed: Option<f64>,
    /// The convention that comes closest.
    pub convention: String,
    /// What recomputing says.
    pub verdict: Verdict,
    /// Why, in words that a reader can check; absent where the stated convention reproduces the number.
    pub reason: Option<String>,
    /// What every convention gives, the stated one first.
    pub readings: Vec<Reading>,
}

/// What one convention gives.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reading {
    /// The convention.
    pub convention: String,
    /// The number computed under it.
    pub computed: Option<f64>,
}

/// How many cells have which verdict.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Summary {
    /// Number of cells.
    pub cells: usize,
    /// Cells that are reproduced.
    pub reproduced: usize,
    /// Cells that come close.
    pub close: usize,
    /// Cells that are not reproduced.
    pub not_reproduced: usize,
    /// Cells that are impossible.
    pub impossible: usize,
}

/// A paper recomputed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reproduction {
    /// Every printed number.
    pub cells: Vec<Cell>,
    /// How many have which verdict.
    pub summary: Summary,
}

/// Recomputes every printed number of a paper.
///
/// ```
/// let paper = holdup::study::published::reproduce("kadam-2017")?;
/// assert_eq!(paper.summary.cells, 87);
/// assert_eq!(paper.summary.impossible, 5);
/// # Ok::<(), holdup::study::published::PaperError>(())
/// ```
///
/// # Errors
/// [`PaperError`] if the paper is not known, or one of its loops cannot be computed.
pub fn reproduce(paper: &str) -> Result<Reproduction, PaperError> {
    let cells = match paper {
        "kadam-2017" => kadam_2017::cells()?,
        other => return Err(PaperError::Unknown(other.to_owned())),
    };
    let count = |verdict| cells.iter().filter(|cell| cell.verdict == verdict).count();
    let summary = Summary {
        cells: cells.len(),
        reproduced: count(Verdict::Reproduced),
        close: count(Verdict::Close),
        not_reproduced: count(Verdict::NotReproduced),
        impossible: count(Verdict::Impossible),
    };
    Ok(Reproduction { cells, summary })
}
