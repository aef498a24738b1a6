//! The page of an identification: record, fit, controller, load, before and after.

use super::figures::page::{Column, Page, Section, Table};
use super::figures::{Axis, Figure, FigureError, Line, Panel, Series, Tone};
use super::report::ReportError;
use crate::record::wording::{four, three};
use crate::record::{Identification, LoadStep, Record, Retuning};

/// Points of a curve at most: a page stays light, and a screen shows no more.
const POINTS: usize = 4000;

/// The page of an answer for a record of this name.
///
/// # Errors
/// [`ReportError`] if a figure cannot be drawn.
pub fn record_report(
    name: &str,
    record: &Record,
    answer: &Identification,
    retuning: Option<&Retuning>,
) -> Result<Page, ReportError> {
    // The reason of the choice begins with the kind that was chosen.
    let model =
        if answer.model.is_some() { format!("model {}", answer.choice) } else { "no model".to_owned() };
    let mut page = Page::new(format!("Identification of {name}"))
        .with_introduction(format!("Verdict: {}; {model}.", answer.verdict.word()))
        .with_section(Section::new("Why").with_list(answer.reasons.clone()))
        .with_section(Section::new("Result").with_table(result(answer)?))
        .with_section(Section::new("The record").with_figure(data(record, answer)?));
    if answer.load.is_some() || !answer.load_steps.is_empty() {
        page = page.with_section(load(answer)?);
    }
    if !answer.diagnosis.findings.is_empty() {
        page = page.with_section(Section::new("Diagnosis").with_list(answer.diagnosis.findings.clone()));
    }
    if let Some(test) = &answer.test {
        page = page.with_section(Section::new("A test that would help").with_paragraph(test.text()));
    }
    if let Some(retuning) = retuning {
        page = page.with_section(tuning(record, retuning)?);
    }
    Ok(page)
}

/// The load over time, where it is known, and its sudden changes.
fn load(answer: &Identification) -> Result<Section, ReportError> {
    let mut section = Section::new("Load");
    if let Some(load) = &answer.load {
        let window = three(load.window);
        section = section
            .with_paragraph(format!("Each value is a mean over {window} s: faster loads are not seen."));
    }
    if !answer.load_steps.is_empty() {
        section = section.with_list(answer.load_steps.iter().map(LoadStep::text).collect());
    }
    let Some(load) = &answer.load else { return Ok(section) };
    let panel = Panel::new(Axis::linear("time [s]"), Axis::linear("load at the process input"))
        .with_series(curve("load", &load.time, &load.load)?);
    Ok(section.with_figure(Figure::new("The load that explains the rest", vec![panel])?))
}

/// A curve, thinned.
fn curve(name: &str, time: &[f64], values: &[f64]) -> Result<Series, FigureError> {
    let every = time.len().div_ceil(POINTS).max(1);
    let thin = |values: &[f64]| values.iter().step_by(every).copied().collect::<Vec<f64>>();
    Ok(Series::new(name, thin(time), thin(values))?.with_line(Line::Solid))
}

fn data(record: &Record, answer: &Identification) -> Result<Figure, FigureError> {
    let time = record.time();
    let axis = || Axis::linear("time [s]");
    let mut output = Panel::new(axis(), Axis::linear("controlled variable"));
    if let Some(setpoint) = record.setpoint() {
        output = output.with_series(curve("setpoint", time, setpoint)?.held().with_tone(Tone::Neutral));
    }
    output = output.with_series(curve("controlled variable", time, record.controlled_variable())?);
    let mut panels = Vec::new();
    if let Some(fit) = answer.fit.as_ref().filter(|_| answer.process.is_some()) {
        output = output.with_series(curve("model", &fit.time, &fit.model)?.with_line(Line::Dashed));
        panels.push(output);
        panels.push(Panel::new(axis(), Axis::linear("left by the model")).with_series(curve(
            "residual",
            &fit.time,
            &fit.residual,
        )?));
    } else {
        panels.push(output);
    }
    panels.push(
        Panel::new(axis(), Axis::linear("manipulated variable"))
            .with_series(curve("manipulated variable", time, record.manipulated_variable())?.held()),
    );
    Figure::new("Record and fit", panels)
}

fn result(answer: &Identification) -> Result<Table, ReportError> {
    let mut rows = Vec::new();
    let mut add = |name: &str, value: f64, interval: Option<[f64; 2]>| {
        let [low, high] = interval.map_or_else(Default::default, |ends| ends.map(four));
        rows.push(vec![name.to_owned(), four(value), low, high]);
    };
    if let (Some(process), Some(confidence)) = (&answer.process, &answer.confidence) {
        add("process gain K", process.process_gain, Some(confidence.process_gain));
        add("dead time d [s]", process.dead_time, Some(confidence.dead_time));
        if let Some(lag) = process.lag {
            add("lag T [s]", lag, confidence.lag);
        }
    }
    if let Some(running) = &answer.controller {
        let gain = running.proportional_gain;
        add("running controller: proportional gain Kc", gain.value, Some(gain.interval));
        if let Some(time) = running.integral_time {
            add("running controller: integral time Ti [s]", time.value, Some(time.interval));
        }
        if let Some(time) = running.derivative_time {
            add("running controller: derivative time Td [s]", time.value, Some(time.interval));
        }
    }
    let columns = ["", "best", "95 %: from", "to"]
        .map(|name| (name.to_owned(), if name.is_empty() { Column::Words } else { Column::Numbers }));
    Ok(Table::new("Values and intervals", columns.to_vec(), rows)?)
}

fn tuning(record: &Record, retuning: &Retuning) -> Result<Section, ReportError> {
    let controller = &retuning.tuning.controller;
    let settings = format!(
        "{} by {}: Kc = {}{}; {}. Sensitivity peak {} at the best values, {} at the worst of {} points of the joint 95 % \
         region (tried, not proven).",
        controller.structure(),
        retuning.tuning.rule,
        four(controller.proportional_gain()),
        controller.integral_time().map_or_else(String::new, |time| format!(", Ti = {} s", four(time))),
        retuning.choice,
        retuning.nominal.sensitivity_peak.map_or_else(|| "–".to_owned(), |peak| format!("{peak:.3}")),
        retuning.worst.sensitivity_peak.map_or_else(|| "unstable".to_owned(), |peak| format!("{peak:.3}")),
        retuning.worst.points,
    );
    let time = record.time();
    let axis = || Axis::linear("time [s]");
    let mut output = Panel::new(axis(), Axis::linear("controlled variable"));
    let mut input = Panel::new(axis(), Axis::linear("manipulated variable"));
    let runs = [("as recorded", &retuning.recorded), ("recommended", &retuning.after)];
    let mut rows = Vec::new();
    for (name, replay) in runs {
        output = output.with_series(curve(name, time, &replay.controlled_variable)?);
        input = input.with_series(curve(name, time, &replay.manipulated_variable)?.held());
        let values = [replay.standard_deviation, replay.peak, replay.travel];
        rows.push(std::iter::once(name.to_owned()).chain(values.map(four)).collect());
    }
    let columns = ["the same load again", "error, std. dev.", "peak", "valve travel"];
    let columns = columns
        .iter()
        .enumerate()
        .map(|(k, name)| ((*name).to_owned(), if k == 0 { Column::Words } else { Column::Numbers }));
    Ok(Section::new("Before and after")
        .with_paragraph(settings)
        .with_table(Table::new("Before and after", columns.collect(), rows)?)
        .with_figure(Figure::new("The record run again", vec![output, input])?))
}
