//! The report of a study: one page of figures and tables that works offline. A view of the result, no more.

pub mod plots;
mod tables;

use thiserror::Error;

use self::plots::Curve;
use super::figures::FigureError;
use super::figures::page::{Page, RowLength, Section};
use super::published::Reproduction;
use super::{ControllerResult, StudyResult};
use crate::analysis::frequency::{FrequencyError, loop_without_observer, margins, observer_loop};
use crate::analysis::response::ResponseError;
use crate::analysis::response::sampled::SampledError;
use crate::model::{ClosedLoop, Controller, ModelError, Process};

/// Why a report could not be composed.
#[derive(Debug, Error)]
pub enum ReportError {
    /// A figure holds what cannot be drawn.
    #[error(transparent)]
    Figure(#[from] FigureError),
    /// A table is not a table.
    #[error(transparent)]
    Table(#[from] RowLength),
    /// A loop cannot be analysed.
    #[error(transparent)]
    Frequency(#[from] FrequencyError),
    /// A loop cannot be simulated.
    #[error(transparent)]
    Response(#[from] ResponseError),
    /// A sampled loop cannot be simulated.
    #[error(transparent)]
    Sampled(#[from] SampledError),
    /// An observer cannot stand alone.
    #[error(transparent)]
    Model(#[from] ModelError),
}

/// The report of a study, with the judgement of the paper it recomputes where there is one.
///
/// # Errors
/// [`ReportError`] if a loop cannot be drawn.
pub fn report(
    process: &Process,
    result: &StudyResult,
    reproduction: Option<&Reproduction>,
) -> Result<Page, ReportError> {
    let mut page = Page::new(result.title.clone()).with_introduction(introduction(process, result));
    if let Some(reproduction) = reproduction {
        page = page.with_section(findings(reproduction));
    }
    page = page.with_section(controllers(result)?);
    for scenario in &result.scenarios {
        let drawn =
            |name: &str| !scenario.sampled.alone() && scenario.rows.iter().any(|row| row.controller == name);
        let curves = curves_of(process, result, drawn);
        let mut section = Section::new(scenario.name.clone());
        if let Some(about) = &scenario.about {
            section = section.with_paragraph(about.clone());
        }
        let sampled = scenario.sampled.trajectories(&scenario.scenario, plots::POINTS)?;
        let figure = plots::response_with(&scenario.name, &scenario.scenario, &curves, sampled)?;
        section = section.with_figure(figure);
        if !scenario.load.is_empty() {
            let title = format!("{}: load and its estimate", scenario.name);
            if let Some(figure) = plots::load_estimate(&title, &scenario.scenario, &curves)? {
                section = section.with_figure(figure);
            }
        }
        section = section.with_table(tables::metrics(scenario)?);
        if let Some(table) = tables::percent_of_best(scenario)? {
            section = section.with_table(table);
        }
        let reasons = scenario.rows.first().map(|r| r.bounds.reasons.clone()).unwrap_or_default();
        if !reasons.is_empty() {
            section = section.with_list(reasons);
        }
        page = page.with_section(section);
    }
    for family in &result.families {
        page = page.with_section(family_section(process, result, family)?);
    }
    page = page.with_section(frequency(process, result)?);
    for controller in &result.controllers {
        if let Some(chosen) = &controller.chosen {
            page = page.with_section(one_loop(process, controller, chosen)?);
        }
    }
    if let Some(reproduction) = reproduction {
        page = page.with_section(printed(reproduction)?);
    }
    Ok(page)
}

fn introduction(process: &Process, result: &StudyResult) -> String {
    let mut text = format!(
        "Process gain {} output units per input unit and second, dead time {} s. Every number is exact: the dead \
         time is not approximated.",
        process.process_gain(),
        process.dead_time()
    );
    if let Some(about) = &result.about {
        text = format!("{about} {text}");
    }
    text
}

fn findings(reproduction: &Reproduction) -> Section {
    let summary = &reproduction.summary;
    let mut section = Section::new("Findings").with_paragraph(format!(
        "{}: of {} printed cells {} are reproduced, {} close, {} not reproduced, {} impossible.",
        reproduction.paper,
        summary.cells,
        summary.reproduced,
        summary.close,
        summary.not_reproduced,
        summary.impossible
    ));
    for (index, finding) in reproduction.findings.iter().enumerate() {
        section = section.with_paragraph(format!("{}. {}. {}", index + 1, finding.title, finding.text));
        if !finding.points.is_empty() {
            section = section.with_list(finding.points.clone());
        }
    }
    section
}

fn controllers(result: &StudyResult) -> Result<Section, ReportError> {
    let of = |c: &'_ ControllerResult| c.name.clone();
    let achieved: Vec<_> = result
        .controllers
        .iter()
        .flat_map(|c| {
            let sampled = c.achieved_sampled.iter().map(|margins| (format!("{}, sampled", of(c)), margins));
            c.achieved.iter().map(|margins| (of(c), margins)).chain(sampled)
        })
        .collect();
    let mut section = Section::new("Controllers")
        .with_table(tables::settings(&result.controllers)?)
        .with_table(tables::margins("Achieved, loop broken at the process input", &achieved)?);
    if let Some(table) = tables::specified(result)? {
        section = section.with_table(table);
    }
    if !result.warnings.is_empty() {
        section = section.with_list(result.warnings.clone());
    }
    Ok(section)
}

fn family_section(
    process: &Process,
    result: &StudyResult,
    family: &super::FamilyResult,
) -> Result<Section, ReportError> {
    let curves: Vec<Curve> = family
        .members
        .iter()
        .filter_map(|m| {
            let closed_loop = ClosedLoop::new(process, m.controller.chosen.as_ref()?);
            Some(Curve { name: format!("{} = {}", family.vary, m.value), closed_loop })
        })
        .collect();
    let mut section = Section::new(family.name.clone());
    if let Some(about) = &family.about {
        section = section.with_paragraph(about.clone());
    }
    if let Some(scenario) = result.scenarios.iter().find(|s| s.name == family.scenario) {
        section = section.with_figure(plots::response(&family.name, &scenario.scenario, &curves)?);
    }
    Ok(section.with_table(tables::family(family)?))
}

fn frequency(process: &Process, result: &StudyResult) -> Result<Section, ReportError> {
    let curves = curves_of(process, result, |_| true);
    Ok(Section::new("Frequency response of all loops")
        .with_figure(plots::nyquist("Nyquist plot, loops broken at the process input", &curves, 2.0)?)
        .with_figure(plots::bode("Bode plot, loops broken at the process input", &curves)?))
}

/// One loop on its own; with an observer, the loop without it, the observer's own loop and the whole.
fn one_loop(
    process: &Process,
    result: &ControllerResult,
    controller: &Controller,
) -> Result<Section, ReportError> {
    let whole = Curve { name: "whole loop".to_owned(), closed_loop: ClosedLoop::new(process, controller) };
    let mut curves = vec![whole];
    if let Some(observer) = observer_loop(process, controller)? {
        let name = format!("{} loop", controller.without_observer().structure());
        curves.push(Curve { name, closed_loop: loop_without_observer(process, controller) });
        curves.push(Curve { name: "observer loop".to_owned(), closed_loop: observer });
    }
    let achieved = curves.iter().map(|c| margins(&c.closed_loop)).collect::<Result<Vec<_>, _>>()?;
    let named: Vec<_> = curves.iter().map(|c| c.name.clone()).zip(&achieved).collect();
    let peak = achieved.first().and_then(|m| m.sensitivity_peak).unwrap_or(2.0);
    Ok(Section::new(format!("Loop of {}", result.name))
        .with_table(tables::margins(&result.name, &named)?)
        .with_figure(plots::nyquist(&format!("Nyquist plot: {}", result.name), &curves, peak)?)
        .with_figure(plots::bode(&format!("Bode plot: {}", result.name), &curves)?))
}

fn printed(reproduction: &Reproduction) -> Result<Section, ReportError> {
    let mut section = Section::new("Every printed cell, recomputed");
    for table in tables::cells(reproduction)? {
        section = section.with_table(table);
    }
    Ok(section)
}

fn curves_of(process: &Process, result: &StudyResult, wanted: impl Fn(&str) -> bool) -> Vec<Curve> {
    result
        .controllers
        .iter()
        .filter(|c| wanted(&c.name))
        .filter_map(|c| {
            let closed_loop = ClosedLoop::new(process, c.chosen.as_ref()?);
            Some(Curve { name: c.name.clone(), closed_loop })
        })
        .collect()
}
