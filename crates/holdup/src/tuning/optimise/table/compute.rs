//! How the tables are computed: `cargo test --release -p holdup --lib -- --ignored the_tables_are_computed_anew` writes the file;
//! `the_tables_that_are_missing_are_computed` keeps those that are in it.

use std::fmt::Write as _;

use rayon::prelude::*;

use crate::analysis::frequency::margins;
use crate::model::{ClosedLoop, Controller, Process, Seconds};
use crate::tuning::optimise::curve::Curve;
use crate::tuning::optimise::design::Design;
use crate::tuning::optimise::gain::{Candidate, Gains, POLISHED};
use crate::tuning::optimise::objective::Transients;
use crate::tuning::optimise::progress::Progress;
use crate::tuning::optimise::search::{FINEST, find, search_from};
use crate::tuning::optimise::{Filter, Limits, Objective, Quantity, Structure, Task};

/// What there is a table of, with the weight of the load where there is one.
const TABLES: [(Structure, Objective); 13] = [
    (Structure::P, Objective::SetpointIae),
    (Structure::P, Objective::SetpointIse),
    (Structure::Pi, Objective::LoadIae),
    (Structure::Pi, Objective::SetpointIae),
    (Structure::Pi, Objective::Weighted { load: 0.5 }),
    (Structure::Pi, Objective::LoadIse),
    (Structure::PObserver, Objective::LoadIae),
    (Structure::Pd, Objective::SetpointIae),
    (Structure::Pd, Objective::SetpointIse),
    (Structure::Pid, Objective::LoadIae),
    (Structure::Pid, Objective::Weighted { load: 0.5 }),
    (Structure::Pid, Objective::LoadIse),
    (Structure::Pid, Objective::SetpointIae),
];
/// Ratio of filter time to derivative time.
const RATIO: f64 = 0.1;
/// Ends of the tables, and the knots to begin with.
const ENDS: [f64; 2] = [1.2, 2.5];
const FIRST: u32 = 16;
/// Error of the interpolation of a setting, of the value and of the peak beyond which an interval is halved; and the narrowest
/// that is.
const ENOUGH: [f64; 3] = [5e-4, 1e-5, 2e-5];
const NARROWEST: f64 = 4e-3;
/// Size of the search from a neighbour.
const NEAR: f64 = 0.01;

/// An optimum: its parts for the next search, and a row of the file.
#[derive(Debug, Clone)]
struct Knot {
    peak: f64,
    parts: Vec<f64>,
    row: Vec<f64>,
}

struct Computing {
    design: Design,
    objective: Objective,
}

fn row(candidate: &Candidate) -> Vec<f64> {
    let controller = &candidate.controller;
    let settings = [
        Some(controller.proportional_gain()),
        controller.integral_time(),
        controller.derivative_time(),
        controller.observer().map(|observer| observer.gain()),
        Some(candidate.value),
    ];
    settings.into_iter().flatten().collect()
}

impl Computing {
    fn limits(peak: f64) -> Limits {
        Limits::default().with(Quantity::SensitivityPeak, peak)
    }

    fn searched(&self, peak: f64) -> Knot {
        let found = find(&self.design, self.objective, &Self::limits(peak), &Progress::silent());
        let found = found.expect("every peak of the table is feasible");
        Knot { peak, row: row(&found.best), parts: found.parts }
    }

    /// From both neighbours.
    fn between(&self, peak: f64, neighbours: [&Knot; 2]) -> Knot {
        let limits = Self::limits(peak);
        let gains = Gains::new(&self.design, self.objective, &limits, POLISHED);
        let middle: Vec<f64> = neighbours[0]
            .parts
            .iter()
            .zip(&neighbours[1].parts)
            .map(|(a, b)| f64::midpoint(*a, *b))
            .collect();
        let silent = Progress::silent();
        let end = [&middle, &neighbours[0].parts, &neighbours[1].parts]
            .into_iter()
            .filter_map(|start| {
                let end = search_from(&gains, start, NEAR, FINEST, &mut silent.search(0));
                Some((end.parts, end.best?))
            })
            .min_by(|a, b| a.1.value.total_cmp(&b.1.value));
        match end {
            Some((parts, best)) => Knot { peak, parts, row: row(&best) },
            None => self.searched(peak),
        }
    }

    /// What the interpolation misses: of the settings, of the value (stated, and of the interpolated controller), of the peak.
    fn error(&self, knot: &Knot, curves: &[Curve]) -> [f64; 3] {
        let interpolated: Vec<f64> = curves.iter().map(|curve| curve.at(knot.peak)).collect();
        let off = |index: usize| (interpolated[index] / knot.row[index] - 1.0).abs();
        let last = curves.len() - 1;
        let settings = (0..last).map(off).fold(0.0, f64::max);
        let controller = self.controller(&interpolated);
        let achieved = margins(&ClosedLoop::new(&self.design.process, &controller)).unwrap();
        let excess = (achieved.sensitivity_peak.unwrap() / knot.peak - 1.0).max(0.0);
        let transients = Transients::new(&self.design, &controller);
        let value = self.objective.value(&self.design, &controller, &transients).unwrap();
        [settings, off(last).max((value / knot.row[last] - 1.0).abs()), excess]
    }

    fn controller(&self, row: &[f64]) -> Controller {
        let structure = self.design.structure;
        let mut rest = row.iter().copied();
        let mut next = |there: bool| if there { rest.next() } else { None };
        let [gain, integral_time, derivative_time, observer_gain] =
            [true, structure.integrates(), structure.differentiates(), structure.observes()].map(&mut next);
        let normalised = super::Normalised {
            sensitivity_peak: 2.0,
            gain: gain.unwrap(),
            integral_time,
            derivative_time,
            observer_gain,
            value: 1.0,
        };
        normalised.controller(&self.design.process, self.design.filter).unwrap()
    }

    fn curves(knots: &[Knot]) -> Vec<Curve> {
        let peaks: Vec<f64> = knots.iter().map(|knot| knot.peak).collect();
        (0..knots[0].row.len())
            .map(|index| Curve::new(&peaks, &knots.iter().map(|knot| knot.row[index]).collect::<Vec<_>>()))
            .collect()
    }

    /// Knots that are near enough, and the greatest errors between them.
    fn knots(&self) -> (Vec<Knot>, [f64; 3]) {
        let [low, high] = ENDS.map(|end| (end - 1.0).ln());
        let place = |index: u32| 1.0 + (low + (high - low) * f64::from(index) / f64::from(FIRST)).exp();
        let peak = |index: u32| match index {
            0 => ENDS[0],
            FIRST => ENDS[1],
            _ => (place(index) * 1e4).round() / 1e4,
        };
        let mut knots: Vec<Knot> =
            (0..=FIRST).into_par_iter().map(|index| self.searched(peak(index))).collect();
        // The optimum in the middle of each interval, once it is known.
        let mut middles: Vec<Option<Knot>> = vec![None; knots.len() - 1];
        loop {
            let curves = Self::curves(&knots);
            let middle = |(index, known): (usize, &Option<Knot>)| {
                let pair = [&knots[index], &knots[index + 1]];
                known.clone().unwrap_or_else(|| self.between(f64::midpoint(pair[0].peak, pair[1].peak), pair))
            };
            let found: Vec<Knot> = middles.par_iter().enumerate().map(middle).collect();
            let mut worst = [0.0_f64; 3];
            let (mut next, mut next_middles) = (vec![knots[0].clone()], Vec::new());
            for (index, middle) in found.into_iter().enumerate() {
                let error = self.error(&middle, &curves);
                let enough = error.iter().zip(ENOUGH).all(|(error, enough)| *error <= enough);
                let right = knots[index + 1].clone();
                if enough || right.peak - knots[index].peak <= NARROWEST {
                    (0..3).for_each(|k| worst[k] = worst[k].max(error[k]));
                    next_middles.push(Some(middle));
                } else {
                    next.push(middle);
                    next_middles.extend([None, None]);
                }
                next.push(right);
            }
            if next.len() == knots.len() {
                return (knots, worst);
            }
            (knots, middles) = (next, next_middles);
        }
    }
}

/// The sections of the file by how they begin.
fn sections(text: &str) -> Vec<&str> {
    text.split("\n[[table]]\n").skip(1).collect()
}

/// How the section of a table begins.
fn heading(structure: Structure, objective: Objective) -> String {
    let mut text = format!("structure = \"{}\"\n", structure.name());
    if structure.differentiates() {
        let _ = writeln!(text, "filter_ratio = {RATIO}");
    }
    let _ = writeln!(text, "objective = \"{}\"", objective.name());
    if let Objective::Weighted { load } = objective {
        let _ = writeln!(text, "load_weight = {load:?}");
    }
    text + "error = "
}

/// The section of a table, computed.
fn section(structure: Structure, objective: Objective) -> String {
    let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
    let filter = if structure.differentiates() { Filter::Held(RATIO) } else { Filter::None };
    let task = Task::new(&process, structure, objective, &Computing::limits(1.5)).with_filter(filter);
    let computing = Computing { design: task.design().unwrap(), objective };
    let (knots, worst) = computing.knots();
    // Twice what was met in the middle of the intervals, and no less than what the search leaves.
    let stated = [(worst[0], 2e-4), (worst[1], 1e-6), (worst[2], 1e-6)]
        .map(|(met, least)| rounded_up((2.0 * met).max(least)));
    let mut text = heading(structure, objective);
    let _ = write!(text, "[{:?}, {:?}, {:?}]\nknots = [\n", stated[0], stated[1], stated[2]);
    for knot in &knots {
        let _ = write!(text, "  [{:?}", knot.peak);
        for value in &knot.row {
            let _ = write!(text, ", {value:.14}");
        }
        text += "],\n";
    }
    text + "]\n"
}

/// Writes every table; those that are in this text already as they are there.
fn write(known: &str) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/src/tuning/optimise/table/tables.toml");
    let known = sections(known);
    let mut text = HEAD.to_owned();
    for (structure, objective) in TABLES {
        let heading = heading(structure, objective);
        let kept = known.iter().find(|section| section.starts_with(&heading));
        let section = kept.map_or_else(|| section(structure, objective), |section| (*section).to_owned());
        text = format!("{}\n\n[[table]]\n{section}", text.trim_end());
        std::fs::write(path, &text).unwrap();
    }
}

#[test]
#[ignore = "takes minutes, and writes the file of the tables"]
fn the_tables_are_computed_anew() {
    write("");
}

#[test]
#[ignore = "takes minutes, and writes the file of the tables"]
fn the_tables_that_are_missing_are_computed() {
    write(include_str!("tables.toml"));
}

#[test]
fn every_table_that_is_listed_is_in_the_file_in_this_order() {
    let known = sections(include_str!("tables.toml"));
    let headings = TABLES.map(|(structure, objective)| heading(structure, objective));
    assert_eq!(known.len(), headings.len());
    assert!(known.iter().zip(&headings).all(|(section, heading)| section.starts_with(heading)));
}

fn rounded_up(value: f64) -> f64 {
    #[expect(clippy::cast_possible_truncation, reason = "an exponent")]
    let scale = 10.0_f64.powi(1 - value.log10().floor() as i32);
    format!("{:e}", (value * scale).ceil() / scale).parse().unwrap()
}

const HEAD: &str = "\
# Optima of an integrator with dead time under a limit on the sensitivity peak, K and d taken out.
#
# Computed by this program (compute.rs says how and writes this file); not taken from any publication.
# A row is: limit on M_s, K·Kc·d, then, where the structure has them, Ti/d, Td/d, K·Ko·d; and the value of the objective
# in |K|·d² (load_iae), K²·d³ (load_ise), d (setpoint_iae, setpoint_ise), 1 (weighted_iae).
# filter_ratio is Tf/Td. error is what the interpolation may miss, relative: a setting, the value, the peak above its limit.
";
