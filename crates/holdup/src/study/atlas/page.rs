//! The atlas as one HTML page that works offline: the plane, the tables, a section for each rule.

use super::{Atlas, AtlasRule, FIGURES, digits, process_words};
use crate::model::{Process, Seconds};
use crate::study::figures::page::{Column, Page, Section, Table};
use crate::study::figures::{Axis, Figure, Line, Mark, Panel, Reference, Series, Tone};
use crate::study::report::ReportError;
use crate::tuning::optimise::{Limits, Objective, Point, Structure, trade_off};
use crate::tuning::{Applies, Default, Judgement, Parameter, Status};

/// The sensitivity peaks of the frontiers.
const PEAKS: [f64; 14] = [1.1, 1.15, 1.2, 1.25, 1.3, 1.4, 1.5, 1.6, 1.7, 1.85, 2.0, 2.25, 2.6, 3.0];

/// What the plane shows: beyond it lie fragile loops and loops that hardly reject loads.
const PEAK_RANGE: (f64, f64) = (1.0, 3.5);
const IAE_RANGE: (f64, f64) = (0.4, 300.0);

/// The atlas as a page; computes the frontiers, which takes some seconds.
///
/// # Errors
/// [`ReportError`] if a value cannot be drawn.
pub fn page(atlas: &Atlas) -> Result<Page, ReportError> {
    let mut page = Page::new("The rule atlas").with_introduction(format!(
        "{} tuning rules for integrating processes with dead time, recomputed exactly: the dead time is not \
         approximated, integrals are those of unit steps over all time. 100 % is what no controller beats.",
        atlas.rules.len()
    ));
    page = page.with_section(plane_section(atlas)?);
    for applies in Applies::ALL {
        let rules: Vec<&AtlasRule> =
            atlas.rules.iter().filter(|rule| rule.entry.process == applies).collect();
        if !rules.is_empty() {
            let section = Section::new(format!("All rules, {}", applies.name()));
            page = page.with_section(section.with_table(all(process_words(applies), &rules)?));
        }
    }
    for rule in &atlas.rules {
        page = page.with_section(one(rule)?);
    }
    Ok(page)
}

fn plane_section(atlas: &Atlas) -> Result<Section, ReportError> {
    let (pi, pid) = rayon::join(|| frontier(Structure::Pi), || frontier(Structure::Pid));
    let section = Section::new("Load rejection against robustness")
        .with_paragraph(
            "Every recommended rule for the plain integrator (K = 1, d = 1 s) that rejects a constant load and whose \
             loop is stable, with the defaults of its parameters. Left is robust, down is fast. Hover over a point \
             for its name; click a structure in the legend to hide it, double-click to see it alone.",
        )
        .with_figure(plane(atlas, &pi, &pid)?)
        .with_paragraph(
            "The frontiers are the least load IAE of any PI and of any ideal PID controller (derivative unfiltered) \
             at a sensitivity peak, found by a search from many starts, not proven. 0.5 is the bound that no controller beats. \
             Rules above the range of the picture or right of it are in the tables.",
        );
    let row = |best: &Point| {
        let controller = &best.controller;
        vec![
            controller.structure().to_owned(),
            digits(Some(best.sensitivity_peak)),
            digits(Some(best.value)),
            digits(Some(50.0 / best.value)),
            digits(Some(controller.proportional_gain())),
            digits(controller.integral_time()),
            digits(controller.derivative_time()),
        ]
    };
    let heading = ["best of", "M_s allowed", "load IAE", "load %", "K·Kc·d", "Ti/d", "Td/d"];
    let columns = columns(&heading, 1);
    let table = Table::new("The frontiers", columns, pi.iter().chain(&pid).map(row).collect())?;
    Ok(section.with_table(table))
}

/// The best load IAE of a structure for each sensitivity peak, K = 1 and d = 1 s.
fn frontier(structure: Structure) -> Vec<Point> {
    let found = Process::integrating(1.0, Seconds(1.0)).ok().and_then(|process| {
        trade_off(&process, structure, Objective::LoadIae, &Limits::default(), &PEAKS).ok()
    });
    found.unwrap_or_default()
}

fn plane(atlas: &Atlas, pi: &[Point], pid: &[Point]) -> Result<Figure, ReportError> {
    let x = Axis::linear("sensitivity peak M_s [–]").with_range(PEAK_RANGE.0, PEAK_RANGE.1)?;
    let y = Axis::logarithmic("load IAE / (K·d²) [–]").with_range(IAE_RANGE.0, IAE_RANGE.1)?;
    let mut panel = Panel::new(x, y).with_reference(Reference::horizontal(0.5, "no controller below 0.5")?);
    for (index, structure) in
        ["PI", "PID", "PD+DOB", "SP+DOB", "2DOF-DTC", "P+inverse-DOB"].into_iter().enumerate()
    {
        let best = match structure {
            "PI" => pi,
            "PID" => pid,
            _ => &[],
        };
        if !best.is_empty() {
            let (peaks, iae) = best.iter().map(|best| (best.sensitivity_peak, best.value)).unzip();
            let labels: Vec<String> = best.iter().map(|best| frontier_label(structure, best)).collect();
            let curve = Series::new(format!("best possible {structure}"), peaks, iae)?;
            let line = if index == 0 { Line::Solid } else { Line::Dashed };
            panel =
                panel.with_series(curve.with_labels(&labels)?.with_line(line).with_tone(Tone::Slot(index)));
        }
        let (mut peaks, mut iae, mut labels) = (Vec::new(), Vec::new(), Vec::new());
        for rule in atlas.rules.iter().filter(|rule| shown(rule, structure)) {
            let Ok(figures) = &rule.figures else { continue };
            if let (Some(peak), Some(area)) = (figures.achieved.sensitivity_peak, figures.load_iae()) {
                peaks.push(peak);
                iae.push(area);
                labels.push(format!(
                    "{} ({} {}): M_s {}, load IAE {}, {} % of the best possible",
                    rule.entry.id,
                    rule.entry.authors,
                    rule.entry.year,
                    digits(Some(peak)),
                    digits(Some(area)),
                    digits(figures.load_percent())
                ));
            }
        }
        if !peaks.is_empty() {
            let series = Series::new(format!("{structure} rules"), peaks, iae)?.with_labels(&labels)?;
            panel = panel.with_series(series.as_marks(Mark::Disc).with_tone(Tone::Slot(index)));
        }
    }
    Ok(Figure::new("Load IAE against sensitivity peak", vec![panel])?)
}

fn shown(rule: &AtlasRule, structure: &str) -> bool {
    let entry = rule.entry;
    entry.structure == structure
        && entry.process == Applies::Integrating
        && entry.status == Status::Recommended
}

fn frontier_label(structure: &str, best: &Point) -> String {
    let controller = &best.controller;
    let derivative =
        controller.derivative_time().map_or_else(String::new, |td| format!(", Td/d {}", digits(Some(td))));
    format!(
        "best possible {structure} at M_s {}: load IAE {}, K·Kc·d {}, Ti/d {}{derivative}",
        best.sensitivity_peak,
        digits(Some(best.value)),
        digits(Some(controller.proportional_gain())),
        digits(controller.integral_time())
    )
}

fn columns(heading: &[&str], words: usize) -> Vec<(String, Column)> {
    let kind = |index| if index < words { Column::Words } else { Column::Numbers };
    heading.iter().enumerate().map(|(index, name)| ((*name).to_owned(), kind(index))).collect()
}

/// All rules of a kind of process.
fn all(caption: &str, rules: &[&AtlasRule]) -> Result<Table, ReportError> {
    let last = ["structure", "status", "dominated by", "published", "source"];
    let rows = rules.iter().map(|rule| {
        let entry = rule.entry;
        let dominated = rule.figures.as_ref().ok().and_then(|rule| rule.dominated_by);
        let source = format!("{} {}", entry.authors, entry.year);
        let words =
            [entry.structure, entry.status.word(), dominated.unwrap_or("–"), &rule.verdict(), &source];
        [vec![entry.id.to_owned()], rule.figures(), words.map(str::to_owned).to_vec()].concat()
    });
    let mut heading = columns(&[&["rule"][..], &FIGURES].concat(), 1);
    heading.extend(columns(&last, last.len()));
    Ok(Table::new(caption, heading, rows.collect())?)
}

/// The section of one rule.
fn one(rule: &AtlasRule) -> Result<Section, ReportError> {
    let entry = rule.entry;
    let mut section = Section::new(entry.id)
        .with_paragraph(format!("{}. {} ({}): {}.", entry.name, entry.authors, entry.year, entry.citation));
    if let Some(why) = entry.status.reason() {
        section = section.with_paragraph(format!("{}, not recommended: {why}", entry.status.word()));
    }
    let formula: Vec<String> =
        entry.formula.iter().map(|(name, formula)| format!("{name} = {formula}")).collect();
    section = section.with_code(format!("{}\n{}", entry.form.text(), formula.join("\n")));
    let points = [("", entry.when), ("Limits: ", entry.limits)];
    let mut points: Vec<String> = points
        .iter()
        .filter(|(_, text)| !text.is_empty())
        .map(|(name, text)| format!("{name}{text}"))
        .collect();
    points.push(format!("For a process that is {}.", entry.process.name()));
    points.push(format!("Formula {}; {}.", entry.provenance.text(), entry.source));
    section = section.with_list(points);
    if !entry.parameters.is_empty() {
        let heading = ["parameter", "meaning", "unit", "default", "allowed"];
        let rows = entry.parameters.iter().map(parameter).collect();
        section = section.with_table(Table::new("Parameters", columns(&heading, 5), rows)?);
    }
    section = match &rule.figures {
        Ok(_) => {
            let row = [vec![entry.id.to_owned()], rule.figures()].concat();
            let heading = [&["rule"][..], &FIGURES].concat();
            let caption = format!("Exact figures. {}", process_words(entry.process));
            section.with_table(Table::new(caption, columns(&heading, 1), vec![row])?)
        }
        Err(why) => section.with_paragraph(format!("No exact figures: {why}")),
    };
    if rule.published.is_empty() {
        return Ok(section.with_paragraph("Its source prints no value to compare with."));
    }
    let heading = ["published", "source", "verdict", "printed", "computed"];
    let rows = rule.published.iter().map(published).collect();
    Ok(section.with_table(Table::new("Published values", columns(&heading, 3), rows)?))
}

fn parameter(parameter: &Parameter) -> Vec<String> {
    let default = match parameter.default {
        Default::Number(value) => digits(Some(value)),
        Default::Formula(formula) => formula.to_owned(),
        Default::Absent => "–".to_owned(),
    };
    let (unit, range) = (parameter.unit.symbol(), parameter.range);
    [parameter.name, parameter.description, unit, &default, range].map(str::to_owned).to_vec()
}

fn published(value: &Judgement) -> Vec<String> {
    let verdict = if value.reproduced { "reproduced" } else { "differs" };
    let verdict = match &value.reason {
        Some(reason) => format!("{verdict}: {reason}"),
        None => verdict.to_owned(),
    };
    vec![
        value.what.clone(),
        value.source.clone(),
        verdict,
        value.printed.clone(),
        digits(Some(value.computed)),
    ]
}
