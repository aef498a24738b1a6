//! The record of a command: the file, the options that say how to read it, the window.

use std::fmt::Write as _;
use std::ops::Range;
use std::path::Path;

use holdup::model::quantity::{read_number, read_time};
use holdup::record::{DateOrder, DecimalMark, ReadError, ReadOptions, Reading, read};

use crate::args::RecordArgs;
use crate::console::Console;
use crate::fault::Fault;
use crate::table::{fold, table, title};

/// Reads the record of a command.
pub(crate) fn reading(args: &RecordArgs) -> Result<Reading, Fault> {
    read(&args.data, &options(args)?).map_err(|error| fault(&args.data, &error))
}

/// The rows between `--from` and `--to`; none where neither is given.
pub(crate) fn window(args: &RecordArgs, reading: &Reading) -> Result<Option<Range<usize>>, Fault> {
    if args.from.is_none() && args.to.is_none() {
        return Ok(None);
    }
    let rows = reading.window(args.from.as_deref(), args.to.as_deref());
    rows.map(Some).map_err(Fault::input)
}

/// A fault of an option names the option, one of the file the file.
pub(crate) fn fault(path: &Path, error: &ReadError) -> Fault {
    match error {
        ReadError::Option { .. } => Fault::input(error),
        _ => Fault::input(format!("{}: {error}", path.display())),
    }
}

fn options(args: &RecordArgs) -> Result<ReadOptions, Fault> {
    let choice = |option: &str, given: &str, allowed: &str| {
        Fault::option(option, format!("'{given}' must be one of {allowed}"))
    };
    let date_order = match args.date_order.as_deref() {
        None => None,
        Some("ymd") => Some(DateOrder::YearMonthDay),
        Some("dmy") => Some(DateOrder::DayMonthYear),
        Some("mdy") => Some(DateOrder::MonthDayYear),
        Some(given) => return Err(choice("--date-order", given, "ymd, dmy, mdy")),
    };
    let decimal_mark = match args.decimal.as_deref() {
        None => None,
        Some("point" | ".") => Some(DecimalMark::Point),
        Some("comma" | ",") => Some(DecimalMark::Comma),
        Some(given) => return Err(choice("--decimal", given, "point, comma")),
    };
    let time = |option: &str, given: &Option<String>| {
        given.as_deref().map(|text| read_time(option, text)).transpose().map_err(Fault::input)
    };
    let time_unit = match args.time_unit.as_deref() {
        Some("d") => Some(86_400.0),
        Some(unit @ ("ms" | "s" | "min" | "h")) => {
            Some(read_time("--time-unit", &format!("1{unit}")).map_err(Fault::input)?)
        }
        Some(given) => return Err(choice("--time-unit", given, "ms, s, min, h, d")),
        None => None,
    };
    Ok(ReadOptions {
        time: args.time.clone(),
        controlled_variable: args.pv.clone(),
        manipulated_variable: args.op.clone(),
        setpoint: args.sp.clone(),
        mode: args.mode.clone(),
        automatic: args.automatic.clone(),
        time_unit,
        sample_period: time("--sample-period", &args.sample_period)?,
        date_order,
        decimal_mark,
        controlled_span: span("--pv-span", args.pv_span.as_deref())?,
        manipulated_span: span("--op-span", args.op_span.as_deref())?,
    })
}

/// `low:high`.
fn span(option: &str, given: Option<&str>) -> Result<Option<(f64, f64)>, Fault> {
    let Some(given) = given else { return Ok(None) };
    let (low, high) = given
        .split_once(':')
        .ok_or_else(|| Fault::option(option, format!("'{given}' must be low:high, such as 0:5")))?;
    let end = |text: &str| read_number(option, text).map_err(Fault::input);
    Ok(Some((end(low)?, end(high)?)))
}

/// What was read, and every repair.
pub(crate) fn text(args: &RecordArgs, reading: &Reading, console: Console) -> String {
    let found = &reading.found;
    let mut text = title(console, &format!("{}: {} rows", args.data.display(), found.rows));
    let mut about = vec![found.format.to_owned()];
    about.extend(found.encoding.map(str::to_owned));
    about.extend(found.delimiter.map(|name| format!("delimiter {name}")));
    about.extend(found.heading_line.map(|line| format!("heading in line {line}")));
    let readings = found.layout == "readings";
    about.extend(readings.then(|| format!("{} readings of tags, one a row", found.rows_in_file)));
    about.extend(found.start.as_ref().map(|start| format!("starts {start}")));
    text += &about.join(", ");
    text += "\n\n";
    let rows: Vec<Vec<String>> = found
        .columns
        .iter()
        .filter_map(|column| {
            let unit = column.unit.clone().unwrap_or_default();
            Some(vec![
                column.number.to_string(),
                column.name.clone(),
                unit,
                column.used_as?.replace('_', " "),
            ])
        })
        .collect();
    text += &table(console, &["column", "name", "unit", "used as"], &rows);
    let unused = found.columns.len() - rows.len();
    if unused > 0 {
        _ = writeln!(text, "Not used: {unused} other {}.", if readings { "tags" } else { "columns" });
    }
    text.push('\n');
    if reading.repairs.is_empty() {
        text += "No repairs.\n";
    }
    for repair in &reading.repairs {
        for (index, line) in fold(&repair.text, console.width.saturating_sub(2)).iter().enumerate() {
            text += if index == 0 { "- " } else { "  " };
            text += line;
            text.push('\n');
        }
    }
    text
}
