//! Optima from the tables: `--table` and `--tables`.

use holdup::analysis::frequency::margins;
use holdup::analysis::infinite_horizon::{Input, to_infinity};
use holdup::model::description::ControllerDescription;
use holdup::model::{ClosedLoop, Process};
use holdup::tuning::optimise::table::{Normalised, Table, table, tables};
use holdup::tuning::optimise::{Filter, Limits, Objective, Quantity, Structure};
use serde_json::{Value, json};

use super::{OptimiseArgs, specification};
use crate::commands::view::{controller_line, margins_table, process_line};
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::table::{number, table as printed, title};

/// The sensitivity peaks of a printed table.
const PRINTED: [f64; 12] = [1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0, 2.1, 2.25, 2.5];

/// The filter of the tables of structures with a derivative.
const RATIO: f64 = 0.1;

/// The optimum for a process, interpolated; what it achieves, computed.
pub(super) fn one(
    process: &Process,
    (structure, filter, objective): (Structure, Option<Filter>, Objective),
    limits: &Limits,
    console: Console,
) -> Result<Answer, Fault> {
    let Some(peak) = limits.of(Quantity::SensitivityPeak) else {
        return Err(Fault::option("--table", "must stand with --max-sensitivity"));
    };
    let filter = filter.unwrap_or(Filter::Held(RATIO));
    let refused = |error| Fault::option("--table", error);
    let table = table(structure, filter, objective).map_err(refused)?;
    let (at, controller) =
        (table.at(peak).map_err(refused)?, table.controller(process, peak).map_err(refused)?);
    let achieved = margins(&ClosedLoop::new(process, &controller)).map_err(Fault::input)?;
    let integrals = |input| to_infinity(process, &controller, input).ok();
    let (load, setpoint) =
        (integrals(Input::Load).filter(|_| structure.rejects_load()), integrals(Input::Setpoint));
    let value = objective.of(process, &controller);
    let json = json!({
        "rule": null,
        "controller": ControllerDescription::from(&controller),
        "specification": specification(limits),
        "achieved": &achieved,
        "objective": {"name": objective.name(), "value": value},
        "constraint": limits.list().iter().map(ToString::to_string).collect::<Vec<_>>(),
        "load": load,
        "setpoint": setpoint,
        "noise_gain": controller.noise_gain(),
        "table": {"name": table.name(), "normalised": row_json(&at), "error": error_json(table)},
        "trade_off": null,
        "warnings": [],
    });
    let mut text = String::new();
    if !console.json {
        text = format!("{}\non {}\n\n", controller_line(&controller), process_line(process));
        text += &format!("{} = {} under sensitivity_peak <= {peak}\n", objective.name(), number(value));
        text += &format!("From the table {}:\n  {}\n\n", table.name(), table.error);
        text += &margins_table(console, &[("achieved", &achieved)]);
    }
    Ok(Answer { json, text, ..Answer::default() })
}

/// The tables themselves.
pub(super) fn all(args: &OptimiseArgs, console: Console) -> Result<Answer, Fault> {
    let chosen = match &args.structure {
        Some(name) => Some(super::asked::structure(name)?),
        None => None,
    };
    let wanted: Vec<&Table> =
        tables().iter().filter(|table| chosen.is_none_or(|structure| structure == table.structure)).collect();
    if wanted.is_empty() {
        let known: Vec<String> = tables().iter().map(Table::name).collect();
        let message = format!("there is no table of {}; there are {}", args.structure(), known.join(", "));
        return Err(Fault::option("--tables", message));
    }
    let (mut text, mut list) = (String::new(), Vec::new());
    for table in wanted {
        let rows: Vec<Normalised> = PRINTED.iter().filter_map(|&peak| table.at(peak).ok()).collect();
        list.push(json!({
            "structure": table.structure.name(),
            "filter_ratio": if let Filter::Held(ratio) = table.filter { Some(ratio) } else { None },
            "objective": table.objective.name(),
            "unit": table.unit(),
            "range": table.range(),
            "error": error_json(table),
            "rows": rows.iter().map(row_json).collect::<Vec<_>>(),
        }));
        if !console.json {
            text += &shown(table, &rows, console);
        }
    }
    if !console.json {
        text += "d is the dead time, K the process gain. Between the rows: holdup optimise -p … --max-sensitivity M_s --table\n";
    }
    Ok(Answer { json: json!(list), text, ..Answer::default() })
}

fn shown(table: &Table, rows: &[Normalised], console: Console) -> String {
    let value = match (table.objective.name(), table.unit()) {
        (name, "") => name.to_owned(),
        (name, unit) => format!("{name} / ({unit})"),
    };
    let structure = table.structure;
    let there = [true, true, structure.integrates(), structure.differentiates(), structure.observes(), true];
    let heading = ["M_s", "K·Kc·d", "Ti/d", "Td/d", "K·Ko·d", &value];
    let kept = |index: &usize| there[*index];
    let heading: Vec<&str> = (0..6).filter(kept).map(|index| heading[index]).collect();
    let cells = |row: &Normalised| {
        let all = [
            Some(row.sensitivity_peak),
            Some(row.gain),
            row.integral_time,
            row.derivative_time,
            row.observer_gain,
            Some(row.value),
        ];
        (0..6).filter(kept).map(|index| number(all[index])).collect()
    };
    let rows: Vec<Vec<String>> = rows.iter().map(cells).collect();
    title(console, &format!("Least {}", table.name())) + &printed(console, &heading, &rows) + "\n"
}

fn row_json(row: &Normalised) -> Value {
    json!({
        "sensitivity_peak": row.sensitivity_peak,
        "gain": row.gain,
        "integral_time": row.integral_time,
        "derivative_time": row.derivative_time,
        "observer_gain": row.observer_gain,
        "value": row.value,
    })
}

fn error_json(table: &Table) -> Value {
    json!({
        "settings": table.error.settings,
        "value": table.error.value,
        "sensitivity_peak": table.error.sensitivity_peak,
    })
}
