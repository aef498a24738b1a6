//! Tables and numbers for reading.

use comfy_table::{Cell, CellAlignment, ContentArrangement, Table, presets};

use crate::console::Console;

/// Rows under a heading, fitted to the console: the first column is text, the others numbers.
pub(crate) fn table(console: Console, heading: &[&str], rows: &[Vec<String>]) -> String {
    let mut table = Table::new();
    table.load_style(presets::UTF8_HORIZONTAL_ONLY);
    table.set_content_arrangement(ContentArrangement::Dynamic);
    table.set_width(u16::try_from(console.width).unwrap_or(u16::MAX));
    let aligned = |index: usize, text: &str| {
        let side = if index == 0 { CellAlignment::Left } else { CellAlignment::Right };
        Cell::new(text).set_alignment(side)
    };
    let row = |cells: &mut dyn Iterator<Item = &str>| {
        cells.enumerate().map(|(index, text)| aligned(index, text)).collect::<Vec<_>>()
    };
    table.set_header(row(&mut heading.iter().copied()));
    for cells in rows {
        table.add_row(row(&mut cells.iter().map(String::as_str)));
    }
    table.trim_fmt() + "\n"
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
    number(value.into().map(|ratio| 100.0 * ratio))
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
        let rows =
            vec![vec!["a name that is much longer than the console is wide".to_owned(), "1.0".to_owned()]];
        assert!(table(console, &["controller", "IAE"], &rows).lines().all(|line| line.chars().count() <= 40));
    }
}
