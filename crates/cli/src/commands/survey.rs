//! `holdup survey`: a record before any model is fitted.

use holdup::record::{Reading, Record, Survey, Window};
use holdup::study::figures::{Axis, Figure, FigureError, Line, Panel, Reference, Series, Tone, terminal};
use serde_json::json;

use super::record_input;
use super::view::{check_kind, figure_file};
use crate::args::SurveyArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;

/// Points of a curve; of more rows the least and the greatest of each stretch are drawn.
const POINTS: usize = 4000;

/// Beyond this, times are drawn in hours [s].
const HOURS_FROM: f64 = 36_000.0;

/// Looks at a record.
pub(crate) fn run(args: &SurveyArgs, console: Console) -> Result<Answer, Fault> {
    args.plot.as_deref().map_or(Ok(()), check_kind)?;
    let reading = record_input::reading(&args.record)?;
    let given = record_input::window(&args.record, &reading)?;
    let record = match &given {
        Some(rows) => reading.record.rows(rows.start, rows.end).map_err(Fault::input)?,
        None => reading.record.clone(),
    };
    let survey = Survey::of(&record);
    let figure = figure(&reading, &record, &survey.window).map_err(Fault::input)?;
    let mut files = Vec::new();
    if let Some(path) = &args.plot {
        files.push((path.clone(), figure_file(path, &figure)?));
    }
    let json = json!({
        "found": reading.found,
        "repairs": reading.repairs,
        "given_window": given.as_ref().map(|rows| json!({ "from": rows.start, "to": rows.end })),
        "survey": survey,
    });
    let mut text = String::new();
    if !console.json {
        text = record_input::text(&args.record, &reading, console);
        if let Some(rows) = &given {
            text += &format!(
                "\nOnly rows {} to {} are looked at, as --from and --to say.\n",
                rows.start + 1,
                rows.end
            );
        }
        text.push('\n');
        text += &survey.text();
        text.push('\n');
        text += &terminal::chart(&figure, console.width, console.colour);
    }
    Ok(Answer { json, text, files, ..Answer::default() })
}

/// The record with its window.
fn figure(reading: &Reading, record: &Record, window: &Window) -> Result<Figure, FigureError> {
    let time = record.time();
    let hours = time[time.len() - 1] - time[0] > HOURS_FROM;
    let (unit, label) = if hours { (3600.0, "time [h]") } else { (1.0, "time [s]") };
    let curve = |name: &str, values: &[f64]| {
        let (x, y) = thinned(time, values, unit);
        Series::new(name, x, y)
    };
    let axis = |role: &str, fallback: &str| {
        let column = reading.found.columns.iter().find(|column| column.used_as == Some(role));
        let name = column.map_or(fallback, |column| column.name.as_str());
        let unit =
            column.and_then(|column| column.unit.as_ref()).map_or(String::new(), |unit| format!(" [{unit}]"));
        Axis::linear(format!("{fallback}: {name}{unit}"))
    };
    let mut output = Panel::new(Axis::linear(label), axis("controlled_variable", "controlled variable"));
    let mut input = Panel::new(Axis::linear(label), axis("manipulated_variable", "manipulated variable"));
    if window.to - window.from < record.len() {
        for (at, label) in [(window.from_s, "window from"), (window.to_s, "to")] {
            let mark = Reference::vertical(at / unit, label)?;
            output = output.with_reference(mark.clone());
            input = input.with_reference(mark);
        }
    }
    if let Some(setpoint) = record.setpoint() {
        output =
            output.with_series(curve("setpoint", setpoint)?.held().with_tone(Tone::Neutral).with_width(1.5)?);
    }
    let solid = |series: Series| series.with_line(Line::Solid).with_width(1.5);
    output = output.with_series(solid(curve("controlled variable", record.controlled_variable())?)?);
    input = input.with_series(solid(curve("manipulated variable", record.manipulated_variable())?.held())?);
    Figure::new("The record", vec![output, input])
}

/// Points of a curve: all rows, or the least and the greatest value of each stretch in their order.
fn thinned(time: &[f64], values: &[f64], unit: f64) -> (Vec<f64>, Vec<f64>) {
    let stretch = values.len().div_ceil(POINTS / 2).max(1);
    if values.len() <= POINTS {
        return (time.iter().map(|time| time / unit).collect(), values.to_vec());
    }
    let mut points = Vec::with_capacity(POINTS);
    for from in (0..values.len()).step_by(stretch) {
        let rows = from..(from + stretch).min(values.len());
        let least = rows.clone().min_by(|a, b| values[*a].total_cmp(&values[*b])).unwrap_or(from);
        let greatest = rows.max_by(|a, b| values[*a].total_cmp(&values[*b])).unwrap_or(from);
        let (first, last) = (least.min(greatest), least.max(greatest));
        points.extend([first, last].map(|row| (time[row] / unit, values[row])));
    }
    points.into_iter().unzip()
}
