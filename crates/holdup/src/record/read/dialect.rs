//! How a text file is laid out: delimiter, heading, units, first row of data.
//!
//! Decided from the first rows. What the cells look like in the second half of them, which is data in any file with
//! a sensible head, says what a row of data is; the first such row ends the head.

use super::civil::stamp;
use super::clock::dated;
use super::column::{Heading, Kind};
use super::encoding::readable;
use super::error::ReadError;
use super::names::{meanings, says_time};
use super::number::{DecimalMark, number, plausible};
use super::rows::{Cell, Delimiter, Rows};
use crate::model::text::one_line;

/// Bytes and rows of the sample.
const SAMPLE: usize = 256 << 10;
const SAMPLE_ROWS: usize = 400;

/// Delimiters in the order of preference among equals.
const DELIMITERS: [Delimiter; 5] = [
    Delimiter::Byte(b'\t'),
    Delimiter::Byte(b';'),
    Delimiter::Byte(b','),
    Delimiter::Byte(b'|'),
    Delimiter::Blank,
];

/// Words that stand for no value, in small letters.
const NO_VALUE: [&str; 24] = [
    "null",
    "nan",
    "na",
    "n/a",
    "#n/a",
    "none",
    "nil",
    "bad",
    "bad input",
    "no data",
    "no good data",
    "no value",
    "i/o timeout",
    "pt created",
    "-",
    "--",
    "---",
    "?",
    "#value!",
    "#div/0!",
    "comm fail",
    "shutdown",
    "error",
    "invalid",
];

/// Units that stand in a row of their own, in small letters.
const UNITS: [&str; 42] = [
    "%", "pct", "percent", "s", "sec", "ms", "min", "h", "m", "mm", "cm", "m3", "m³", "l", "kg", "t", "bar",
    "barg", "mbar", "pa", "kpa", "mpa", "psi", "psig", "°c", "degc", "c", "°f", "degf", "f", "k", "m3/h",
    "m³/h", "kg/h", "t/h", "l/min", "gpm", "v", "ma", "rpm", "hz", "-",
];

/// How a text file is laid out.
#[derive(Debug)]
pub(super) struct Dialect {
    pub(super) delimiter: Delimiter,
    pub(super) headings: Vec<Heading>,
    /// Line of the heading, from 1.
    pub(super) heading_line: Option<usize>,
    /// Byte and line of the first row of data.
    pub(super) data: (usize, usize),
    /// Lines before the data that are neither heading nor units.
    pub(super) skipped: usize,
    /// Usual number of cells in a row.
    pub(super) width: usize,
}

/// A row of the sample.
struct Sampled {
    line: usize,
    place: (usize, usize),
    cells: Vec<Vec<u8>>,
    kinds: Vec<Kind>,
}

/// Finds the layout of a text.
pub(super) fn dialect(text: &[u8]) -> Result<Dialect, ReadError> {
    let sample = sample_of(text);
    let mut best: Option<(f64, Delimiter, Vec<Sampled>)> = None;
    for delimiter in DELIMITERS {
        let rows = sampled(sample, delimiter);
        let score = score(&rows) * unity(&rows, delimiter);
        if score > best.as_ref().map_or(0.0, |(most, ..)| *most) {
            best = Some((score, delimiter, rows));
        }
    }
    let no_table = || {
        let first = sample.split(|byte| matches!(byte, b'\n' | b'\r')).find(|line| !line.is_empty());
        ReadError::NoTable { first: one_line(&readable(first.unwrap_or_default())) }
    };
    let (_, delimiter, rows) = best.ok_or_else(no_table)?;
    let width = usual_width(second_half(&rows)).ok_or_else(no_table)?;
    let kinds = column_kinds(&rows, width);
    let first = rows.iter().position(|row| is_data(row, &kinds, width)).ok_or_else(no_table)?;
    let head = &rows[..first];
    let heading = heading_row(head, width);
    let units = heading.and_then(|index| head.get(index + 1)).filter(|row| is_units(row));
    let used = usize::from(heading.is_some()) + usize::from(units.is_some());
    let empty = Vec::new();
    let mut names: Vec<Vec<u8>> = heading
        .map_or(&empty, |index| &head[index].cells)
        .iter()
        .map(|cell| cell.trim_ascii().to_vec())
        .collect();
    if let Some(first) = names.first_mut() {
        while first.first().is_some_and(|byte| matches!(byte, b'#' | b'%' | b'/' | b' ')) && first.len() > 1 {
            first.remove(0);
        }
    }
    // Blanks part a date from its time of day, but not their common name.
    let pair = kinds.windows(2).position(|pair| pair == [Kind::Date, Kind::Clock]);
    if let Some(place) = pair.filter(|_| delimiter == Delimiter::Blank && names.len() + 1 == kinds.len()) {
        names.insert(place.min(names.len()), b"date".to_vec());
    }
    let unit_of = |column: usize| units.and_then(|row| row.cells.get(column)).map(|cell| readable(cell));
    let headings = (0..kinds.len())
        .map(|column| {
            let full = names.get(column).map(|name| readable(name)).unwrap_or_default();
            let full = if heading.is_none() { format!("col{}", column + 1) } else { full };
            let mut own = split_unit(&full);
            own.unit =
                own.unit.or_else(|| unit_of(column).filter(|unit| !unit.is_empty()).map(|unit| bare(&unit)));
            Heading { kind: kinds[column], rises: rises(&rows[first..], column), ..own }
        })
        .collect();
    Ok(Dialect {
        delimiter,
        headings,
        heading_line: heading.map(|index| head[index].line),
        data: rows[first].place,
        skipped: head.len() - used,
        width,
    })
}

/// Whole lines from the start.
fn sample_of(text: &[u8]) -> &[u8] {
    if text.len() <= SAMPLE {
        return text;
    }
    let end = text[..SAMPLE].iter().rposition(|byte| matches!(byte, b'\n' | b'\r'));
    &text[..end.map_or(SAMPLE, |end| end + 1)]
}

fn sampled(sample: &[u8], delimiter: Delimiter) -> Vec<Sampled> {
    let mut rows = Rows::new(sample, delimiter);
    let mut cells: Vec<Cell> = Vec::new();
    let mut found = Vec::new();
    while found.len() < SAMPLE_ROWS {
        let place = rows.place();
        let Some(line) = rows.next(&mut cells) else { break };
        // Blank lines before the row belong to it; that moves its start, not its content.
        let cells: Vec<Vec<u8>> = cells.iter().map(|cell| cell.of(sample).into_owned()).collect();
        let kinds = cells.iter().map(|cell| kind(cell)).collect();
        found.push(Sampled { line, place, cells, kinds });
    }
    found
}

/// What a cell looks like.
pub(super) fn kind(cell: &[u8]) -> Kind {
    let cell = cell.trim_ascii();
    if cell.is_empty() || stands_for_nothing(cell) {
        return Kind::Missing;
    }
    match stamp(cell).filter(|_| dated(cell)) {
        Some(stamp) if stamp.date.is_none() => Kind::Clock,
        Some(stamp) if stamp.clock.is_none() => Kind::Date,
        Some(_) => Kind::Instant,
        None if plausible(cell) => Kind::Number,
        None => Kind::Text,
    }
}

/// Whether a word stands for no value; historians also write an error code in brackets before it.
fn stands_for_nothing(cell: &[u8]) -> bool {
    let known = |word: &str| cell.eq_ignore_ascii_case(word.as_bytes());
    NO_VALUE.iter().any(|word| known(word)) || cell.starts_with(b"[-")
}

fn second_half(rows: &[Sampled]) -> &[Sampled] {
    &rows[rows.len() / 2..]
}

/// The most frequent number of cells, at least two.
fn usual_width(rows: &[Sampled]) -> Option<usize> {
    let mut widths: Vec<usize> = rows.iter().map(|row| row.cells.len()).filter(|width| *width > 1).collect();
    widths.sort_unstable();
    let runs = widths.chunk_by(|a, b| a == b).max_by_key(|run| run.len())?;
    runs.first().copied()
}

/// The mean over rows of the share of cells that are numbers, times or missing values, under one delimiter; 0 where no row
/// has two. A row of another width than usual has none.
fn score(rows: &[Sampled]) -> f64 {
    let half = second_half(rows);
    let Some(width) = usual_width(half) else { return 0.0 };
    let (mut sum, mut strict) = (0.0, false);
    for row in half.iter().filter(|row| row.cells.len() == width) {
        let typed = row.kinds.iter().filter(|kind| **kind != Kind::Text).count();
        strict |= row.kinds.iter().any(|kind| !matches!(kind, Kind::Text | Kind::Missing));
        #[expect(clippy::cast_precision_loss, reason = "a number of cells")]
        let share = typed as f64 / width as f64;
        sum += share;
    }
    #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
    let rows = half.len() as f64;
    if strict { sum / rows } else { 0.0 }
}

/// A tenth where most rows have a delimiter that is more likely one inside a text: then this delimiter cuts
/// `31.01.2024 1:05:00 PM;LIC205.PV;50,1` into a date, a time of day and one text. Else 1.
fn unity(rows: &[Sampled], delimiter: Delimiter) -> f64 {
    let before = DELIMITERS.iter().take_while(|other| **other != delimiter);
    let likelier: Vec<u8> = before
        .filter_map(|other| match other {
            Delimiter::Byte(byte) => Some(*byte),
            Delimiter::Blank => None,
        })
        .collect();
    let half = second_half(rows);
    let cut = |row: &&Sampled| {
        let mut texts = row.cells.iter().zip(&row.kinds).filter(|(_, kind)| **kind == Kind::Text);
        texts.any(|(cell, _)| cell.iter().any(|byte| likelier.contains(byte)))
    };
    if half.iter().filter(cut).count() * 2 > half.len() { 0.1 } else { 1.0 }
}

/// What most cells of each column look like.
fn column_kinds(rows: &[Sampled], width: usize) -> Vec<Kind> {
    let usual: Vec<&Sampled> = second_half(rows).iter().filter(|row| row.cells.len() == width).collect();
    (0..width)
        .map(|column| {
            let count = |kind: Kind| usual.iter().filter(|row| row.kinds[column] == kind).count();
            [Kind::Number, Kind::Instant, Kind::Date, Kind::Clock, Kind::Text]
                .into_iter()
                .max_by_key(|kind| (count(*kind), *kind != Kind::Text))
                .filter(|kind| count(*kind) > 0)
                .unwrap_or(Kind::Missing)
        })
        .collect()
}

/// Whether a row looks like the data: at least one value, and hardly a word where values stand.
fn is_data(row: &Sampled, kinds: &[Kind], width: usize) -> bool {
    if row.cells.len().abs_diff(width) > 1 {
        return false;
    }
    let pairs =
        || row.kinds.iter().zip(kinds).filter(|(_, usual)| !matches!(usual, Kind::Text | Kind::Missing));
    let alike = pairs().filter(|(own, usual)| own == usual).count();
    let other = pairs().filter(|(own, usual)| own != usual && **own != Kind::Missing).count();
    // A timestamp where timestamps stand makes data of a row whose values are words, such as a mode's.
    let dated = |(own, usual): (&Kind, &Kind)| own == usual && *usual == Kind::Instant;
    alike > other || (row.cells.len() == width && pairs().any(dated))
}

/// The row of the head that names the columns: the one with most names that are understood, else the first.
fn heading_row(head: &[Sampled], width: usize) -> Option<usize> {
    let understood = |row: &Sampled| {
        let names = row.cells.iter().map(|cell| split_unit(&readable(cell)).name);
        names.filter(|name| !meanings(name).is_empty() || says_time(name) > 1).count()
    };
    let named = |row: &Sampled| {
        let filled = row.kinds.iter().filter(|kind| **kind != Kind::Missing).count();
        let texts = row.kinds.iter().filter(|kind| **kind == Kind::Text).count();
        row.cells.len().abs_diff(width) <= 1 && texts * 2 >= filled && texts > 0
    };
    let comment = |row: &Sampled| row.cells.first().is_some_and(|cell| cell.starts_with(b"#"));
    let candidates = head.iter().enumerate().filter(|(_, row)| named(row));
    candidates
        .max_by_key(|(index, row)| (understood(row), !comment(row), std::cmp::Reverse(*index)))
        .map(|(index, _)| index)
}

fn is_units(row: &Sampled) -> bool {
    let filled: Vec<String> = row
        .cells
        .iter()
        .map(|cell| bare(&readable(cell)).to_lowercase())
        .filter(|cell| !cell.is_empty())
        .collect();
    let known = filled.iter().filter(|cell| UNITS.contains(&cell.as_str())).count();
    known > 0 && known * 2 >= filled.len()
}

/// A unit without its brackets.
fn bare(unit: &str) -> String {
    unit.trim().trim_matches(['[', ']', '(', ')', '{', '}']).trim().to_owned()
}

/// A heading whose unit stands behind it in brackets.
pub(super) fn split_unit(full: &str) -> Heading {
    let full = full.split_whitespace().collect::<Vec<_>>().join(" ");
    let brackets = [('[', ']'), ('(', ')'), ('{', '}')];
    let part = brackets.iter().find_map(|(open, close)| {
        let (name, unit) = full.strip_suffix(*close)?.rsplit_once(*open)?;
        (!name.trim().is_empty()).then(|| (name.trim().to_owned(), bare(unit)))
    });
    let (name, unit) = part.map_or_else(|| (full.clone(), None), |(name, unit)| (name, Some(unit)));
    let unit = unit.filter(|unit| !unit.is_empty());
    let unit = unit.or_else(|| (says_time(&name) == 3).then(|| super::names::words(&name).pop()).flatten());
    let unit = unit.filter(|unit| says_time(&name) < 2 || super::clock::unit_seconds(unit).is_some());
    Heading { name, full, unit, kind: Kind::Missing, rises: false }
}

fn rises(rows: &[Sampled], column: usize) -> bool {
    let value = |row: &Sampled| row.cells.get(column).and_then(|cell| number(cell, DecimalMark::Point));
    let values: Vec<f64> = rows.iter().filter_map(value).collect();
    values.len() > 1 && values.windows(2).all(|pair| pair[1] > pair[0])
}
