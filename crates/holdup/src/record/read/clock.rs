//! A whole time column to instants: the order of day and month, the unit of bare numbers.

use serde::Serialize;

use super::ReadOptions;
use super::civil::{DAY, Date, DateOrder, SECOND, Stamp, stamp};
use super::column::{Column, TextColumn};
use super::number::{DecimalMark, marks, number};
use super::reading::{Repair, RepairKind};

/// How a file writes its times.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum TimeFormat {
    /// Date and time of day, in local time.
    Local {
        /// The order of the date's numbers.
        date_order: DateOrder,
    },
    /// Date and time of day with an offset from UTC.
    Zoned {
        /// The order of the date's numbers.
        date_order: DateOrder,
    },
    /// Time of day alone.
    TimeOfDay,
    /// A number.
    Number {
        /// Seconds in one unit [s].
        unit_s: f64,
    },
    /// Time since 1970 as a number.
    Epoch {
        /// Seconds in one unit [s].
        unit_s: f64,
    },
    /// Days since 1899-12-30, as a spreadsheet counts them.
    SerialDays,
    /// Year to second in fourteen digits.
    Compact,
    /// There is no time column: rows are evenly spaced.
    Counted {
        /// Time from row to row [s].
        sample_period_s: f64,
    },
}

impl TimeFormat {
    /// Whether the times are those of a wall clock that changes twice a year.
    pub(super) fn is_local(self) -> bool {
        matches!(self, Self::Local { .. } | Self::TimeOfDay | Self::SerialDays | Self::Compact)
    }

    /// Whether the times say which day it is.
    pub(super) fn has_date(self) -> bool {
        !matches!(self, Self::TimeOfDay | Self::Number { .. } | Self::Counted { .. })
    }
}

/// The instants of all rows.
#[derive(Debug)]
pub(super) struct Times {
    /// Instant [ns] of each row, none where the cell says none.
    pub(super) instants: Vec<Option<i64>>,
    /// How they were written.
    pub(super) format: TimeFormat,
    /// What had to be assumed.
    pub(super) assumed: Vec<Repair>,
}

/// Days from 1899-12-30, the day 0 of spreadsheets, to 1970-01-01.
const SPREADSHEET: i64 = 25_569;

/// The instants of a column. `unit` is that of the heading.
pub(super) fn times(column: &Column, unit: Option<&str>, options: &ReadOptions) -> Times {
    match column {
        Column::Instants(instants, zoned) => {
            let date_order = DateOrder::YearMonthDay;
            let format =
                if *zoned { TimeFormat::Zoned { date_order } } else { TimeFormat::Local { date_order } };
            Times { instants: instants.clone(), format, assumed: Vec::new() }
        }
        Column::Numbers(values) => numbers(values, 0, unit, options),
        Column::Text(cells) => {
            let filled = || cells.cells().filter(|cell| !cell.is_empty());
            let sampled = filled().take(200).count();
            let stamps = filled().take(200).filter(|cell| dated(cell)).count();
            if stamps * 2 > sampled {
                return stamped(&cells.cells().map(stamp).collect::<Vec<_>>(), options);
            }
            let mark = options.decimal_mark.unwrap_or_else(|| marks(&[cells]).mark);
            let values: Vec<f64> = cells.cells().map(|cell| number(cell, mark).unwrap_or(f64::NAN)).collect();
            numbers(&values, decimals(cells, mark), unit, options)
        }
    }
}

/// The instants of a date column and a column of times of day.
pub(super) fn combined(dates: &Column, clocks: &Column, rows: usize, options: &ReadOptions) -> Times {
    let (Column::Text(dates), Column::Text(clocks)) = (dates, clocks) else {
        let [dates, clocks] = [dates, clocks].map(|column| times(column, None, options));
        let sum = |(date, clock): (Option<i64>, Option<i64>)| Some(date? + clock?.rem_euclid(DAY));
        let instants = dates.instants.into_iter().zip(clocks.instants).map(sum).collect();
        return Times { instants, ..dates };
    };
    let both = |row: usize| {
        let (date, clock) = (stamp(dates.cell(row))?, stamp(clocks.cell(row))?);
        Some(Stamp { date: date.date, clock: clock.clock, offset: clock.offset })
    };
    stamped(&(0..rows).map(both).collect::<Vec<_>>(), options)
}

/// Whether a cell is a timestamp whose date exists.
pub(super) fn dated(cell: &[u8]) -> bool {
    let exists = |date: Date| ORDERS.iter().any(|order| date.days(*order).is_some());
    stamp(cell).is_some_and(|stamp| stamp.date.is_none_or(exists))
}

const ORDERS: [DateOrder; 3] = [DateOrder::DayMonthYear, DateOrder::MonthDayYear, DateOrder::YearMonthDay];

fn stamped(stamps: &[Option<Stamp>], options: &ReadOptions) -> Times {
    let found = || stamps.iter().flatten();
    let mut assumed = Vec::new();
    if found().all(|stamp| stamp.date.is_none()) {
        let instants =
            past_midnight(stamps.iter().map(|stamp| stamp.and_then(|stamp| stamp.clock)), &mut assumed);
        return Times { instants, format: TimeFormat::TimeOfDay, assumed };
    }
    let mut dates: Vec<Date> = found().filter_map(|stamp| stamp.date).collect();
    dates.dedup();
    let (date_order, certain) = date_order(&dates, options.date_order);
    if !certain {
        let (name, other) = match date_order {
            DateOrder::MonthDayYear => ("month first", "dmy"),
            _ => ("day first", "mdy"),
        };
        let text = format!(
            "dates are read {name}, which the column does not decide: --date-order {other} reads the other way"
        );
        assumed.push(Repair::new(RepairKind::DateOrderAssumed, found().count(), text));
    }
    let zoned = found().filter(|stamp| stamp.offset.is_some()).count() * 2 > found().count();
    let instant = |stamp: &Option<Stamp>| {
        let stamp = (*stamp)?;
        let days = stamp.date?.days(date_order)?;
        Some(days * DAY + stamp.clock.unwrap_or(0) - stamp.offset.unwrap_or(0))
    };
    let format = if zoned { TimeFormat::Zoned { date_order } } else { TimeFormat::Local { date_order } };
    Times { instants: stamps.iter().map(instant).collect(), format, assumed }
}

/// Which number is which, and whether that is certain: the orders under which most dates exist, and of these the one
/// under which the days follow each other most closely.
fn date_order(dates: &[Date], given: Option<DateOrder>) -> (DateOrder, bool) {
    if let Some(order) = given {
        return (order, true);
    }
    if let Some(order) = dates.first().and_then(|date| date.order) {
        return (order, true);
    }
    let known = |order: DateOrder| dates.iter().filter_map(|date| date.days(order)).count();
    let most = ORDERS.into_iter().map(known).max().unwrap_or(0);
    let way = |order: DateOrder| -> i64 {
        let days: Vec<i64> = dates.iter().filter_map(|date| date.days(order)).collect();
        days.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum()
    };
    let mut left: Vec<DateOrder> = ORDERS.into_iter().filter(|order| known(*order) == most).collect();
    // A year of two digits in front is for those who write it so in every row: where all else fails.
    if left.len() > 1 && dates.iter().all(|date| date.parts[0] <= 31) {
        left.retain(|order| *order != DateOrder::YearMonthDay);
    }
    let least = left.iter().map(|order| way(*order)).min().unwrap_or(0);
    left.retain(|order| way(*order) == least);
    match left[..] {
        [only] => (only, true),
        // The dot is European; with the others both habits exist, the day first in most countries.
        [first, ..] => (first, dates.iter().all(|date| date.separator == b'.')),
        [] => (DateOrder::YearMonthDay, true),
    }
}

/// Times of day as instants that go on after midnight, in either direction of the rows.
fn past_midnight(clocks: impl Iterator<Item = Option<i64>>, assumed: &mut Vec<Repair>) -> Vec<Option<i64>> {
    let (mut days, mut before, mut passed) = (0, None, 0);
    let instants = clocks
        .map(|clock| {
            let clock = clock?;
            if let Some(before) = before {
                let step: i64 = clock - before;
                if step.abs() > DAY / 2 {
                    days -= step.signum();
                    passed += 1;
                }
            }
            before = Some(clock);
            Some(days * DAY + clock)
        })
        .collect();
    if passed > 0 {
        let text = format!("the time of day passes midnight {passed} times: each is taken as the next day");
        assumed.push(Repair::new(RepairKind::MidnightPassed, passed, text));
    }
    instants
}

/// The greatest number of digits behind the decimal mark.
fn decimals(cells: &TextColumn, mark: DecimalMark) -> usize {
    let point = if mark == DecimalMark::Point { b'.' } else { b',' };
    let digits = |cell: &[u8]| {
        let place = cell.iter().position(|byte| *byte == point)?;
        Some(cell[place + 1..].iter().take_while(|byte| byte.is_ascii_digit()).count())
    };
    cells.cells().filter_map(digits).max().unwrap_or(0)
}

/// Bare numbers: a unit that is given, that of the heading, or the one that their size shows.
fn numbers(values: &[f64], decimals: usize, unit: Option<&str>, options: &ReadOptions) -> Times {
    let given = options.time_unit.or_else(|| unit.and_then(unit_seconds));
    let greatest =
        values.iter().filter(|value| value.is_finite()).fold(0.0_f64, |most, value| most.max(value.abs()));
    let least =
        values.iter().filter(|value| value.is_finite()).fold(f64::INFINITY, |least, value| least.min(*value));
    let mut assumed = Vec::new();
    let shown = |low: f64, high: f64| given.is_none() && least >= low && greatest <= high;
    // 1990 to 2100 in seconds, and in their parts.
    let epoch = |unit: f64| shown(6.3e8 / unit, 4.1e9 / unit).then_some(TimeFormat::Epoch { unit_s: unit });
    let format = [1.0, 1e-3, 1e-6, 1e-9].into_iter().find_map(epoch).unwrap_or_else(|| {
        if shown(19_000_101_000_000.0, 22_001_231_235_959.0) {
            TimeFormat::Compact
        } else if shown(30_000.0, 75_000.0) && decimals >= 3 && median_step(values) < 0.011 {
            TimeFormat::SerialDays
        } else {
            TimeFormat::Number { unit_s: given.unwrap_or(1.0) }
        }
    });
    if !matches!(format, TimeFormat::Number { .. }) || given.is_none() {
        let text = match format {
            TimeFormat::Epoch { unit_s: 1.0 } => "times are read as seconds since 1970",
            TimeFormat::Epoch { unit_s: 1e-3 } => "times are read as milliseconds since 1970",
            TimeFormat::Epoch { unit_s: 1e-6 } => "times are read as microseconds since 1970",
            TimeFormat::Epoch { .. } => "times are read as nanoseconds since 1970",
            TimeFormat::Compact => "times are read as fourteen digits from year to second",
            TimeFormat::SerialDays => {
                "times are read as days of a spreadsheet: --time-unit s reads them as seconds"
            }
            _ => "times are read as seconds: --time-unit min or h reads them otherwise",
        };
        assumed.push(Repair::new(RepairKind::TimeUnitAssumed, values.len(), text.to_owned()));
    }
    let unit_s = match format {
        TimeFormat::Number { unit_s } | TimeFormat::Epoch { unit_s } => unit_s,
        TimeFormat::SerialDays => 86_400.0,
        _ => 1.0,
    };
    // Fractions of a minute, an hour or a day are cut somewhere; a few digits may also be all there is.
    let cut = unit_s >= 60.0 && decimals >= 4;
    let resolution = resolution(greatest, unit_s, if cut { decimals } else { 0 });
    let instant = |value: f64| match format {
        TimeFormat::Compact => compact(value),
        TimeFormat::SerialDays => {
            instant(value, unit_s, resolution).map(|instant| instant - SPREADSHEET * DAY)
        }
        _ => instant(value, unit_s, resolution),
    };
    Times { instants: values.iter().map(|value| instant(*value)).collect(), format, assumed }
}

/// Seconds in a unit of time by its name [s].
pub(super) fn unit_seconds(unit: &str) -> Option<f64> {
    let seconds = match unit.to_lowercase().as_str() {
        "s" | "sec" | "secs" | "second" | "seconds" | "sek" => 1.0,
        "ms" | "msec" | "millisecond" | "milliseconds" => 1e-3,
        "us" | "µs" | "microsecond" | "microseconds" => 1e-6,
        "ns" | "nanosecond" | "nanoseconds" => 1e-9,
        "min" | "mins" | "minute" | "minutes" => 60.0,
        "h" | "hr" | "hrs" | "hour" | "hours" => 3600.0,
        "d" | "day" | "days" => 86_400.0,
        _ => return None,
    };
    Some(seconds)
}

/// Nanoseconds to which a time is rounded: a power of ten that neither the 64 bits of the number nor the digits of
/// a day's fraction can fall short of.
fn resolution(greatest: f64, unit_s: f64, decimals: usize) -> i64 {
    let bits = greatest * f64::EPSILON * unit_s * 1e9;
    let digits =
        if decimals > 0 { 0.1_f64.powi(i32::try_from(decimals).unwrap_or(18)) * unit_s * 1e9 } else { 0.0 };
    let mut step = 1;
    while f64_of(step) < bits.max(digits) && step < SECOND {
        step *= 10;
    }
    step
}

#[expect(clippy::cast_precision_loss, reason = "powers of ten to 1e9")]
fn f64_of(step: i64) -> f64 {
    step as f64
}

#[expect(clippy::cast_possible_truncation, reason = "checked against the range of 64 bits")]
fn instant(value: f64, unit_s: f64, resolution: i64) -> Option<i64> {
    const LARGEST: f64 = 9.0e18;
    let nanos = (unit_s * 1e9).round();
    let whole = value.trunc();
    if value.is_nan() || value.abs() * nanos >= LARGEST {
        return None;
    }
    // Whole and fraction apart: their product with 1e9 would not fit 53 bits.
    let exact = whole as i64 * nanos as i64 + ((value - whole) * nanos).round() as i64;
    let half = resolution / 2;
    Some((exact + half).div_euclid(resolution) * resolution)
}

#[expect(clippy::cast_possible_truncation, reason = "fourteen digits")]
fn compact(value: f64) -> Option<i64> {
    let digits = value.is_finite().then(|| value.trunc() as i64)?;
    let part = |from: i64, length: i64| i32::try_from(digits / from % length).unwrap_or(0);
    let parts = [part(10_000_000_000, 10_000), part(100_000_000, 100), part(1_000_000, 100)];
    let date = Date { parts, order: Some(DateOrder::YearMonthDay), separator: b'-' };
    let (hour, minute, second) = (part(10_000, 100), part(100, 100), part(1, 100));
    let clock = i64::from(hour * 3600 + minute * 60 + second) * SECOND;
    (hour <= 24 && minute < 60 && second <= 60).then_some(())?;
    Some(date.days(DateOrder::YearMonthDay)? * DAY + clock)
}

fn median_step(values: &[f64]) -> f64 {
    let mut steps: Vec<f64> = values
        .windows(2)
        .map(|pair| (pair[1] - pair[0]).abs())
        .filter(|step| step.is_finite())
        .take(1000)
        .collect();
    steps.sort_by(f64::total_cmp);
    steps.get(steps.len() / 2).copied().unwrap_or(f64::INFINITY)
}
