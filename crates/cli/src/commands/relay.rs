//! `holdup relay`: gain and dead time from a relay test.

use holdup::model::Seconds;
use holdup::model::quantity::{read_number, read_time};
use holdup::record::identify::{greatest_dead_time, point_fit};
use holdup::record::relay::RelayCycle;
use holdup::record::{ReadOptions, read};
use serde_json::json;

use super::record_input;
use crate::args::RelayArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::table::{number, table, title};

/// Identifies by a relay test.
pub(crate) fn run(args: &RelayArgs, console: Console) -> Result<Answer, Fault> {
    let value = |option: &str, given: &Option<String>| match given {
        Some(text) => read_number(option, text).map_err(Fault::input),
        None => Err(Fault::input(format!("{option} is missing: must be given, or --data FILE"))),
    };
    let time = |option: &str, given: &Option<String>| match given {
        Some(text) => read_time(option, text).map_err(Fault::input),
        None => {
            Err(Fault::input(format!("{option} is missing: must be given, or --period where both are equal")))
        }
    };
    let hysteresis = args.hysteresis.as_ref().map_or(Ok(0.0), |_| value("--hysteresis", &args.hysteresis))?;
    let (cycle, fit) = if let Some(path) = &args.data {
        let options = ReadOptions {
            controlled_variable: args.pv.clone(),
            manipulated_variable: args.op.clone(),
            ..ReadOptions::default()
        };
        let reading = read(path, &options).map_err(|error| record_input::fault(path, &error))?;
        reading.moves().map_err(|error| record_input::fault(path, &error))?;
        let record = reading.record;
        let cycle = RelayCycle::of(&record, hysteresis)
            .map_err(|error| Fault::input(format!("{}: {error}", path.display())))?;
        let fit = point_fit(&record, Seconds(greatest_dead_time(&record)))
            .map_err(|error| Fault::input(format!("{}: {error}", path.display())))?;
        (cycle, Some(fit))
    } else {
        let (high_time, low_time) = if args.period.is_some() {
            let half = time("--period", &args.period)? / 2.0;
            (half, half)
        } else {
            (time("--high-time", &args.high_time)?, time("--low-time", &args.low_time)?)
        };
        let cycle = RelayCycle {
            high: value("--high", &args.high)?,
            low: value("--low", &args.low)?,
            high_time,
            low_time,
            swing: value("--swing", &args.swing)?,
            hysteresis,
        };
        (cycle, None)
    };
    let found = cycle.result().map_err(Fault::input)?;
    // Of a record every row counts, and the rows' rounding of peaks and switchings does not: the fit goes first.
    let (gain, dead_time) =
        fit.map_or((found.process_gain, found.dead_time), |fit| (fit.process_gain, fit.dead_time));
    let json = json!({
        "process": {"process_gain": gain, "dead_time_s": dead_time},
        "load": found.load,
        "cycle": cycle,
        "from_cycle": found,
        "from_all_rows": fit,
    });
    let mut text = String::new();
    if !console.json {
        text =
            title(console, &format!("Process gain {} /s, dead time {} s", number(gain), number(dead_time)));
        let row = |name: &str, value: f64| vec![name.to_owned(), number(value)];
        let mut rows = vec![
            row("by the cycle: process gain [/s]", found.process_gain),
            row("by the cycle: dead time [s]", found.dead_time),
            row("load at the process input", found.load),
            row("time at the upper value [s]", cycle.high_time),
            row("time at the lower value [s]", cycle.low_time),
            row("swing", cycle.swing),
        ];
        if let Some(fit) = &fit {
            rows.push(row("left by the fit of all rows, std. dev.", fit.residual));
        }
        text += &table(console, &["", "value"], &rows);
    }
    Ok(Answer { json, text, ..Answer::default() })
}
