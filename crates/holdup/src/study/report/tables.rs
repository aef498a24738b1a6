//! The tables of a report: numbers rounded for reading, units in the headings.

use super::ReportError;
use crate::analysis::frequency::Margins;
use crate::analysis::metrics::{METRICS, Metric, Metrics};
use crate::model::{Radians, Seconds};
use crate::study::figures::page::{Column, Table};
use crate::study::published::{Cell, Reproduction};
use crate::study::{ControllerResult, FamilyResult, PercentOfBest, Row, ScenarioResult, StudyResult};

/// A number to five significant digits; a dash where there is none.
pub(super) fn number(value: Option<f64>) -> String {
    match value {
        None => "–".to_owned(),
        Some(0.0) => "0".to_owned(),
        Some(x) if !x.is_finite() => "–".to_owned(),
        Some(x) => {
            let decimals = (0..10).find(|&decimals| x.abs() * 10_f64.powi(decimals) >= 1e4).unwrap_or(10);
            let decimals = usize::try_from(decimals).unwrap_or_default();
            if x.abs() < 1e-5 || x.abs() >= 1e7 { format!("{x:.3e}") } else { format!("{x:.decimals$}") }
        }
    }
}

fn table(
    caption: &str,
    words: &[&str],
    numbers: &[String],
    rows: Vec<Vec<String>>,
) -> Result<Table, ReportError> {
    let columns = words
        .iter()
        .map(|name| ((*name).to_owned(), Column::Words))
        .chain(numbers.iter().map(|name| (name.clone(), Column::Numbers)))
        .collect();
    Ok(Table::new(caption, columns, rows)?)
}

/// The heading of a metric's column, its unit in brackets.
fn heading(name: &str, unit: &str) -> String {
    let name = match name {
        "iae" | "ise" | "itae" => name.to_uppercase(),
        "settling_time_s" => "settling time 2 %".to_owned(),
        "settling_time_5_s" => "settling time 5 %".to_owned(),
        _ => name.strip_suffix("_s").unwrap_or(name).replace('_', " "),
    };
    match unit {
        "s" | "ratio" => format!("{name} [{unit}]"),
        _ => name,
    }
}

/// Settings of every controller.
pub(super) fn settings(controllers: &[ControllerResult]) -> Result<Table, ReportError> {
    let columns = ["Kc", "Ti [s]", "Td [s]", "N [rad/s]", "Ko", "b", "c", "noise gain"].map(str::to_owned);
    let rows = controllers
        .iter()
        .map(|result| {
            let mut row = vec![result.name.clone(), result.rule.unwrap_or("given").to_owned()];
            let c = result.chosen.as_ref();
            let filter = c.and_then(crate::model::Controller::derivative_filter);
            row.extend(
                [
                    c.map(crate::model::Controller::proportional_gain),
                    c.and_then(crate::model::Controller::integral_time),
                    c.and_then(crate::model::Controller::derivative_time),
                    filter.map(crate::model::DerivativeFilter::bandwidth),
                    c.and_then(crate::model::Controller::observer).map(|o| o.gain()),
                    c.map(crate::model::Controller::setpoint_weight),
                    c.map(crate::model::Controller::derivative_setpoint_weight),
                    result.noise_gain,
                ]
                .map(number),
            );
            row
        })
        .collect();
    table("Settings, ideal form", &["controller", "rule"], &columns, rows)
}

/// Margins under these names.
pub(super) fn margins(caption: &str, loops: &[(String, &Margins)]) -> Result<Table, ReportError> {
    let columns = [
        "gain margin",
        "lower gain margin",
        "phase margin [°]",
        "delay margin [s]",
        "M_s",
        "M_t",
        "gain crossover [rad/s]",
        "|L(j∞)|",
    ]
    .map(str::to_owned);
    let rows = loops
        .iter()
        .map(|(name, m)| {
            let stable = if m.stable { "stable" } else { "UNSTABLE" };
            let mut row = vec![name.clone(), stable.to_owned()];
            row.extend(
                [
                    m.gain_margin,
                    m.gain_margin_low,
                    m.phase_margin.map(Radians::degrees),
                    m.delay_margin.map(|Seconds(t)| t),
                    m.sensitivity_peak,
                    m.complementary_sensitivity_peak,
                    m.gain_crossovers.last().copied(),
                    Some(m.high_frequency_gain),
                ]
                .map(number),
            );
            row
        })
        .collect();
    table(caption, &["loop", "verdict"], &columns, rows)
}

/// What was specified beside what is achieved, for every controller that a rule with a specification made.
pub(super) fn specified(study: &StudyResult) -> Result<Option<Table>, ReportError> {
    let mut rows = Vec::new();
    for result in &study.controllers {
        let (Some(asked), Some(achieved)) = (&result.specification, &result.achieved) else { continue };
        let runs = study.scenarios.iter().flat_map(|s| &s.rows).filter(|r| r.controller == result.name);
        let settled = runs.filter_map(|r| r.metrics.settling_time).map(|Seconds(t)| t).next();
        let pairs = [
            ("gain margin", asked.gain_margin, achieved.gain_margin),
            (
                "phase margin [°]",
                asked.phase_margin.map(f64::to_degrees),
                achieved.phase_margin.map(Radians::degrees),
            ),
            ("M_s", asked.sensitivity_peak, achieved.sensitivity_peak),
            ("settling time to 2 % [s]", asked.settling_time, settled),
        ];
        for (what, asked, achieved) in pairs {
            if asked.is_some() {
                rows.push(vec![result.name.clone(), what.to_owned(), number(asked), number(achieved)]);
            }
        }
    }
    if rows.is_empty() {
        return Ok(None);
    }
    let columns = ["specified", "achieved"].map(str::to_owned);
    Ok(Some(table("Specified and achieved", &["controller", "quantity"], &columns, rows)?))
}

/// Metrics of every controller on a scenario, those that the scenario has.
pub(super) fn metrics(scenario: &ScenarioResult) -> Result<Table, ReportError> {
    let lines: Vec<(String, &Metrics)> = scenario.rows.iter().flat_map(Row::lines).collect();
    let has = |metric: &&Metric| lines.iter().any(|(_, metrics)| (metric.value)(metrics).is_some());
    let used: Vec<&Metric> = METRICS.iter().filter(has).collect();
    let columns: Vec<String> = used.iter().map(|m| heading(m.name, m.unit)).collect();
    let row = |(name, metrics): &(String, &Metrics)| {
        let values = used.iter().map(|m| number((m.value)(metrics)));
        std::iter::once(name.clone()).chain(values).collect()
    };
    table(&scenario.name, &["controller"], &columns, lines.iter().map(row).collect())
}

/// How near every controller comes to the best possible; `None` where no bound is known.
pub(super) fn percent_of_best(scenario: &ScenarioResult) -> Result<Option<Table>, ReportError> {
    let Some(bounds) = scenario.rows.first().map(|row| &row.bounds) else { return Ok(None) };
    let of = |best: &PercentOfBest| [best.iae, best.ise, best.itae, best.peak];
    let known: Vec<(usize, String)> =
        [("IAE", bounds.iae), ("ISE", bounds.ise), ("ITAE", bounds.itae), ("peak", bounds.peak)]
            .into_iter()
            .enumerate()
            .filter_map(|(index, (name, bound))| Some((index, format!("{name} ≥ {}", number(Some(bound?))))))
            .collect();
    if known.is_empty() {
        return Ok(None);
    }
    let row = |row: &Row| {
        let percents = known.iter().map(|(index, _)| {
            of(&row.percent_of_best)[*index].map_or_else(|| "–".to_owned(), |p| format!("{p:.1} %"))
        });
        std::iter::once(row.controller.clone()).chain(percents).collect()
    };
    let columns: Vec<String> = known.iter().map(|(_, name)| name.clone()).collect();
    let rows = scenario.rows.iter().map(row).collect();
    Ok(Some(table(
        "Percent of the best possible, with the bound that no controller beats",
        &["controller"],
        &columns,
        rows,
    )?))
}

/// A family: what was asked for beside what came out.
pub(super) fn family(family: &FamilyResult) -> Result<Table, ReportError> {
    let columns =
        ["Kc", "Td [s]", "settling time [s]", "overshoot [–]", "gain margin", "phase margin [°]", "M_s"]
            .map(str::to_owned);
    let rows = family
        .members
        .iter()
        .map(|member| {
            let result = &member.controller;
            let (metrics, margins) = (member.run.as_ref().map(|r| &r.metrics), result.achieved.as_ref());
            let mut row = vec![format!("{} = {}", family.vary, member.value)];
            row.extend(
                [
                    result.chosen.as_ref().map(crate::model::Controller::proportional_gain),
                    result.chosen.as_ref().and_then(crate::model::Controller::derivative_time),
                    metrics.and_then(|m| m.settling_time).map(|Seconds(t)| t),
                    metrics.and_then(|m| m.overshoot),
                    margins.and_then(|m| m.gain_margin),
                    margins.and_then(|m| m.phase_margin).map(Radians::degrees),
                    margins.and_then(|m| m.sensitivity_peak),
                ]
                .map(number),
            );
            row
        })
        .collect();
    table(&family.name, &["asked"], &columns, rows)
}

/// Every printed cell of a paper beside the computed value.
pub(super) fn cells(reproduction: &Reproduction) -> Result<Vec<Table>, ReportError> {
    let mut names: Vec<&str> = reproduction.cells.iter().map(|c| c.table.as_str()).collect();
    names.dedup();
    names
        .into_iter()
        .map(|name| {
            let of_table: Vec<&Cell> = reproduction.cells.iter().filter(|c| c.table == name).collect();
            let rows = of_table
                .iter()
                .map(|c| {
                    vec![
                        format!("{} {}", c.row, c.column),
                        c.verdict.word().to_owned(),
                        c.convention.clone(),
                        c.reason.clone().unwrap_or_default(),
                        c.printed.to_string(),
                        number(Some(c.computed)),
                    ]
                })
                .collect();
            let columns = ["printed", "computed"].map(str::to_owned);
            table(name, &["cell", "verdict", "convention", "reason"], &columns, rows)
        })
        .collect()
}
