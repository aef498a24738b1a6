//! Text files: cells of the columns that are needed.

use super::column::{Column, Kind, Table, TextColumn};
use super::dialect::{Dialect, kind};
use super::reading::{Repair, RepairKind};
use super::rows::{Cell, Rows};

/// Reads the cells of the columns in `needed`, in their order.
pub(super) fn table(text: &[u8], dialect: &Dialect, needed: &[usize], repairs: &mut Vec<Repair>) -> Table {
    let (at, line) = dialect.data;
    let mut rows = Rows::from(text, dialect.delimiter, at, line);
    let mut cells: Vec<Cell> = Vec::new();
    let mut columns: Vec<TextColumn> = vec![TextColumn::default(); needed.len()];
    let mut lines = Vec::new();
    let (mut comments, mut empty, mut uneven) = (0, 0, 0);
    while let Some(line) = rows.next(&mut cells) {
        if cells.iter().all(|cell| cell.is_empty()) {
            empty += 1;
            continue;
        }
        let first = cells[0].of(text);
        if first.starts_with(b"#") && kind(&first) == Kind::Text {
            comments += 1;
            continue;
        }
        let filled = cells.iter().rposition(|cell| !cell.is_empty()).map_or(0, |last| last + 1);
        uneven += usize::from(filled > dialect.width || cells.len() + 1 < dialect.width);
        for (column, number) in columns.iter_mut().zip(needed) {
            match cells.get(*number) {
                Some(cell) => column.push(&cell.of(text)),
                None => column.push(&[]),
            }
        }
        lines.push(line);
    }
    let mut note = |kind: RepairKind, rows: usize, text: String| {
        if rows > 0 {
            repairs.push(Repair::new(kind, rows, text));
        }
    };
    let skipped = dialect.skipped;
    note(RepairKind::SkippedLines, skipped, format!("{skipped} lines before the data are not used"));
    note(RepairKind::CommentLines, comments, format!("{comments} comment lines are not used"));
    note(RepairKind::EmptyRows, empty, format!("{empty} rows without any value are left out"));
    let width = dialect.width;
    note(
        RepairKind::UnevenRows,
        uneven,
        format!(
            "{uneven} rows have other than {width} cells: cells that are absent count as empty, others are not used"
        ),
    );
    let rows = lines.len();
    let columns = needed.iter().copied().zip(columns.into_iter().map(Column::Text)).collect();
    Table { columns, lines, rows }
}
