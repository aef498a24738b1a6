//! The cells of one column, as the file has them.

use super::civil::iso;
use super::encoding::readable;
use crate::model::text::one_line;

/// Text cells, one after the other in one buffer.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct TextColumn {
    bytes: Vec<u8>,
    ends: Vec<usize>,
}

impl TextColumn {
    /// Adds a cell.
    pub(super) fn push(&mut self, cell: &[u8]) {
        self.bytes.extend_from_slice(cell);
        self.ends.push(self.bytes.len());
    }

    /// The cell of a row, empty where there is none.
    pub(super) fn cell(&self, row: usize) -> &[u8] {
        let Some(&end) = self.ends.get(row) else { return &[] };
        let start = if row == 0 { 0 } else { self.ends[row - 1] };
        &self.bytes[start..end]
    }

    /// All cells.
    pub(super) fn cells(&self) -> impl Iterator<Item = &[u8]> {
        (0..self.ends.len()).map(|row| self.cell(row))
    }

    /// Whether any cell has this byte.
    pub(super) fn has(&self, byte: u8) -> bool {
        self.bytes.contains(&byte)
    }
}

/// A column as its file gives it: text files give text, Parquet files also values.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Column {
    /// Cells of text.
    Text(TextColumn),
    /// Numbers, NaN where there is none.
    Numbers(Vec<f64>),
    /// Instants [ns] since 1970-01-01T00:00, and whether that is UTC.
    #[cfg_attr(not(feature = "parquet"), expect(dead_code, reason = "only Parquet files have instants"))]
    Instants(Vec<Option<i64>>, bool),
}

/// What a cell looks like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Nothing, or a word that stands for no value.
    Missing,
    /// A number.
    Number,
    /// Date and time of day.
    Instant,
    /// A date alone.
    Date,
    /// A time of day alone.
    Clock,
    /// Other text.
    Text,
}

/// A column before its cells are read.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Heading {
    /// Its name, without unit.
    pub(super) name: String,
    /// Its name as the file has it.
    pub(super) full: String,
    /// The unit that stands with the name or below it.
    pub(super) unit: Option<String>,
    /// What most of its first cells look like.
    pub(super) kind: Kind,
    /// Whether its first cells are numbers that rise.
    pub(super) rises: bool,
}

/// The columns that a record needs, and the line of each row where the file has lines.
#[derive(Debug, Default)]
pub(super) struct Table {
    /// Column number, from 0, and cells.
    pub(super) columns: Vec<(usize, Column)>,
    /// Line of each row, from 1; empty where the file has no lines.
    pub(super) lines: Vec<usize>,
    /// Number of rows.
    pub(super) rows: usize,
}

impl Table {
    /// The cells of a column.
    pub(super) fn column(&self, number: usize) -> Option<&Column> {
        self.columns.iter().find(|(own, _)| *own == number).map(|(_, column)| column)
    }

    /// A cell for people, in one line.
    pub(super) fn text(&self, column: usize, row: usize) -> String {
        match self.column(column) {
            Some(Column::Text(cells)) => one_line(&readable(cells.cell(row))),
            Some(Column::Numbers(values)) => values.get(row).map_or_else(String::new, f64::to_string),
            Some(Column::Instants(instants, _)) => {
                instants.get(row).copied().flatten().map_or_else(|| "null".to_owned(), iso)
            }
            None => String::new(),
        }
    }

    /// Where a row stands: its line, or its number where the file has no lines.
    pub(super) fn place(&self, row: usize) -> Place {
        self.lines.get(row).map_or(Place::Row(row + 1), |&line| Place::Line(line))
    }
}

/// Where something stands in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// A line of a text file, from 1.
    Line(usize),
    /// A row of a Parquet file, from 1.
    Row(usize),
}

impl std::fmt::Display for Place {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Line(line) => write!(out, "line {line}"),
            Self::Row(row) => write!(out, "row {row}"),
        }
    }
}
