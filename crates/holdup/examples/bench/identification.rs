//! Identification of gain and dead time from a record in a file of three columns: time, level, valve.

use std::error::Error;
use std::fs::read_to_string;
use std::hint::black_box;
use std::time::Duration;

use holdup::model::Seconds;
use holdup::record::Record;
use holdup::record::identify::{greatest_dead_time, point_fit};
use serde_json::json;

use crate::{best, report};

pub(crate) fn run(file: &str) -> Result<(), Box<dyn Error>> {
    let mut columns = [Vec::new(), Vec::new(), Vec::new()];
    let text = read_to_string(file)?;
    for line in text.lines().skip(1) {
        for (column, word) in columns.iter_mut().zip(line.split(',')) {
            column.push(word.parse::<f64>()?);
        }
    }
    let [time, level, valve] = columns;
    let record = Record::new(time, level, valve)?;
    let greatest = Seconds(greatest_dead_time(&record));
    let fit = point_fit(&record, greatest)?;
    let seconds = best(Duration::from_millis(500), || {
        _ = black_box(point_fit(black_box(&record), greatest));
    });
    report("identify", record.len() as u64, seconds, json!([fit.process_gain, fit.dead_time]));
    Ok(())
}
