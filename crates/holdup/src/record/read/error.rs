//! Why a file is no record.

use std::io;

use thiserror::Error;

use super::column::Place;
use crate::model::text::one_line;
use crate::record::RecordError;

/// Why a file is no record of a loop. Every message is one line.
#[derive(Debug, Error)]
pub enum ReadError {
    /// The file cannot be opened or read.
    #[error("cannot be read: {}", reason(.0))]
    Unreadable(#[from] io::Error),
    /// The path is a folder.
    #[error("is a folder: must be a CSV or Parquet file")]
    Folder,
    /// The file is greater than what is read.
    #[error("has {size} bytes: at most {limit} are read; export a shorter time or fewer columns")]
    Size {
        /// Size of the file [bytes].
        size: u64,
        /// The limit [bytes].
        limit: u64,
    },
    /// There is nothing in the file.
    #[error("is empty: must be a table with a time, a controlled and a manipulated variable")]
    Empty,
    /// The file is no text.
    #[error("is {what}: must be text (CSV) or Parquet")]
    NoText {
        /// What it is.
        what: &'static str,
    },
    /// No row looks like data.
    #[error("has no row of at least two numbers or timestamps; first line: {first}")]
    NoTable {
        /// The first line.
        first: String,
    },
    /// A Parquet file that is damaged, or cannot be read without the feature `parquet`.
    #[error("is a Parquet file that cannot be read: {}", one_line(.0))]
    Parquet(String),
    /// A column that was asked for does not exist.
    #[error("{option}: no {noun} {given}{hint}; {noun}s: {columns}")]
    NoColumn {
        /// `column`, or `tag` where a row of the file is a reading of a tag.
        noun: &'static str,
        /// The option.
        option: &'static str,
        /// What it says.
        given: String,
        /// The nearest name, as a question.
        hint: String,
        /// The columns or tags of the file.
        columns: String,
    },
    /// A column that is needed was not found by its name.
    #[error("no {noun} is known to be the {what}: name it with {option}; {noun}s: {columns}")]
    Missing {
        /// `column`, or `tag` where a row of the file is a reading of a tag.
        noun: &'static str,
        /// What the column would be.
        what: &'static str,
        /// The option that names it.
        option: &'static str,
        /// The columns or tags of the file.
        columns: String,
    },
    /// Several columns may be meant.
    #[error("several {noun}s may be the {what}: {candidates}; name one with {option}")]
    Ambiguous {
        /// `column`, or `tag` where a row of the file is a reading of a tag.
        noun: &'static str,
        /// What the column would be.
        what: &'static str,
        /// The option that names it.
        option: &'static str,
        /// The columns in question.
        candidates: String,
    },
    /// A column that was given two roles.
    #[error("{noun} {column} is given as {first} and as {second}: must be one of them")]
    Twice {
        /// `column`, or `tag` where a row of the file is a reading of a tag.
        noun: &'static str,
        /// The column.
        column: String,
        /// One option.
        first: &'static str,
        /// The other.
        second: &'static str,
    },
    /// An option whose value is not allowed.
    #[error("{option}: {given} must be {allowed}")]
    Option {
        /// The option.
        option: &'static str,
        /// What it says.
        given: String,
        /// What is allowed.
        allowed: &'static str,
    },
    /// The cells of the time column are no times.
    #[error("{place}: column {column} is '{value}': must be a time (ISO, local date and time, or a number)")]
    NoTime {
        /// Where.
        place: Place,
        /// The column.
        column: String,
        /// The cell.
        value: String,
    },
    /// Times that are in no order.
    #[error(
        "{place}: column {column} goes back {back} of {rows} times: it is no time, or rows of several records are mixed"
    )]
    Order {
        /// Where it first goes back.
        place: Place,
        /// The column.
        column: String,
        /// How often.
        back: usize,
        /// Number of rows.
        rows: usize,
    },
    /// A column without a single number.
    #[error("{place}: column {column} is '{value}', and none of its {rows} rows is a number")]
    NoNumbers {
        /// The first row.
        place: Place,
        /// The column.
        column: String,
        /// The first cell.
        value: String,
        /// Number of rows.
        rows: usize,
    },
    /// The manipulated variable never moves.
    #[error(
        "column {column} is {value} in all {rows} rows: the manipulated variable must move at least once"
    )]
    NoMovement {
        /// The column.
        column: String,
        /// Its value.
        value: f64,
        /// Number of rows.
        rows: usize,
    },
    /// Too few rows are left.
    #[error("{error}{}", dropped(*.left_out))]
    Record {
        /// Why.
        error: RecordError,
        /// Rows that were left out before.
        left_out: usize,
    },
}

/// What the operating system says, without its error number.
fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    text.split(" (os error").next().unwrap_or(&text).to_lowercase()
}

fn dropped(rows: usize) -> String {
    if rows == 0 { String::new() } else { format!(" ({rows} rows had to be left out)") }
}
