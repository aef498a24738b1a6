//! The actuator's part of `holdup analyse --limits`.

use std::fmt::Write as _;

use holdup::analysis::actuator::{Actuator, Asked, Reach, reach};
use holdup::deploy::conversion::Span;
use holdup::model::quantity::read_number;
use holdup::model::{Controller, Process};

use crate::args::ActuatorArgs;
use crate::console::Console;
use crate::fault::Fault;
use crate::table::{number, table, title};

/// What the actuator allows and is asked for; `None` without `--limits`.
pub(super) fn of(
    args: &ActuatorArgs,
    process: &Process,
    controller: &Controller,
) -> Result<Option<Reach>, Fault> {
    let options = [
        ("--initial-manipulated", &args.initial_manipulated),
        ("--setpoint-step", &args.setpoint_step),
        ("--load-step", &args.load_step),
    ];
    let Some(limits) = &args.limits else {
        return match options.iter().find(|(_, given)| given.is_some()) {
            Some((option, _)) => {
                Err(Fault::option(option, "needs the limits of the actuator: --limits LOW:HIGH"))
            }
            None => Ok(None),
        };
    };
    let limits = Span::read("--limits", limits).map_err(Fault::input)?;
    let value = |index: usize, default: f64| {
        let (option, given): (&str, &Option<String>) = options[index];
        given.as_ref().map_or(Ok(default), |text| read_number(option, text)).map_err(Fault::input)
    };
    // Within the limits and, where they allow it, at the design's own rest.
    let rest = value(0, 0.0_f64.clamp(limits.low(), limits.high()))?;
    if !(limits.low()..=limits.high()).contains(&rest) {
        return Err(Fault::input(format!(
            "--initial-manipulated is {rest}: must be within the limits, {} to {}",
            limits.low(),
            limits.high()
        )));
    }
    let actuator = Actuator::new(limits.low(), limits.high(), rest).map_err(Fault::input)?;
    reach(process, controller, &actuator, value(1, 1.0)?, value(2, 1.0)?).map(Some).map_err(Fault::input)
}

/// A quantity for reading.
type Pick = fn(&Asked) -> String;

/// The section for reading.
pub(super) fn section(console: Console, reach: &Reach) -> String {
    let mut text = format!("\n{}", title(console, "Actuator"));
    let _ = writeln!(
        text,
        " limits {} to {}, at rest {}: loads from {} to {} are held\n",
        number(reach.limits.0),
        number(reach.limits.1),
        number(reach.output_at_rest),
        number(reach.loads_held.0),
        number(reach.loads_held.1)
    );
    let rows: [(&str, Pick); 12] = [
        ("size of the step", |a| number(a.step)),
        ("output asked for at once", |a| a.kick.map_or_else(|| "∞".to_owned(), number)),
        ("least output asked for", |a| number(a.least)),
        ("greatest output asked for", |a| number(a.greatest)),
        ("linear answer in reach", |a| if a.in_reach { "yes" } else { "no" }.to_owned()),
        ("  for steps from", |a| number(a.steps_in_reach.map(|steps| steps.0))),
        ("  to", |a| number(a.steps_in_reach.map(|steps| steps.1))),
        ("best possible: at rest after [s]", |a| number(a.best.at_rest)),
        ("best possible: peak", |a| number(a.best.peak)),
        ("best possible: IAE", |a| number(a.best.iae)),
        ("best possible: ISE", |a| number(a.best.ise)),
        ("best possible: ITAE", |a| number(a.best.itae)),
    ];
    let rows: Vec<Vec<String>> = rows
        .iter()
        .map(|(name, pick)| vec![(*name).to_owned(), pick(&reach.setpoint), pick(&reach.load)])
        .collect();
    text += &table(console, &["", "setpoint step", "load step"], &rows);
    text
}
