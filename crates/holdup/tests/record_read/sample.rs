//! One record, and the ways to write its cells.

use holdup::record::{Operation, Record};

/// Rows of the sample.
pub(crate) const ROWS: usize = 40;

/// Seconds since 1970 of 2024-01-31T13:05:00 UTC (`date -u -d 2024-01-31T13:05 +%s`).
pub(crate) const START: usize = 1_706_706_300;

/// A loop with a setpoint move and a stretch in manual; all numbers are short decimals.
pub(crate) fn record() -> Record {
    let column = |of: fn(usize) -> f64| (0..ROWS).map(of).collect::<Vec<f64>>();
    Record::new(column(seconds), column(controlled), column(manipulated))
        .unwrap()
        .with_setpoint(column(setpoint))
        .unwrap()
        .with_operation((0..ROWS).map(operation).collect())
        .unwrap()
}

#[expect(clippy::cast_precision_loss, reason = "small numbers")]
pub(crate) fn seconds(row: usize) -> f64 {
    (row * 10) as f64
}

#[expect(clippy::cast_precision_loss, reason = "small numbers")]
pub(crate) fn controlled(row: usize) -> f64 {
    50.0 + ((row * 37) % 64) as f64 / 64.0
}

pub(crate) fn manipulated(row: usize) -> f64 {
    if row < 17 { 20.5 } else { 1234.25 }
}

pub(crate) fn setpoint(row: usize) -> f64 {
    if row < 25 { 50.0 } else { 52.5 }
}

pub(crate) fn operation(row: usize) -> Operation {
    if (5..9).contains(&row) { Operation::Manual } else { Operation::Automatic }
}

/// Hour, minute, second of a row; the record starts at 13:05.
pub(crate) fn clock(row: usize) -> (usize, usize, usize) {
    let seconds = 13 * 3600 + 5 * 60 + row * 10;
    (seconds / 3600, seconds / 60 % 60, seconds % 60)
}

/// How the cells of a row are written.
pub(crate) struct Style {
    pub(crate) heading: &'static str,
    pub(crate) time: fn(usize) -> String,
    pub(crate) number: fn(f64) -> String,
    pub(crate) mode: [&'static str; 2],
    pub(crate) between: &'static str,
    pub(crate) end: &'static str,
    pub(crate) behind: &'static str,
}

impl Style {
    /// ISO times, points, commas, LF.
    pub(crate) const PLAIN: Self = Self {
        heading: "timestamp,sp,pv,op,mode",
        time: iso,
        number: point,
        mode: ["MAN", "AUTO"],
        between: ",",
        end: "\n",
        behind: "",
    };

    /// The text of a row.
    pub(crate) fn row(&self, row: usize) -> String {
        let mode = self.mode[usize::from(operation(row) == Operation::Automatic)].to_owned();
        let numbers = [setpoint(row), controlled(row), manipulated(row)].map(self.number);
        let cells = [vec![(self.time)(row)], numbers.to_vec(), vec![mode]].concat();
        cells.join(self.between) + self.behind
    }

    /// The text of the file.
    pub(crate) fn text(&self) -> String {
        let mut lines: Vec<String> = (0..ROWS).map(|row| self.row(row)).collect();
        if !self.heading.is_empty() {
            lines.insert(0, self.heading.to_owned());
        }
        lines.join(self.end) + self.end
    }
}

pub(crate) fn iso(row: usize) -> String {
    let (hour, minute, second) = clock(row);
    format!("2024-01-31 {hour:02}:{minute:02}:{second:02}")
}

pub(crate) fn point(value: f64) -> String {
    value.to_string()
}

pub(crate) fn comma(value: f64) -> String {
    value.to_string().replace('.', ",")
}
