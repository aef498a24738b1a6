//! From cells to a record.

use super::ReadOptions;
use super::civil::iso;
use super::clock::{TimeFormat, Times, combined, times};
use super::column::{Column, Heading, Place, Table, TextColumn};
use super::error::ReadError;
use super::mode::operation;
use super::number::{DecimalMark, marks};
use super::order::ordered;
use super::reading::{Found, FoundColumn, Reading, Repair, RepairKind, counted};
use super::roles::{Roles, TimeColumn};
use super::values::{Values, held, quality};
use crate::model::text::one_line;
use crate::record::{Operation, Record};

/// What is known of the file when its cells are read.
pub(super) struct File {
    pub(super) format: &'static str,
    /// `columns` or `readings`.
    pub(super) layout: &'static str,
    pub(super) encoding: Option<&'static str>,
    pub(super) delimiter: Option<&'static str>,
    pub(super) heading_line: Option<usize>,
    pub(super) headings: Vec<Heading>,
    pub(super) roles: Roles,
    pub(super) table: Table,
    /// The instants of the rows, where they are known already.
    pub(super) times: Option<Times>,
    /// Rows of data in the file.
    pub(super) rows: usize,
}

/// Puts the record together.
pub(super) fn reading(
    file: &File,
    options: &ReadOptions,
    mut repairs: Vec<Repair>,
) -> Result<Reading, ReadError> {
    let File { headings, roles, table, .. } = file;
    let own;
    let times = if let Some(times) = &file.times {
        times
    } else {
        own = instants(file, options)?;
        &own
    };
    repairs.extend(times.assumed.iter().cloned());
    let mark = decimal_mark(file, options, &mut repairs);
    let read = |column: usize| Values::of(table, column, mark);
    let controlled = read(roles.controlled);
    let mut manipulated = read(roles.manipulated);
    let mut setpoint = roles.setpoint.map(read);
    let mut kept: Vec<usize> = (0..table.rows).filter(|row| times.instants[*row].is_some()).collect();
    let mode = roles.mode.map(|column| modes(file, column, &kept, options, &mut repairs));
    undated(file, times, &kept, &mut repairs)?;
    for (values, column) in [(&controlled, roles.controlled), (&manipulated, roles.manipulated)] {
        if values.all_missing() {
            return Err(no_numbers(file, column));
        }
    }
    let name = |column: usize| one_line(&headings[column].name);
    let ends = [kept.first(), kept.last()].map(|row| row.and_then(|row| times.instants[*row]));
    let newest_first = ends[0] > ends[1];
    for &column in &roles.quality {
        quality(table, column, &name(column), &mut kept, &mut repairs);
    }
    // A source that writes the output only when it moves leaves the other cells empty.
    if manipulated.is_sparse(&controlled) {
        held(&mut manipulated, &name(roles.manipulated), &kept, newest_first, &mut repairs);
    }
    controlled.leave_out(&name(roles.controlled), &mut kept, &mut repairs);
    manipulated.leave_out(&name(roles.manipulated), &mut kept, &mut repairs);
    if let (Some(values), Some(column)) = (&mut setpoint, roles.setpoint) {
        if values.all_missing() {
            let text = format!("column {} has no number in it: the setpoint is not used", name(column));
            repairs.push(Repair::new(RepairKind::NoValue, table.rows, text));
        } else {
            held(values, &name(column), &kept, newest_first, &mut repairs);
        }
    }
    let setpoint = setpoint.filter(|values| !values.all_missing());
    let instants: Vec<i64> = kept.iter().filter_map(|row| times.instants[*row]).collect();
    let (pv, op) = (&controlled.numbers, &manipulated.numbers);
    let sp = setpoint.as_ref().map(|values| &values.numbers);
    let same = |a: usize, b: usize| {
        pv[a] == pv[b]
            && op[a] == op[b]
            && sp.is_none_or(|sp| sp[a] == sp[b])
            && mode.as_ref().is_none_or(|mode| mode[a] == mode[b])
    };
    let local = times.format.is_local();
    let order =
        ordered(kept, instants, local, times.format.has_date(), same, &mut repairs).map_err(|disorder| {
            let column = match roles.time {
                TimeColumn::One(column) | TimeColumn::Two(_, column) => name(column),
                TimeColumn::None => String::new(),
            };
            ReadError::Order {
                place: table.place(disorder.row),
                column,
                back: disorder.back,
                rows: table.rows,
            }
        })?;
    let start = order.instants.first().copied().unwrap_or(0);
    let gather = |values: &[f64], span: Option<(f64, f64)>| -> Vec<f64> {
        let (low, high) = span.unwrap_or((0.0, 100.0));
        let scale = |value: f64| if span.is_some() { (value - low) / (high - low) * 100.0 } else { value };
        order.rows.iter().map(|&row| scale(values[row])).collect()
    };
    let dropped = table.rows - order.rows.len();
    let refuse = |error| ReadError::Record { error, left_out: dropped };
    let time = order.instants.iter().map(|&instant| seconds(instant - start)).collect();
    let mut record =
        Record::new(time, gather(pv, options.controlled_span), gather(op, options.manipulated_span))
            .map_err(refuse)?;
    if let Some(sp) = sp {
        record = record.with_setpoint(gather(sp, options.controlled_span)).map_err(refuse)?;
    }
    if let Some(mode) = mode {
        record = record.with_operation(order.rows.iter().map(|&row| mode[row]).collect()).map_err(refuse)?;
    }
    let found = Found {
        format: file.format,
        layout: file.layout,
        encoding: file.encoding,
        delimiter: file.delimiter,
        decimal_mark: file.delimiter.map(|_| mark),
        heading_line: file.heading_line,
        columns: columns(file),
        time_format: times.format,
        start: times.format.has_date().then(|| iso(start)),
        rows_in_file: file.rows,
        rows: record.len(),
    };
    Ok(Reading { record, found, repairs, start })
}

/// Nanoseconds as seconds: the double next to the decimal number.
#[expect(
    clippy::cast_precision_loss,
    reason = "below 2^53 ns, 104 days, exact; beyond, to 1e-16 of the time"
)]
fn seconds(nanos: i64) -> f64 {
    nanos as f64 / 1e9
}

fn columns(file: &File) -> Vec<FoundColumn> {
    let column = |(number, heading): (usize, &Heading)| FoundColumn {
        number: number + 1,
        name: heading.name.clone(),
        unit: heading.unit.clone(),
        used_as: file.roles.used_as(number),
    };
    file.headings.iter().enumerate().map(column).collect()
}

fn instants(file: &File, options: &ReadOptions) -> Result<Times, ReadError> {
    let cells = |column: usize| file.table.column(column).ok_or(ReadError::Empty);
    match file.roles.time {
        TimeColumn::One(column) => Ok(times(cells(column)?, file.headings[column].unit.as_deref(), options)),
        TimeColumn::Two(date, clock) => Ok(combined(cells(date)?, cells(clock)?, file.table.rows, options)),
        TimeColumn::None => {
            let sample_period_s = options.sample_period.unwrap_or(1.0);
            let instants = evenly_spaced(sample_period_s, file.table.rows);
            Ok(Times { instants, format: TimeFormat::Counted { sample_period_s }, assumed: Vec::new() })
        }
    }
}

/// Evenly spaced instants.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the period is checked to be below 1e9 s and not below 1 ns"
)]
fn evenly_spaced(sample_period: f64, rows: usize) -> Vec<Option<i64>> {
    let step = (sample_period * 1e9).round() as i64;
    (0..rows).map(|row| i64::try_from(row).ok().and_then(|row| step.checked_mul(row))).collect()
}

/// Rows without a readable time: left out, unless most are.
fn undated(file: &File, times: &Times, kept: &[usize], repairs: &mut Vec<Repair>) -> Result<(), ReadError> {
    let rows = file.table.rows;
    let bad = rows - kept.len();
    if bad == 0 {
        return Ok(());
    }
    let (place, value, column) = first_where(file, |row| times.instants[row].is_none());
    if bad * 2 > rows {
        return Err(ReadError::NoTime { place, column, value });
    }
    let text = format!("{} without a readable time left out: first {place}, '{value}'", counted(bad, "row"));
    repairs.push(Repair::new(RepairKind::NoTime, bad, text));
    Ok(())
}

/// Place, time cell and time column of the first row for which something holds.
fn first_where(file: &File, holds: impl Fn(usize) -> bool) -> (Place, String, String) {
    let row = (0..file.table.rows).find(|row| holds(*row)).unwrap_or(0);
    let column = match file.roles.time {
        TimeColumn::One(column) | TimeColumn::Two(column, _) => column,
        TimeColumn::None => 0,
    };
    (file.table.place(row), file.table.text(column, row), one_line(&file.headings[column].name))
}

fn no_numbers(file: &File, column: usize) -> ReadError {
    let (name, rows) = (one_line(&file.headings[column].name), file.table.rows);
    let value = file.table.text(column, 0);
    ReadError::NoNumbers { place: file.table.place(0), column: name, value, rows }
}

/// The decimal mark of all value columns together.
fn decimal_mark(file: &File, options: &ReadOptions, repairs: &mut Vec<Repair>) -> DecimalMark {
    if let Some(mark) = options.decimal_mark {
        return mark;
    }
    let columns = [Some(file.roles.controlled), Some(file.roles.manipulated), file.roles.setpoint];
    let texts: Vec<&TextColumn> = columns
        .into_iter()
        .flatten()
        .filter_map(|column| match file.table.column(column) {
            Some(Column::Text(cells)) => Some(cells),
            _ => None,
        })
        .collect();
    let found = marks(&texts);
    if found.assumed {
        let (read, other) = match found.mark {
            DecimalMark::Comma => ("the comma is read as the decimal mark", "point"),
            DecimalMark::Point => ("the comma is read as separating thousands", "comma"),
        };
        let text =
            format!("{read}, which the numbers do not decide: --decimal {other} reads it the other way");
        repairs.push(Repair::new(RepairKind::DecimalMarkAssumed, file.table.rows, text));
    }
    found.mark
}

/// Who moves the actuator in each row; words that are not understood are reported.
fn modes(
    file: &File,
    column: usize,
    kept: &[usize],
    options: &ReadOptions,
    repairs: &mut Vec<Repair>,
) -> Vec<Operation> {
    // A mode column has few words: each is understood once.
    let mut known: Vec<(String, Operation, usize)> = Vec::new();
    let mut of = |word: &str| {
        if let Some((_, operation, count)) = known.iter_mut().find(|(own, ..)| own == word) {
            *count += 1;
            return *operation;
        }
        let found = operation(word, &options.automatic);
        if known.len() < 64 {
            known.push((word.to_owned(), found, 1));
        }
        found
    };
    let mut all = vec![Operation::Unknown; file.table.rows];
    for &row in kept {
        all[row] = match file.table.column(column) {
            Some(Column::Text(cells)) => of(&String::from_utf8_lossy(cells.cell(row))),
            Some(Column::Numbers(values)) if values[row].is_finite() => of(&values[row].to_string()),
            _ => of(""),
        };
    }
    let unknown: Vec<&(String, Operation, usize)> =
        known.iter().filter(|(_, operation, _)| *operation == Operation::Unknown).collect();
    let rows: usize = unknown.iter().map(|(.., count)| count).sum();
    if rows > 0 {
        let words: Vec<String> =
            unknown.iter().take(4).map(|(word, ..)| format!("'{}'", one_line(word))).collect();
        let name = one_line(&file.headings[column].name);
        let text = format!(
            "{} of {name} not understood ({}): --automatic names the values that mean automatic",
            counted(rows, "cell"),
            words.join(", ")
        );
        repairs.push(Repair::new(RepairKind::UnknownMode, rows, text));
    }
    all
}
