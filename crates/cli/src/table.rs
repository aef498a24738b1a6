//! Tables and numbers for reading.

use crate::console::Console;

/// Least width to which the first column is folded before the table is split.
const LEAST_NAME: usize = 24;

/// Space between columns.
const GAP: usize = 2;

/// Rows under a heading, fitted to the console. Columns of numbers stand right; a table that is too wide is
/// continued below with its first column repeated, and text that is too wide alone is folded.
pub(crate) fn table(console: Console, heading: &[&str], rows: &[Vec<String>]) -> String {
    let cell = |row: &Vec<String>, column: usize| row.get(column).cloned().unwrap_or_default();
    let natural: Vec<usize> = (0..heading.len())
        .map(|column| {
            let cells = rows.iter().map(|row| width(&cell(row, column)));
            cells.chain([width(heading[column])]).max().unwrap_or(0)
        })
        .collect();
    let others: usize = natural.iter().skip(1).map(|width| width + GAP).sum();
    let room = console.width.saturating_sub(others).max(LEAST_NAME);
    let name = natural.first().copied().unwrap_or(0).min(room);
    let last = console.width.saturating_sub(name + GAP).max(1);
    let mut text = String::new();
    let mut next = 1;
    while next < heading.len() {
        let (first, mut used) = (next, name);
        while next < heading.len() && (used + GAP + natural[next] <= console.width || next == first) {
            used += GAP + natural[next];
            next += 1;
        }
        let columns: Vec<usize> = std::iter::once(0).chain(first..next).collect();
        let widths: Vec<usize> = columns
            .iter()
            .map(|&column| if column == 0 { name } else { natural[column].min(last) })
            .collect();
        let right: Vec<bool> = columns.iter().map(|&column| column > 0 && is_numeric(rows, column)).collect();
        if !text.is_empty() {
            text.push('\n');
        }
        let titles: Vec<String> = columns.iter().map(|&column| heading[column].to_owned()).collect();
        push_row(&mut text, &titles, &widths, &right);
        text.push_str(&"─".repeat(widths.iter().sum::<usize>() + GAP * (widths.len() - 1)));
        text.push('\n');
        for row in rows {
            let cells: Vec<String> = columns.iter().map(|&column| cell(row, column)).collect();
            push_row(&mut text, &cells, &widths, &right);
        }
    }
    text
}

/// Whether a column holds numbers, or marks that stand for one.
fn is_numeric(rows: &[Vec<String>], column: usize) -> bool {
    let number = |cell: &String| cell.starts_with(|c: char| c.is_ascii_digit() || "–-∞<…".contains(c));
    let verdict = |cell: &String| ["yes", "no", "unstable", "unst."].contains(&cell.as_str());
    rows.iter().filter_map(|row| row.get(column)).all(|cell| number(cell) || verdict(cell))
}

fn push_row(text: &mut String, cells: &[String], widths: &[usize], right: &[bool]) {
    let folded: Vec<Vec<String>> = cells.iter().zip(widths).map(|(cell, width)| fold(cell, *width)).collect();
    for line in 0..folded.iter().map(Vec::len).max().unwrap_or(0) {
        let mut row = String::new();
        for ((lines, room), right) in folded.iter().zip(widths).zip(right) {
            let part = lines.get(line).map_or("", String::as_str);
            let blank = " ".repeat(room.saturating_sub(width(part)));
            row.push_str(&if *right { blank + part } else { part.to_owned() + &blank });
            row.push_str(&" ".repeat(GAP));
        }
        text.push_str(row.trim_end());
        text.push('\n');
    }
}

/// A text in lines of at most so many columns, broken between words where there is a place.
pub(crate) fn fold(text: &str, room: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    let indent = &text[..text.len() - text.trim_start().len()];
    for (index, word) in text.split_whitespace().enumerate() {
        let line = lines.last().map_or(0, |line| width(line));
        let mut word = if index == 0 { format!("{indent}{word}") } else { word.to_owned() };
        if line > 0 && line + 1 + width(&word) > room {
            lines.push(String::new());
        } else if line > 0 {
            word.insert(0, ' ');
        }
        for character in word.chars() {
            if lines.last().is_some_and(|line| width(line) >= room.max(1)) {
                lines.push(String::new());
            }
            if let Some(line) = lines.last_mut() {
                line.push(character);
            }
        }
    }
    lines
}

/// Columns that a text takes.
fn width(text: &str) -> usize {
    text.chars().count()
}

/// A number for reading: four significant digits, `–` where there is none.
pub(crate) fn number(value: impl Into<Option<f64>>) -> String {
    let Some(value) = value.into() else { return "–".to_owned() };
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return if value.is_nan() { "–" } else { "∞" }.to_owned();
    }
    // The exponent after rounding: 999.96 is 1000, one digit longer.
    let scientific = format!("{value:.3e}");
    let exponent: i32 = scientific.split('e').nth(1).and_then(|text| text.parse().ok()).unwrap_or(0);
    if !(-4..7).contains(&exponent) {
        return scientific;
    }
    let decimals = usize::try_from(3 - exponent).unwrap_or(0);
    format!("{value:.decimals$}")
}

/// A ratio as a percentage for reading.
pub(crate) fn percent(value: impl Into<Option<f64>>) -> String {
    match value.into() {
        Some(ratio) if ratio > 0.0 && ratio < 1e-4 => "<0.01".to_owned(),
        ratio => number(ratio.map(|ratio| 100.0 * ratio)),
    }
}

/// A section's title, underlined in a terminal that has colours.
pub(crate) fn title(console: Console, text: &str) -> String {
    if console.colour { format!("\u{1b}[1m{text}\u{1b}[0m\n") } else { format!("{text}\n") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_four_digits_whatever_their_size() {
        for (value, text) in [
            (3.853_94, "3.854"),
            (0.000_123_456, "0.0001235"),
            (4351.4, "4351"),
            (999.96, "1000"),
            (67.861, "67.86"),
            (1.2e9, "1.200e9"),
            (-0.5, "-0.5000"),
            (0.0, "0"),
            (f64::INFINITY, "∞"),
            (123_456.0, "123456"),
        ] {
            assert_eq!(number(value), text);
        }
        assert_eq!(number(None), "–");
    }

    #[test]
    fn a_table_fits_its_console() {
        let console = Console { json: false, width: 40, colour: false };
        let long = "a name that is much longer than the console is wide".to_owned();
        let rows = vec![[vec![long], vec!["1.0".to_owned(); 9]].concat()];
        let heading = ["controller", "IAE", "ISE", "ITAE", "energy", "rise", "peak", "a", "b", "c"];
        let text = table(console, &heading, &rows);
        assert!(text.lines().all(|line| line.chars().count() <= 40), "{text}");
        assert!(text.matches("controller").count() > 1);
    }
}
