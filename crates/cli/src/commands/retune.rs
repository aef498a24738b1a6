//! `holdup identify --tune`: the new tuning, its margins over the confidence region, before and after.

use holdup::model::description::ControllerDescription;
use holdup::record::{Identification, Replay, Retuning, running_controller};
use serde_json::{Value, json};

use super::identify::list;
use super::view::{controller_line, process_line};
use crate::console::Console;
use crate::table::{number, table, title};

/// The tuning for programs.
pub(super) fn json_of(retuning: &Retuning) -> Value {
    json!({
        "rule": retuning.tuning.rule,
        "choice": retuning.choice,
        "controller": ControllerDescription::from(&retuning.tuning.controller),
        "achieved": retuning.nominal,
        "worst": retuning.worst,
        "replay": {
            "recorded": retuning.recorded,
            "before": retuning.before,
            "after": retuning.after,
        },
    })
}

/// The tuning for people.
pub(super) fn text(retuning: &Retuning, answer: &Identification, console: Console) -> String {
    let mut text = title(console, &format!("Recommended {}", controller_line(&retuning.tuning.controller)));
    text += &format!("by {} on {}\n", retuning.tuning.rule, process_line(&retuning.process));
    text += &list(console, std::slice::from_ref(&retuning.choice));
    if let Some(running) = answer.controller.as_ref().and_then(running_controller) {
        text += &format!("Now: {}\n", controller_line(&running));
    }
    text.push('\n');
    let (nominal, worst) = (&retuning.nominal, &retuning.worst);
    let rows = vec![
        vec![
            "stable".to_owned(),
            if nominal.stable { "yes" } else { "no" }.to_owned(),
            if worst.stable { "yes" } else { "no" }.to_owned(),
        ],
        vec![
            "sensitivity peak M_s [–]".to_owned(),
            number(nominal.sensitivity_peak),
            number(worst.sensitivity_peak),
        ],
        vec!["gain margin [–]".to_owned(), number(nominal.gain_margin), number(worst.gain_margin)],
        vec![
            "phase margin [°]".to_owned(),
            number(nominal.phase_margin.map(holdup::model::Radians::degrees)),
            number(worst.phase_margin_deg),
        ],
    ];
    text += &table(console, &["margins", "best values", "worst of the region"], &rows);
    text += &format!(
        "The worst of {} points of the joint 95 % region, searched closer about it (not a proof): K = {}, d = {} s.\n\n",
        worst.points,
        number(worst.process_gain),
        number(worst.dead_time_s)
    );
    let row = |name: &str, replay: &Replay| {
        vec![name.to_owned(), number(replay.standard_deviation), number(replay.peak), number(replay.travel)]
    };
    let mut rows = vec![row("as recorded", &retuning.recorded)];
    rows.extend(retuning.before.as_ref().map(|before| row("replay, controller of today", before)));
    rows.push(row("replay, recommended", &retuning.after));
    text += &table(console, &["the same load again", "error, std. dev.", "peak", "valve travel"], &rows);
    text
}
