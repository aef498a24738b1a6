//! Readings of several tags to rows: the times of the controlled variable, and what the other tags had then.

use super::clock::Times;
use super::column::{Column, Heading, Kind, Table, TextColumn};
use super::dialect::kind;
use super::error::ReadError;
use super::order::{Disorder, in_file_order, sorted};
use super::reading::{Repair, RepairKind, counted};
use super::roles::Roles;
use crate::model::text::one_line;

/// The readings of a file.
pub(super) struct Readings<'t> {
    pub(super) table: &'t Table,
    /// The column of the values.
    pub(super) value: usize,
    pub(super) times: &'t Times,
    /// Rows that count.
    pub(super) kept: &'t [usize],
    /// The tag of each row.
    pub(super) of_row: &'t [usize],
}

/// The readings of one tag, their times increasing strictly.
struct Series {
    rows: Vec<usize>,
    instants: Vec<i64>,
}

/// One column a tag, one row a reading of the controlled variable, and the instants of the rows.
pub(super) fn put_together(
    readings: &Readings<'_>,
    headings: &[Heading],
    roles: &Roles,
    repairs: &mut Vec<Repair>,
) -> Result<(Table, Vec<Option<i64>>), ReadError> {
    let instants: Vec<i64> = readings.kept.iter().filter_map(|row| readings.times.instants[*row]).collect();
    let (local, dated) = (readings.times.format.is_local(), readings.times.format.has_date());
    let tag = |row: usize| readings.of_row[row];
    let in_file = in_file_order(readings.kept.to_vec(), instants, [local, dated], tag, repairs);
    let series = |column: usize, repairs: &mut Vec<Repair>| -> Result<Series, ReadError> {
        let name = one_line(&headings[column].name);
        let own = |at: &usize| readings.of_row[in_file.rows[*at]] + 1 == column;
        let places: Vec<usize> = (0..in_file.rows.len()).filter(own).collect();
        let rows = places.iter().map(|at| in_file.rows[*at]).collect();
        let instants = places.iter().map(|at| in_file.instants[*at]).collect();
        let mut told = Vec::new();
        let same = |a: usize, b: usize| readings.same(a, b);
        let found = sorted(rows, instants, [local && !in_file.together, dated], same, &mut told);
        repairs.extend(
            told.into_iter().map(|repair| Repair { text: format!("{name}: {}", repair.text), ..repair }),
        );
        let found = found.map_err(|Disorder { row, back }| ReadError::Order {
            place: readings.table.place(row),
            column: name,
            back,
            rows: places.len(),
        })?;
        Ok(Series { rows: found.rows, instants: found.instants })
    };
    let base = series(roles.controlled, repairs)?;
    let mut manipulated = series(roles.manipulated, repairs)?;
    readings.numbers_only(&mut manipulated, &headings[roles.manipulated], repairs);
    let mut rows: Vec<usize> = (0..base.rows.len()).collect();
    // Before its first reading nobody knows where the actuator stood.
    let first = manipulated.instants.first().copied().unwrap_or(i64::MAX);
    rows.retain(|at| base.instants[*at] >= first);
    let early = base.rows.len() - rows.len();
    if manipulated.rows.is_empty() {
        return Err(ReadError::NoNumbers {
            place: readings.table.place(base.rows.first().copied().unwrap_or(0)),
            column: one_line(&headings[roles.manipulated].name),
            value: String::new(),
            rows: 0,
        });
    }
    if early > 0 {
        let name = one_line(&headings[roles.manipulated].name);
        let text = format!("{} before the first reading of {name} left out", counted(early, "row"));
        repairs.push(Repair::new(RepairKind::NoValue, early, text));
    }
    let mut wide = Table {
        columns: Vec::new(),
        lines: rows.iter().filter_map(|at| readings.table.lines.get(base.rows[*at]).copied()).collect(),
        rows: rows.len(),
    };
    let instants: Vec<i64> = rows.iter().map(|at| base.instants[*at]).collect();
    let own: Vec<Option<usize>> = rows.iter().map(|at| Some(base.rows[*at])).collect();
    wide.columns.push((roles.controlled, readings.gathered(&own)));
    let mut used = base.rows.len();
    let mut held = Vec::new();
    let mut add = |column: usize, series: &Series, backwards: bool| {
        let places = last_before(&series.instants, &instants, backwards);
        let name = one_line(&headings[column].name);
        let older = |(place, instant): (&Option<usize>, &i64)| {
            place.is_some_and(|place| series.instants[place] != *instant)
        };
        let rows = places.iter().zip(&instants).filter(|pair| older(*pair)).count();
        let mut seen: Vec<usize> = places.iter().flatten().copied().collect();
        seen.dedup();
        held.push((name, rows, series.rows.len() - seen.len()));
        used += series.rows.len();
        let cells: Vec<Option<usize>> = places.iter().map(|place| place.map(|k| series.rows[k])).collect();
        wide.columns.push((column, readings.gathered(&cells)));
    };
    add(roles.manipulated, &manipulated, false);
    if let Some(column) = roles.setpoint {
        let mut setpoint = series(column, repairs)?;
        readings.numbers_only(&mut setpoint, &headings[column], repairs);
        add(column, &setpoint, true);
    }
    if let Some(column) = roles.mode {
        add(column, &series(column, repairs)?, false);
    }
    let base_name = one_line(&headings[roles.controlled].name);
    told(&held, &base_name, repairs);
    let text = format!(
        "one row a reading: {} of {} put together to {} at the times of {base_name}",
        counted(used, "reading"),
        counted(held.len() + 1, "tag"),
        counted(wide.rows, "row"),
    );
    repairs.push(Repair::new(RepairKind::PutTogether, used, text));
    Ok((wide, instants.into_iter().map(Some).collect()))
}

/// What was held, and what fell between two rows.
fn told(held: &[(String, usize, usize)], base: &str, repairs: &mut Vec<Repair>) {
    for (name, rows, between) in held {
        if *rows > 0 {
            let text = format!(
                "{name} has times of its own: in {} of {base} its last value before is held",
                counted(*rows, "row")
            );
            repairs.push(Repair::new(RepairKind::HeldValues, *rows, text));
        }
        if *between > 0 {
            let text =
                format!("{} of {name} between two rows of {base} not used", counted(*between, "reading"));
            repairs.push(Repair::new(RepairKind::BetweenRows, *between, text));
        }
    }
}

/// The last instant at or before each of others, both in order; backwards, the first where there is none before.
fn last_before(own: &[i64], others: &[i64], backwards: bool) -> Vec<Option<usize>> {
    let mut next = 0;
    let of = |instant: &i64| {
        while own.get(next).is_some_and(|own| own <= instant) {
            next += 1;
        }
        next.checked_sub(1).or_else(|| (backwards && !own.is_empty()).then_some(0))
    };
    others.iter().map(of).collect()
}

impl Readings<'_> {
    /// Whether two rows have the same value.
    fn same(&self, a: usize, b: usize) -> bool {
        match self.table.column(self.value) {
            Some(Column::Text(cells)) => cells.cell(a) == cells.cell(b),
            Some(Column::Numbers(values)) => values[a] == values[b],
            _ => false,
        }
    }

    /// Leaves out the readings that are no number: what is held must be one.
    fn numbers_only(&self, series: &mut Series, heading: &Heading, repairs: &mut Vec<Repair>) {
        let is_number = |row: usize| match self.table.column(self.value) {
            Some(Column::Text(cells)) => kind(cells.cell(row)) == Kind::Number,
            Some(Column::Numbers(values)) => values[row].is_finite(),
            _ => false,
        };
        let bad: Vec<usize> = series.rows.iter().copied().filter(|row| !is_number(*row)).collect();
        let Some(first) = bad.first() else { return };
        let text = format!(
            "{} of {} without a number left out: first {}, '{}'",
            counted(bad.len(), "reading"),
            one_line(&heading.name),
            self.table.place(*first),
            self.table.text(self.value, *first)
        );
        repairs.push(Repair::new(RepairKind::NoValue, bad.len(), text));
        let kept: Vec<usize> = (0..series.rows.len()).filter(|at| is_number(series.rows[*at])).collect();
        series.instants = kept.iter().map(|at| series.instants[*at]).collect();
        series.rows = kept.into_iter().map(|at| series.rows[at]).collect();
    }

    /// The values of these rows as a column; nothing where there is none.
    fn gathered(&self, rows: &[Option<usize>]) -> Column {
        match self.table.column(self.value) {
            Some(Column::Numbers(values)) => {
                Column::Numbers(rows.iter().map(|row| row.map_or(f64::NAN, |row| values[row])).collect())
            }
            Some(Column::Text(cells)) => {
                let mut column = TextColumn::default();
                for row in rows {
                    column.push(row.map_or(&[], |row| cells.cell(row)));
                }
                Column::Text(column)
            }
            _ => Column::Numbers(vec![f64::NAN; rows.len()]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_reading_before_or_at_a_time_is_held() {
        let own = [10, 20, 20, 40];
        assert_eq!(
            last_before(&own, &[5, 10, 19, 20, 39, 41], false),
            [None, Some(0), Some(0), Some(2), Some(2), Some(3)]
        );
        assert_eq!(last_before(&own, &[5, 10], true), [Some(0), Some(0)]);
        assert_eq!(last_before(&[], &[5], true), [None]);
    }
}
