//! `holdup optimise --objective averaging`: averaging level control.

use holdup::model::description::ControllerDescription;
use holdup::model::quantity::read_number;
use holdup::model::{Controller, Process};
use holdup::tuning::optimise::level::{Averaging, Demand, averaging};
use serde_json::json;

use super::OptimiseArgs;
use crate::commands::view::{controller_line, margins_table, process_line};
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::table::{number, table};

/// The gentlest valve.
pub(super) fn level(args: &OptimiseArgs, process: &Process, console: Console) -> Result<Answer, Fault> {
    let needed = |option: &str, given: &Option<String>| match given {
        Some(text) => read_number(option, text).map_err(Fault::input),
        None => Err(Fault::option("--objective", format!("averaging needs {option}"))),
    };
    let demand = Demand {
        load_step: needed("--load-step", &args.load_step)?,
        excursion: needed("--excursion", &args.excursion)?,
        sensitivity_peak: match &args.max_sensitivity {
            Some(text) => read_number("--max-sensitivity", text).map_err(Fault::input)?,
            None => 2.0,
        },
    };
    let found = averaging(process, &demand).map_err(Fault::input)?;
    let json = json!({
        "rule": null,
        "controller": ControllerDescription::from(&found.controller),
        "specification": {
            "load_step": demand.load_step, "excursion": demand.excursion, "sensitivity_peak": demand.sensitivity_peak,
        },
        "achieved": &found.achieved,
        "objective": {"name": "valve_rate", "value": found.rate},
        "constraint": [format!("excursion <= {}", demand.excursion)],
        "excursion": found.excursion,
        "bounds": {"valve_rate": found.least_rate},
        "percent_of_best": {"valve_rate": 100.0 * found.rate / found.least_rate},
        "proportional": found.proportional.as_ref().map(|(controller, rate)| json!({
            "controller": ControllerDescription::from(controller), "valve_rate": rate,
        })),
        "warnings": [],
    });
    let text = if console.json { String::new() } else { told_level(process, &demand, &found, console) };
    Ok(Answer { json, text, ..Answer::default() })
}

fn told_level(process: &Process, demand: &Demand, found: &Averaging, console: Console) -> String {
    let mut text = format!("{}\non {}\n\n", controller_line(&found.controller), process_line(process));
    text += &format!(
        "After a load step of {} the level moves by {}, {} allowed\n\n",
        number(demand.load_step),
        number(found.excursion),
        number(demand.excursion)
    );
    let row = |name: &str, controller: Option<&Controller>, rate: f64| {
        vec![
            name.to_owned(),
            number(rate),
            number(100.0 * rate / found.least_rate),
            number(controller.map(Controller::proportional_gain)),
            number(controller.and_then(Controller::integral_time)),
        ]
    };
    let mut rows = vec![row("PI", Some(&found.controller), found.rate)];
    if let Some((controller, rate)) = &found.proportional {
        rows.push(row("P alone, leaves an error", Some(controller), *rate));
    }
    rows.push(row("best possible", None, found.least_rate));
    text += &table(console, &["", "greatest rate [1/s]", "% of best", "Kc", "Ti [s]"], &rows);
    text + "\n" + &margins_table(console, &[("PI", &found.achieved)])
}
