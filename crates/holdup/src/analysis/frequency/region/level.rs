//! Curves of constant robustness, followed vertex by vertex with exact margins.
//!
//! From a vertex the next lies on a circle round it, ahead: where the quantity minus its level changes sign on
//! the arc. No derivative is taken, for a peak that is the greater of two has a kink where they are equal.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::super::margins::Margins;
use super::plane::Settings;
use super::{Constant, Vertex};

/// Length of a step, as a share of the window.
const STEP: f64 = 0.02;
/// Where steps get shorter than this the curve ends: at the edge of the window or at a jump of the quantity.
const SHORTEST: f64 = 1e-4;
/// Relative error with which a vertex is on the level.
const TOLERANCE: f64 = 2e-10;
/// Lines across the window on which curves are looked for, and points on each.
const LINES: i32 = 24;
const POINTS: i32 = 48;
/// Vertices of one curve.
const MOST: usize = 2000;

/// The margins along lines across the window, horizontal ones first: computed once for all levels.
pub(super) struct Survey(Vec<(Line, Vec<Option<Margins>>)>);

/// A line across the window.
#[derive(Clone, Copy)]
struct Line {
    vertical: bool,
    at: f64,
}

impl Line {
    fn point(self, t: f64) -> [f64; 2] {
        if self.vertical { [self.at, t] } else { [t, self.at] }
    }
}

/// Place of a point on its line.
fn place(i: i32) -> f64 {
    (f64::from(i) + 0.5) / f64::from(POINTS)
}

impl Survey {
    pub(super) fn new(settings: &Settings) -> Self {
        let lines = (0..LINES).flat_map(|i| {
            let at = (f64::from(i) + 0.5) / f64::from(LINES);
            [false, true].map(|vertical| Line { vertical, at })
        });
        let margins = |line: Line| {
            (0..POINTS).map(|i| settings.margins(settings.point(line.point(place(i))))).collect()
        };
        Self(lines.map(|line| (line, margins(line))).collect())
    }
}

/// The curves of a level within the window.
pub(super) fn curves(settings: &Settings, survey: &Survey, constant: Constant) -> Vec<Vec<Vertex>> {
    let tracer = Tracer { settings, constant };
    let mut found: Vec<Vec<[f64; 2]>> = Vec::new();
    for (line, margins) in &survey.0 {
        for seed in tracer.seeds(*line, margins) {
            let known = found.iter().flatten().any(|p| distance(*p, seed) < 1.1 * STEP);
            if !known {
                found.extend(tracer.trace(seed));
            }
        }
    }
    let vertex = |&point: &[f64; 2]| {
        let [x, y] = settings.point(point);
        Vertex { x, y, frequency: None }
    };
    found.iter().map(|curve| curve.iter().map(vertex).collect()).collect()
}

struct Tracer<'a> {
    settings: &'a Settings<'a>,
    constant: Constant,
}

impl Tracer<'_> {
    /// How much more robust the loop at a point is than the level asks for, and whether it is on the level.
    fn excess(&self, point: [f64; 2]) -> (f64, bool) {
        self.excess_of(self.settings.margins(self.settings.point(point)).as_ref())
    }

    /// The same of the margins there; `None` where the loop is not stable.
    fn excess_of(&self, margins: Option<&Margins>) -> (f64, bool) {
        let (value, level) = match self.constant {
            // In terms that tend to their value at the boundary of stability.
            Constant::SensitivityPeak(level) => {
                (margins.and_then(|m| m.sensitivity_peak).map_or(0.0, |peak| 1.0 / peak), 1.0 / level)
            }
            Constant::GainMargin(level) => {
                let inverse = margins.map_or(1.0, |m| m.gain_margin.map_or(0.0, |margin| 1.0 / margin));
                (-inverse, -1.0 / level)
            }
            Constant::PhaseMargin(level) => {
                let all = std::f64::consts::PI;
                (margins.map_or(0.0, |m| m.phase_margin.map_or(all, |margin| margin.0.abs())), level)
            }
        };
        (value - level, (value - level).abs() <= TOLERANCE * level.abs())
    }

    /// Points of the level on a line across the window.
    fn seeds(&self, line: Line, margins: &[Option<Margins>]) -> Vec<[f64; 2]> {
        let values: Vec<f64> = margins.iter().map(|m| self.excess_of(m.as_ref()).0).collect();
        let along = |t: f64| line.point(t);
        (1..POINTS)
            .zip(values.windows(2))
            .filter(|(_, pair)| (pair[0] < 0.0) != (pair[1] < 0.0))
            .filter_map(|(i, pair)| self.root(&along, (place(i - 1), pair[0]), (place(i), pair[1])))
            .map(along)
            .collect()
    }

    /// The parameter of a point on the level between two where the excess has opposite signs.
    fn root(&self, line: &impl Fn(f64) -> [f64; 2], a: (f64, f64), b: (f64, f64)) -> Option<f64> {
        let ((mut a, mut fa), (mut b, mut fb)) = (a, b);
        for round in 0..80 {
            // False position with halved weights; a bisection now and then bounds the work.
            let t = if round % 4 == 3 { f64::midpoint(a, b) } else { (a * fb - b * fa) / (fb - fa) };
            let (f, on_level) = self.excess(line(t));
            if on_level {
                return Some(t);
            }
            if (f < 0.0) == (fb < 0.0) {
                fa *= 0.5;
            } else {
                (a, fa) = (b, fb);
            }
            (b, fb) = (t, f);
            if (b - a).abs() <= 1e-15 {
                break;
            }
        }
        None
    }

    /// The curve through a point of the level, both ways.
    fn trace(&self, seed: [f64; 2]) -> Option<Vec<[f64; 2]>> {
        let heading = self.heading(seed)?;
        let (mut ahead, closed) = self.follow(seed, heading);
        if closed {
            ahead.push(seed);
        }
        let back = if closed { Vec::new() } else { self.follow(seed, heading + TAU / 2.0).0 };
        Some(back.into_iter().rev().chain([seed]).chain(ahead).collect())
    }

    /// The direction of the level at a point: across which the excess changes sign.
    fn heading(&self, seed: [f64; 2]) -> Option<f64> {
        let sign = |angle: f64| self.excess(moved(seed, SHORTEST, angle)).0 < 0.0;
        (0..24).map(|i| TAU * f64::from(i) / 24.0).find_map(|angle| {
            let next = angle + TAU / 24.0;
            let middle = f64::midpoint(angle, next);
            (sign(angle) != sign(next)).then_some(middle)
        })
    }

    /// The vertices after a point, and whether they come back to it.
    fn follow(&self, seed: [f64; 2], heading: f64) -> (Vec<[f64; 2]>, bool) {
        let (mut here, mut heading, mut step) = (seed, heading, 0.25 * STEP);
        let mut vertices = Vec::new();
        while step >= SHORTEST && vertices.len() < MOST {
            let Some(angle) = self.ahead(here, heading, step) else {
                step *= 0.5;
                continue;
            };
            let turned = (angle - heading).abs();
            if turned > 0.2 && step > 4.0 * SHORTEST {
                step *= 0.5;
                continue;
            }
            here = moved(here, step, angle);
            vertices.push(here);
            heading = angle;
            if vertices.len() > 4 && distance(here, seed) < 0.9 * step {
                return (vertices, true);
            }
            step = if turned < 0.07 { (1.5 * step).min(STEP) } else { step };
        }
        (vertices, false)
    }

    /// Direction of the next point of the level at distance `step`, within the window.
    fn ahead(&self, here: [f64; 2], heading: f64, step: f64) -> Option<f64> {
        let line = |angle: f64| moved(here, step, angle);
        for spread in [0.15, 0.6, 0.95 * FRAC_PI_2] {
            let (a, b) = (heading - spread, heading + spread);
            let (fa, fb) = (self.excess(line(a)).0, self.excess(line(b)).0);
            if (fa < 0.0) != (fb < 0.0) {
                let angle = self.root(&line, (a, fa), (b, fb))?;
                let inside = line(angle).iter().all(|c| (0.0..=1.0).contains(c));
                return inside.then_some(angle);
            }
        }
        None
    }
}

fn moved([u, v]: [f64; 2], by: f64, angle: f64) -> [f64; 2] {
    [u + by * angle.cos(), v + by * angle.sin()]
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
