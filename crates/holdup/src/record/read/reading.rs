//! What was read, and what had to be repaired on the way.

use std::fmt;

use serde::Serialize;

use super::ReadError;
use super::clock::TimeFormat;
use super::number::DecimalMark;
use crate::record::Record;

/// What a repair did.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum RepairKind {
    /// Lines before the data that are neither heading nor units.
    SkippedLines,
    /// Lines among the data that are comments.
    CommentLines,
    /// Rows of empty cells.
    EmptyRows,
    /// Rows with other than the usual number of cells.
    UnevenRows,
    /// Rows whose time cannot be read, left out.
    NoTime,
    /// Rows whose value is no number, left out.
    NoValue,
    /// Rows that the source marks as bad, left out.
    BadQuality,
    /// Empty cells that hold the value before.
    HeldValues,
    /// Values of the mode column that are not understood.
    UnknownMode,
    /// The newest row stood first.
    NewestFirst,
    /// The clock went back by an hour.
    ClockBack,
    /// The clock may have gone forward by an hour.
    ClockForward,
    /// Rows in another order than their times.
    OutOfOrder,
    /// Rows that were there twice.
    IdenticalRows,
    /// Rows of one time with different values.
    SameTime,
    /// Times coarser than the rows, spread evenly.
    CoarseClock,
    /// The time of day passed midnight.
    MidnightPassed,
    /// The order of day and month is assumed.
    DateOrderAssumed,
    /// The unit of the times is assumed.
    TimeUnitAssumed,
    /// The decimal mark is assumed.
    DecimalMarkAssumed,
    /// A column was taken without a name that says it.
    ColumnAssumed,
    /// Readings of several tags, one a row of the file, put together to rows.
    PutTogether,
    /// Readings between two rows of the record, not used.
    BetweenRows,
}

/// One repair: what was done, to how many rows.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Repair {
    /// What kind of repair.
    pub kind: RepairKind,
    /// Rows that it concerns.
    pub rows: usize,
    /// A sentence for people.
    pub text: String,
}

impl Repair {
    /// A repair of so many rows.
    pub(super) fn new(kind: RepairKind, rows: usize, text: String) -> Self {
        Self { kind, rows, text }
    }
}

/// A number of things: "1 row", "2 rows".
pub(super) fn counted(count: usize, noun: &str) -> String {
    if count == 1 { format!("1 {noun}") } else { format!("{count} {noun}s") }
}

impl fmt::Display for Repair {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.text)
    }
}

/// A column of the file and what it is used as.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FoundColumn {
    /// Its number, from 1.
    pub number: usize,
    /// Its name.
    pub name: String,
    /// Its unit, where the file says it.
    pub unit: Option<String>,
    /// What it is used as; none where it is not used.
    pub used_as: Option<&'static str>,
}

/// What kind of file it was.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Found {
    /// `csv` or `parquet`.
    pub format: &'static str,
    /// `columns` where a row of the file is one of the record, `readings` where it is one reading of a tag.
    pub layout: &'static str,
    /// Encoding of a text file.
    pub encoding: Option<&'static str>,
    /// What stands between the cells of a text file.
    pub delimiter: Option<&'static str>,
    /// What separates the fraction of a number in a text file.
    pub decimal_mark: Option<DecimalMark>,
    /// Line of the heading, from 1; none where there is none.
    pub heading_line: Option<usize>,
    /// All columns; of readings the time and all tags.
    pub columns: Vec<FoundColumn>,
    /// How times are written.
    pub time_format: TimeFormat,
    /// Date and time of the first row (ISO 8601), where the file says it.
    pub start: Option<String>,
    /// Rows of data in the file; of readings, their number.
    pub rows_in_file: usize,
    /// Rows of the record.
    pub rows: usize,
}

/// A record, where it comes from, and what had to be repaired.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The record; its first row is at 0 s.
    pub record: Record,
    /// What was found in the file.
    pub found: Found,
    /// What had to be repaired or assumed, in the order of the work.
    pub repairs: Vec<Repair>,
    /// Instant of the first row [ns]: since 1970 where the file has dates, else since the zero of its clock.
    pub(super) start: i64,
}

impl Reading {
    /// Checks that the manipulated variable moves, without which nothing can be identified.
    ///
    /// # Errors
    /// [`ReadError::NoMovement`] where it has one value only.
    pub fn moves(&self) -> Result<(), ReadError> {
        let values = self.record.manipulated_variable();
        if values.windows(2).any(|pair| pair[0] != pair[1]) {
            return Ok(());
        }
        let used = |column: &&FoundColumn| column.used_as == Some("manipulated_variable");
        let column =
            self.found.columns.iter().find(used).map_or_else(String::new, |column| column.name.clone());
        Err(ReadError::NoMovement { column, value: values[0], rows: values.len() })
    }
}
