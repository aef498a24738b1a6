//! Exports with one row a reading: time, tag, value, and often how good it is.
//!
//! Historians write so (PI, AspenTech, Ignition) because each tag has times of its own. The tags take the place of the
//! columns: their names say the roles by the same rules. The times of the controlled variable become the rows; what
//! the other tags last had is held there.

use super::ReadOptions;
use super::assemble::File;
use super::clock::{Times, combined, times};
use super::column::{Column, Heading, Kind, Table};
use super::dialect::kind;
use super::encoding::readable;
use super::error::ReadError;
use super::names::{Role, meanings, says_quality, says_time, words};
use super::pivot::{Readings, put_together};
use super::reading::{Repair, RepairKind, counted};
use super::roles::{TimeColumn, find_time, of_tags};
use super::values::quality;
use crate::model::text::one_line;

/// Names of the column that says which tag a reading is of.
const TAG: [&str; 16] = [
    "tag",
    "tagname",
    "tag name",
    "tag id",
    "tagid",
    "tagpath",
    "tag path",
    "point",
    "pointname",
    "point name",
    "point id",
    "name",
    "item",
    "item id",
    "itemid",
    "messstelle",
];

/// Names of the column that holds the readings.
const VALUE: [&str; 6] = ["value", "val", "reading", "wert", "messwert", "result"];

/// Cells of a tag that say what kind its readings are.
const SAMPLE: usize = 200;

/// Different tags that are told apart: more are no tags but texts.
const MOST_TAGS: usize = 20_000;

/// Where time, tag, value and state of a reading stand.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Layout {
    time: TimeColumn,
    tag: usize,
    value: usize,
    quality: Vec<usize>,
}

impl Layout {
    /// The layout, where the headings are those of such an export: a column named as a tag's, one named as a value, a
    /// time, and no controlled and manipulated variable beside them.
    /// An option that names a column says that the file is not one.
    pub(super) fn of(
        headings: &[Heading],
        options: &ReadOptions,
        repairs: &mut Vec<Repair>,
    ) -> Result<Option<Self>, ReadError> {
        let named = |names: &[&str], column: &usize| {
            let own = words(&headings[*column].name).join(" ");
            names.contains(&own.as_str())
        };
        let timed = |column: &usize| {
            let heading = &headings[*column];
            matches!(heading.kind, Kind::Instant | Kind::Date | Kind::Clock) || says_time(&heading.name) == 3
        };
        let only = |names: &[&str]| {
            let mut found = (0..headings.len()).filter(|column| !timed(column) && named(names, column));
            found.next().filter(|_| found.next().is_none())
        };
        let (Some(tag), Some(value)) = (only(&TAG), only(&VALUE)) else { return Ok(None) };
        let clear = |role: Role| {
            let other = (0..headings.len()).filter(|column| *column != tag && *column != value);
            other.flat_map(|column| meanings(&headings[column].name)).any(|of| of.role == role && of.rank < 2)
        };
        let names_column = |given: &Option<String>| {
            let wanted = given.as_ref().map(|given| given.trim().to_lowercase());
            wanted.is_some_and(|wanted| headings.iter().any(|own| own.name.to_lowercase() == wanted))
        };
        if names_column(&options.controlled_variable) || names_column(&options.manipulated_variable) {
            return Ok(None);
        }
        if clear(Role::Controlled) && clear(Role::Manipulated) || !(0..headings.len()).any(|n| timed(&n)) {
            return Ok(None);
        }
        let time = find_time(headings, &[tag, value], options, repairs)?;
        let taken = [time.columns(), vec![tag, value]].concat();
        let quality = (0..headings.len())
            .filter(|column| !taken.contains(column) && says_quality(&headings[*column].name))
            .collect();
        Ok(Some(Self { time, tag, value, quality }))
    }

    /// All columns that must be read.
    pub(super) fn needed(&self) -> Vec<usize> {
        let mut all = [self.time.columns(), vec![self.tag, self.value], self.quality.clone()].concat();
        all.sort_unstable();
        all
    }

    /// The readings put together to rows; `table` has the needed columns, `file` the rest.
    pub(super) fn file(
        &self,
        about: &About,
        headings: &[Heading],
        table: &Table,
        options: &ReadOptions,
        repairs: &mut Vec<Repair>,
    ) -> Result<File, ReadError> {
        let times = self.times(headings, table, options)?;
        repairs.extend(times.assumed.iter().cloned());
        let mut kept: Vec<usize> = (0..table.rows).filter(|row| times.instants[*row].is_some()).collect();
        self.undated(headings, table, &kept, repairs)?;
        for &column in &self.quality {
            quality(table, column, &one_line(&headings[column].name), &mut kept, repairs);
        }
        let (tags, of_row) = self.tags(table, &mut kept, repairs)?;
        let time_name = headings[self.time.columns().last().copied().unwrap_or(0)].clone();
        let own: Vec<Heading> = tags.iter().map(|tag| self.heading(tag, table)).collect();
        let all: Vec<Heading> = std::iter::once(time_name).chain(own).collect();
        let roles = of_tags(&all, options, repairs)?;
        let readings = Readings { table, value: self.value, times: &times, kept: &kept, of_row: &of_row };
        let (wide, instants) = put_together(&readings, &all, &roles, repairs)?;
        let Times { format, .. } = times;
        Ok(File {
            format: about.format,
            layout: "readings",
            encoding: about.encoding,
            delimiter: about.delimiter,
            heading_line: about.heading_line,
            headings: all,
            roles,
            table: wide,
            times: Some(Times { instants, format, assumed: Vec::new() }),
            rows: table.rows,
        })
    }

    fn times(&self, headings: &[Heading], table: &Table, options: &ReadOptions) -> Result<Times, ReadError> {
        let cells = |column: usize| table.column(column).ok_or(ReadError::Empty);
        match self.time {
            TimeColumn::One(column) => Ok(times(cells(column)?, headings[column].unit.as_deref(), options)),
            TimeColumn::Two(date, clock) => Ok(combined(cells(date)?, cells(clock)?, table.rows, options)),
            TimeColumn::None => Err(ReadError::Empty),
        }
    }

    /// Readings without a readable time: left out, unless most are.
    fn undated(
        &self,
        headings: &[Heading],
        table: &Table,
        kept: &[usize],
        repairs: &mut Vec<Repair>,
    ) -> Result<(), ReadError> {
        let bad = table.rows - kept.len();
        if bad == 0 {
            return Ok(());
        }
        let row = kept.iter().enumerate().find(|(k, row)| k != *row).map_or(kept.len(), |(k, _)| k);
        let column = self.time.columns().first().copied().unwrap_or(0);
        let (place, value) = (table.place(row), table.text(column, row));
        if bad * 2 > table.rows {
            return Err(ReadError::NoTime { place, column: one_line(&headings[column].name), value });
        }
        let text =
            format!("{} without a readable time left out: first {place}, '{value}'", counted(bad, "row"));
        repairs.push(Repair::new(RepairKind::NoTime, bad, text));
        Ok(())
    }

    /// The tags in the order in which they appear, and the tag of each row. Rows without a tag are left out.
    fn tags(
        &self,
        table: &Table,
        kept: &mut Vec<usize>,
        repairs: &mut Vec<Repair>,
    ) -> Result<(Vec<Tag>, Vec<usize>), ReadError> {
        let mut tags: Vec<Tag> = Vec::new();
        let mut known: std::collections::HashMap<Vec<u8>, usize> = std::collections::HashMap::new();
        let mut of_row = vec![usize::MAX; table.rows];
        let before = kept.len();
        for &row in kept.iter() {
            let name = match table.column(self.tag) {
                Some(Column::Text(cells)) => cells.cell(row).trim_ascii().to_vec(),
                _ => table.text(self.tag, row).into_bytes(),
            };
            if name.is_empty() || name == b"NaN" {
                continue;
            }
            let tag = *known.entry(name).or_insert_with_key(|name| {
                tags.push(Tag { name: readable(name), rows: Vec::new() });
                tags.len() - 1
            });
            if tags.len() > MOST_TAGS {
                let allowed = "a file of at most 20000 tags; export the tags of one loop";
                return Err(ReadError::Option { option: "tags", given: format!("{}", tags.len()), allowed });
            }
            of_row[row] = tag;
            tags[tag].rows.push(row);
        }
        kept.retain(|row| of_row[*row] != usize::MAX);
        let left_out = before - kept.len();
        if left_out > 0 {
            let text = format!("{} without a tag left out", counted(left_out, "row"));
            repairs.push(Repair::new(RepairKind::NoValue, left_out, text));
        }
        Ok((tags, of_row))
    }

    /// A tag as the heading of a column.
    fn heading(&self, tag: &Tag, table: &Table) -> Heading {
        let number = |row: &&usize| match table.column(self.value) {
            Some(Column::Text(cells)) => kind(cells.cell(**row)) == Kind::Number,
            Some(Column::Numbers(values)) => values[**row].is_finite(),
            _ => false,
        };
        let text = |row: &&usize| match table.column(self.value) {
            Some(Column::Text(cells)) => !matches!(kind(cells.cell(**row)), Kind::Number | Kind::Missing),
            _ => false,
        };
        let sample = || tag.rows.iter().take(SAMPLE);
        let (numbers, texts) = (sample().filter(number).count(), sample().filter(text).count());
        let kind = match (numbers, texts) {
            (0, 0) => Kind::Missing,
            (numbers, texts) if numbers >= texts => Kind::Number,
            _ => Kind::Text,
        };
        Heading { name: tag.name.clone(), full: tag.name.clone(), unit: None, kind, rises: false }
    }
}

/// A tag and its rows in the order of the file.
struct Tag {
    name: String,
    rows: Vec<usize>,
}

/// What is known of the file beside its cells.
pub(super) struct About {
    pub(super) format: &'static str,
    pub(super) encoding: Option<&'static str>,
    pub(super) delimiter: Option<&'static str>,
    pub(super) heading_line: Option<usize>,
}
