//! The frontier as data, table and picture.

use holdup::analysis::frequency::margins;
use holdup::model::description::ControllerDescription;
use holdup::model::{ClosedLoop, Controller, Process};
use holdup::study::OwnRule;
use holdup::study::figures::{Axis, Figure, FigureError, Mark, Panel, Series, Tone};
use holdup::tuning::optimise::{Objective, Point, Structure, between};
use holdup::tuning::ranking::{ORDERS, rank};
use serde_json::{Value, json};

use super::PEAKS;
use crate::console::Console;
use crate::table::{number, table, title};

/// A point of the frontier.
pub(super) fn point_json(point: &Point) -> Value {
    json!({
        "sensitivity_peak": point.sensitivity_peak,
        "value": point.value,
        "controller": ControllerDescription::from(&point.controller),
    })
}

/// A rule of one's own with what it achieves; the values are absent where its loop is unstable.
pub(super) struct Own {
    rule: OwnRule,
    sensitivity_peak: Option<f64>,
    value: Option<f64>,
}

/// What the rules of a file achieve.
pub(super) fn achieved(
    process: &Process,
    objective: Objective,
    rules: Vec<OwnRule>,
) -> Result<Vec<Own>, String> {
    let of = |rule: OwnRule| {
        let achieved = margins(&ClosedLoop::new(process, &rule.controller))
            .map_err(|error| format!("{}: {error}", rule.name))?;
        let value = if achieved.stable { objective.of(process, &rule.controller) } else { None };
        let sensitivity_peak = achieved.sensitivity_peak.filter(|_| achieved.stable);
        Ok(Own { rule, sensitivity_peak, value })
    };
    rules.into_iter().map(of).collect()
}

/// A rule of one's own.
pub(super) fn own_json(own: &Own) -> Value {
    json!({
        "name": own.rule.name,
        "sensitivity_peak": own.sensitivity_peak,
        "value": own.value,
        "controller": ControllerDescription::from(&own.rule.controller),
    })
}

/// The frontier and the rules of one's own as a table.
pub(super) fn text(points: &[Point], own: &[Own], objective: Objective, console: Console) -> String {
    let row = |name: &str, peak: Option<f64>, value: Option<f64>, controller: &Controller| {
        vec![
            name.to_owned(),
            number(peak),
            number(value),
            number(controller.proportional_gain()),
            number(controller.integral_time()),
            number(controller.derivative_time()),
            number(controller.observer().map(|observer| observer.gain())),
        ]
    };
    let best = points
        .iter()
        .map(|point| row("best", Some(point.sensitivity_peak), Some(point.value), &point.controller));
    let own =
        own.iter().map(|own| row(&own.rule.name, own.sensitivity_peak, own.value, &own.rule.controller));
    let rows: Vec<Vec<String>> = best.chain(own).collect();
    title(console, "What robustness costs")
        + &table(console, &["", "M_s", objective.name(), "Kc", "Ti [s]", "Td [s]", "Ko"], &rows)
}

/// The frontier, and on it the published rules of the same structure and the rules of one's own.
pub(super) fn figure(
    process: &Process,
    structure: Structure,
    objective: Objective,
    points: &[Point],
    own: &[Own],
) -> Result<Figure, FigureError> {
    let (x, y) = between(points);
    let mut panel = Panel::new(Axis::linear("sensitivity peak M_s"), Axis::logarithmic(in_words(objective)));
    let name = format!("best {}", structure.name().to_uppercase());
    panel = panel.with_series(Series::new(name, x, y)?.with_tone(Tone::Slot(0)));
    let ranked = rank(process, &ORDERS[0], |entry| entry.structure.eq_ignore_ascii_case(structure.name()));
    let greatest = PEAKS[PEAKS.len() - 1];
    let published = ranked.rules.iter().filter(|rule| rule.achieved.stable).filter_map(|rule| {
        let value = match objective {
            Objective::LoadIae => rule.load_iae(),
            Objective::SetpointIae => rule.setpoint_iae(),
            _ => objective.of(process, &rule.tuning.controller),
        };
        Some((
            rule.achieved.sensitivity_peak.filter(|peak| *peak <= greatest)?,
            value?,
            rule.entry.id.to_owned(),
        ))
    });
    let of_user =
        own.iter().filter_map(|own| Some((own.sensitivity_peak?, own.value?, own.rule.name.clone())));
    let both = [
        ("published rules", published.collect::<Vec<_>>(), Mark::Disc, Tone::Slot(1)),
        ("your rules", of_user.collect(), Mark::Cross, Tone::Slot(2)),
    ];
    for (name, rules, mark, tone) in both {
        if rules.is_empty() {
            continue;
        }
        let names: Vec<String> = rules.iter().map(|rule| rule.2.clone()).collect();
        let (x, y) = rules.iter().map(|rule| (rule.0, rule.1)).unzip();
        let series = Series::new(name, x, y)?.with_labels(&names)?;
        panel = panel.with_series(series.as_marks(mark).with_tone(tone));
    }
    Figure::new("What robustness costs", vec![panel])
}

/// The objective as the label of an axis.
fn in_words(objective: Objective) -> String {
    let name = objective.name().replace('_', " ").replace("iae", "IAE").replace("ise", "ISE");
    let unit = match objective {
        Objective::LoadIse | Objective::SetpointIse => " [output unit² · s]",
        Objective::ControlEnergy => " [input unit² · s]",
        Objective::TotalVariation => " [input unit]",
        Objective::LoadIae | Objective::SetpointIae | Objective::Weighted { .. } => " [output unit · s]",
        _ => "",
    };
    name + unit
}
