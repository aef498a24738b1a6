//! Values of a column: numbers, and what stands where there is none.

use super::column::{Column, Table};
use super::encoding::readable;
use super::number::{DecimalMark, number};
use super::reading::{Repair, RepairKind};
use crate::model::text::one_line;

/// Words of a message: more are not listed.
const LISTED: usize = 4;

/// Different words that are counted apart.
const MOST_WORDS: usize = 32;

/// The numbers of a column, NaN where there is none.
#[derive(Debug, Clone)]
pub(super) struct Values {
    pub(super) numbers: Vec<f64>,
    /// Words that stand where there is no number, and how often.
    words: Vec<(String, usize)>,
    /// Cells in which nothing stands.
    empty: usize,
}

impl Values {
    /// The values of a column.
    pub(super) fn of(table: &Table, column: usize, mark: DecimalMark) -> Self {
        let mut found = Self { numbers: Vec::with_capacity(table.rows), words: Vec::new(), empty: 0 };
        match table.column(column) {
            Some(Column::Text(cells)) => {
                for cell in cells.cells() {
                    let value = number(cell, mark);
                    if value.is_none() {
                        found.count(cell);
                    }
                    found.numbers.push(value.unwrap_or(f64::NAN));
                }
            }
            Some(Column::Numbers(values)) => {
                let finite = |value: &f64| if value.is_finite() { *value } else { f64::NAN };
                found.numbers.extend(values.iter().map(finite));
                found.empty = found.numbers.iter().filter(|value| value.is_nan()).count();
            }
            Some(Column::Instants(..)) | None => found.numbers = vec![f64::NAN; table.rows],
        }
        found
    }

    fn count(&mut self, cell: &[u8]) {
        if cell.is_empty() {
            self.empty += 1;
            return;
        }
        let word = readable(cell);
        let known = self.words.iter().position(|(own, _)| *own == word);
        // The last place collects all words beyond.
        match known.or_else(|| (self.words.len() == MOST_WORDS).then_some(MOST_WORDS - 1)) {
            Some(place) => self.words[place].1 += 1,
            None => self.words.push((word, 1)),
        }
    }

    /// Whether there is no number at all.
    pub(super) fn all_missing(&self) -> bool {
        self.numbers.iter().all(|value| value.is_nan())
    }

    /// Whether nothing stands in more than a third of the cells where another column has a number.
    pub(super) fn is_sparse(&self, other: &Self) -> bool {
        let beside = other.numbers.iter().zip(&self.numbers).filter(|(other, _)| !other.is_nan());
        let (all, missing) =
            beside.fold((0, 0), |(all, missing), (_, own)| (all + 1, missing + usize::from(own.is_nan())));
        self.words.is_empty() && self.empty > 0 && missing * 3 > all
    }

    /// Leaves out the rows without a number.
    pub(super) fn leave_out(&self, name: &str, kept: &mut Vec<usize>, repairs: &mut Vec<Repair>) {
        let before = kept.len();
        kept.retain(|row| !self.numbers[*row].is_nan());
        let rows = before - kept.len();
        if rows > 0 {
            let text = format!("{rows} rows without a number in {name} are left out{}", self.what());
            repairs.push(Repair::new(RepairKind::NoValue, rows, text));
        }
    }

    /// What stands where there is no number.
    fn what(&self) -> String {
        let mut parts: Vec<String> = self
            .words
            .iter()
            .take(LISTED)
            .map(|(word, count)| format!("{count} '{}'", one_line(word)))
            .collect();
        if self.empty > 0 {
            parts.push(format!("{} empty", self.empty));
        }
        if parts.is_empty() { String::new() } else { format!(" (in the file: {})", parts.join(", ")) }
    }
}

/// Fills cells without a number by the number before in time, at the start by the first. Rows stand in the order of
/// the file; where the newest is first, the number before stands below.
pub(super) fn held(
    values: &mut Values,
    name: &str,
    kept: &[usize],
    newest_first: bool,
    repairs: &mut Vec<Repair>,
) {
    let missing = kept.iter().filter(|row| values.numbers[**row].is_nan()).count();
    if newest_first {
        values.numbers.reverse();
    }
    let mut last = values.numbers.iter().copied().find(|value| !value.is_nan()).unwrap_or(f64::NAN);
    for value in &mut values.numbers {
        if value.is_nan() {
            *value = last;
        } else {
            last = *value;
        }
    }
    if newest_first {
        values.numbers.reverse();
    }
    if missing > 0 {
        let text =
            format!("{missing} cells of {name} without a number hold the number before{}", values.what());
        repairs.push(Repair::new(RepairKind::HeldValues, missing, text));
    }
}

/// Leaves out the rows that a quality column marks as bad. Words are understood, and numbers as OPC has them (192 good,
/// 64 uncertain, 0 bad) where one of them is at least 64; flags of another meaning are not used.
pub(super) fn quality(
    table: &Table,
    column: usize,
    name: &str,
    kept: &mut Vec<usize>,
    repairs: &mut Vec<Repair>,
) {
    const BAD: [&str; 7] = ["bad", "invalid", "fail", "error", "no data", "comm", "offline"];
    let before = kept.len();
    match table.column(column) {
        Some(Column::Text(cells)) => {
            let codes: Vec<f64> =
                cells.cells().map(|cell| number(cell, DecimalMark::Point).unwrap_or(f64::NAN)).collect();
            let opc = codes.iter().any(|code| *code >= 64.0);
            let bad = |row: &usize| {
                let word = readable(cells.cell(*row)).to_lowercase();
                BAD.iter().any(|bad| word.starts_with(bad)) || (opc && codes[*row] < 64.0)
            };
            kept.retain(|row| !bad(row));
        }
        Some(Column::Numbers(codes)) if codes.iter().any(|code| *code >= 64.0) => {
            kept.retain(|row| codes[*row].is_nan() || codes[*row] >= 64.0);
        }
        _ => {}
    }
    let rows = before - kept.len();
    if rows > 0 {
        let text = format!("{rows} rows that {name} marks as bad are left out");
        repairs.push(Repair::new(RepairKind::BadQuality, rows, text));
    }
}
