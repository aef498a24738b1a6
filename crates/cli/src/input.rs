//! Process, loop and scenario from the options.

use std::path::Path;

use holdup::analysis::response::Scenario;
use holdup::model::events::read_events;
use holdup::model::loop_file::read_loop;
use holdup::model::notation::{read_controller, read_process};
use holdup::model::quantity::{read_number, read_time};
use holdup::model::{Controller, Process, Seconds};

use crate::args::{LoopArgs, ScenarioArgs};
use crate::fault::Fault;

/// The greatest text file that is read [bytes]: no loop and no study comes near.
const GREATEST: u64 = 16 << 20;

/// Dead times from the last event to the horizon, where none is given.
const DEAD_TIMES: f64 = 50.0;

/// The text of a file.
pub(crate) fn text_of(path: &Path) -> Result<String, Fault> {
    let read = |error: &std::io::Error| Fault::file(path, "read", error);
    let size = std::fs::metadata(path).map_err(|error| read(&error))?;
    if size.is_dir() {
        return Err(Fault::input(format!("{}: is a folder: must be a TOML file", path.display())));
    }
    if size.len() > GREATEST {
        return Err(Fault::input(format!("{}: is greater than 16 MiB: must be a TOML file", path.display())));
    }
    let bytes = std::fs::read(path).map_err(|error| read(&error))?;
    String::from_utf8(bytes)
        .map_err(|_| Fault::input(format!("{}: is not UTF-8 text: must be a TOML file", path.display())))
}

/// The process of `--process`.
pub(crate) fn process(given: Option<&String>) -> Result<Process, Fault> {
    let text = given.ok_or_else(|| Fault::input("--process is missing: must be such as -p K=0.0506,d=6"))?;
    read_process(text).map_err(|error| Fault::option("--process", error))
}

/// The loop of `--process` and `--controller`, or of a file.
pub(crate) fn closed_loop(args: &LoopArgs) -> Result<(Process, Controller), Fault> {
    let file = match (&args.file, &args.loop_file) {
        (Some(_), Some(_)) => {
            return Err(Fault::input("--loop: a loop file is given already: must be given once"));
        }
        (one, other) => one.as_ref().or(other.as_ref()),
    };
    let Some(path) = file else {
        let process = process(args.process.as_ref())?;
        let text = args.controller.as_ref();
        let text = text
            .ok_or_else(|| Fault::input("--controller is missing: must be such as -c Kc=2.95,Ti=15,Td=3"))?;
        return Ok((process, read_controller(text).map_err(|error| Fault::option("--controller", error))?));
    };
    for (option, given) in [("--process", &args.process), ("--controller", &args.controller)] {
        if given.is_some() {
            return Err(Fault::option(option, format!("the loop file {} says it already", path.display())));
        }
    }
    read_loop(&text_of(path)?).map_err(|error| Fault::text(path, &error))
}

/// The scenario of the options.
pub(crate) fn scenario(args: &ScenarioArgs, process: &Process) -> Result<Scenario, Fault> {
    scenario_with(args, process, None)
}

/// The scenario of the options where something else happens, too, the last of it at this time [s].
pub(crate) fn scenario_with(
    args: &ScenarioArgs,
    process: &Process,
    other: Option<f64>,
) -> Result<Scenario, Fault> {
    let events = |option: &str, given: &Option<String>| match given {
        Some(text) => read_events(option, text).map_err(Fault::input),
        None => Ok(Vec::new()),
    };
    let (mut setpoint, load) = (events("--setpoint", &args.setpoint)?, events("--load", &args.load)?);
    let initial =
        args.initial.as_ref().map_or(Ok(0.0), |text| read_number("--initial", text)).map_err(Fault::input)?;
    if setpoint.is_empty() && load.is_empty() {
        setpoint.push((0.0, if other.is_some() { initial } else { 1.0 }));
    }
    let events = setpoint.iter().chain(&load).map(|(time, _)| *time);
    let last = events.chain(other).fold(0.0, f64::max);
    let horizon = match &args.horizon {
        Some(text) => read_time("--horizon", text).map_err(Fault::input)?,
        None => last + DEAD_TIMES * process.dead_time(),
    };
    Scenario::new(setpoint, load, Seconds(horizon), initial).map_err(Fault::input)
}
