//! The gain with which a box of processes may be largest.
//!
//! A box is largest where with more gain it would touch at one frequency and with less at another: a kink between two smooth
//! functions. Values and slopes at either side of it say where their tangents meet, and that is next to the kink; where both
//! touch at the same frequency, the cubic through them says where the maximum is. The limits on responses, each of which
//! costs a simulation, are looked at afterwards.

use super::gain::{Candidate, Gains};
use super::objective::Objective;
use crate::tuning::line::Place;
use crate::tuning::robust::{Boxes, Touching, most};

/// Difference of gain that makes a slope, relative.
const DIFFERENCE: f64 = 1e-6;
/// Steps up or down from a known gain: the first, and how much longer the next one is.
const FIRST: f64 = 1.002;
const FIRST_OF_ALL: f64 = 1.2;
const GROWTH: f64 = 4.0;
/// Steps until a maximum is given up.
const STEPS: usize = 60;
/// Frequencies within this part of each other are those of one minimum.
const SAME: f64 = 0.02;
/// Relative width of an interval of gains in which nothing is looked for.
const NARROWEST: f64 = 1e-12;
/// A new gain lies at least this part of the interval within it.
const WITHIN: f64 = 1e-3;
/// Steps to a gain that keeps the limits on responses.
const TO_KEPT: f64 = 1.15;

/// A gain, as a logarithm, with the size of the box there.
#[derive(Debug, Clone, Copy)]
struct Sized {
    at: f64,
    touching: Touching,
    /// Over the logarithm of the gain.
    slope: f64,
}

/// What is known of the gain with the largest box.
#[expect(clippy::large_enum_variant, reason = "one at a time, on the stack")]
pub(super) enum Widest {
    /// The largest, or the largest that keeps the limits on responses.
    Of(Candidate),
    /// The limits on responses are kept by none of the gains looked at.
    NoneKept,
    /// There is no size to be followed.
    NoSize,
}

impl Gains<'_> {
    /// Whether the size of a box is searched that costs less than a simulation.
    pub(super) fn sizes_boxes(&self) -> bool {
        self.boxes().is_some() && !self.jumps()
    }

    fn boxes(&self) -> Option<(Boxes<'_>, f64)> {
        let Objective::RobustBox { family, sensitivity_peak } = self.objective else { return None };
        let boxes = Boxes::new(&self.design.process, &family, sensitivity_peak);
        Some((boxes.filter(|_| !self.design.proving)?, most(&family)))
    }

    /// The gain of the largest box, next to that of a neighbour.
    pub(super) fn widest_near(&self, parts: &[f64], known: &Candidate) -> Option<Candidate> {
        match self.widest(parts, known.gain, [0.0, f64::INFINITY], FIRST) {
            Widest::Of(found) if self.slack(parts, found.gain) >= 0.0 => Some(found),
            _ => None,
        }
    }

    /// The gain of the largest box between two gains.
    pub(super) fn widest_between(&self, parts: &[f64], low: f64, high: f64) -> Widest {
        self.widest(parts, (low * high).sqrt(), [low, high], FIRST_OF_ALL)
    }

    fn widest(&self, parts: &[f64], start: f64, ends: [f64; 2], first: f64) -> Widest {
        let Some(top) = self.largest(parts, start.ln(), ends.map(f64::ln), first.ln()) else {
            return Widest::NoSize;
        };
        let Some(found) = self.candidate(parts, top.at.exp()) else { return Widest::NoSize };
        if found.excess <= 0.0 {
            return Widest::Of(found);
        }
        // More gain shortens most responses.
        let from = (found.gain, -found.excess);
        let up = self.kept_beyond(parts, from, TO_KEPT, ends);
        match up.or_else(|| self.kept_beyond(parts, from, 1.0 / TO_KEPT, ends)) {
            Some(found) => Widest::Of(found),
            None => Widest::NoneKept,
        }
    }

    /// The first gain from this one on, in steps of a factor, that keeps the limits on responses and has a box.
    fn kept_beyond(
        &self,
        parts: &[f64],
        from: Place,
        factor: f64,
        [low, high]: [f64; 2],
    ) -> Option<Candidate> {
        let mut before = from;
        loop {
            let gain = before.0 * factor;
            // Away from the largest box there comes a gain without any.
            let within = gain >= low && gain <= high;
            within
                .then(|| self.sized(parts, gain.ln(), DIFFERENCE))
                .flatten()
                .filter(|sized| sized.touching.size > 0.0)?;
            let here = (gain, self.spare(parts, gain));
            if here.1 >= 0.0 {
                return self.reached(parts, here, before);
            }
            if here.1 <= before.1 {
                return None;
            }
            before = here;
        }
    }

    /// The gain, as a logarithm, of the largest box.
    fn largest(&self, parts: &[f64], start: f64, [low, high]: [f64; 2], first: f64) -> Option<Sized> {
        // At the limit of stability the size turns round: a slope is taken inwards.
        let sized = |at: f64| self.sized(parts, at, if at < high { DIFFERENCE } else { -DIFFERENCE });
        let mut here = sized(start)?;
        let (mut below, mut above) = (None, None);
        let mut step = first;
        for _ in 0..STEPS {
            *(if here.slope > 0.0 { &mut below } else { &mut above }) = Some(here);
            let next = match (&below, &above) {
                (Some(below), Some(above)) => {
                    let width = above.at - below.at;
                    let best = below.touching.size.max(above.touching.size);
                    let enough = self.precision.inside * self.precision.inside * best.abs();
                    let meeting = meeting(below, above).filter(|meeting| meeting.1 >= best);
                    let settled = meeting.is_some_and(|meeting| meeting.1 - best <= enough);
                    if (best > 0.0 && settled) || width <= NARROWEST {
                        break;
                    }
                    let at = match meeting {
                        // Far from the maximum the size need not be concave.
                        None => f64::midpoint(below.at, above.at),
                        Some(_) if same(&below.touching, &above.touching) => crest(below, above),
                        Some((at, _)) => at,
                    };
                    at.max(below.at + WITHIN * width).min(above.at - WITHIN * width)
                }
                (Some(below), None) if below.at < high => (below.at + step).min(high),
                (None, Some(above)) if above.at > low && above.slope < 0.0 => (above.at - step).max(low),
                _ => break,
            };
            step *= GROWTH;
            here = sized(next)?;
        }
        let better = |a: &Sized, b: &Sized| a.touching.size.total_cmp(&b.touching.size);
        below.into_iter().chain(above).max_by(better)
    }

    /// The size at a gain, as a logarithm, and its slope by this difference.
    fn sized(&self, parts: &[f64], at: f64, difference: f64) -> Option<Sized> {
        let (boxes, most) = self.boxes()?;
        let controller = |at: f64| self.design.controller(parts, at.exp()).ok();
        let touching = boxes.touching(&controller(at)?, most).ok()?;
        let moved = boxes.touching_at(&controller(at + difference)?, &touching).ok()?;
        Some(Sized { at, touching, slope: (moved - touching.size) / difference })
    }
}

fn same(a: &Touching, b: &Touching) -> bool {
    match (a.omega, b.omega) {
        (Some(a), Some(b)) => (a / b - 1.0).abs() < SAME,
        (a, b) => a == b,
    }
}

/// Where the tangents meet, and at which size; `None` where that is not between the two.
fn meeting(below: &Sized, above: &Sized) -> Option<(f64, f64)> {
    let width = above.at - below.at;
    let apart = above.touching.size - above.slope * width - below.touching.size;
    let moved = apart / (below.slope - above.slope);
    (moved >= 0.0 && moved <= width).then_some((below.at + moved, below.touching.size + below.slope * moved))
}

/// Where the cubic with these values and slopes is greatest (J. Nocedal and S. J. Wright, Numerical Optimization, 2nd edition
/// 2006, equation 3.59).
fn crest(below: &Sized, above: &Sized) -> f64 {
    let width = above.at - below.at;
    let (falls, rises) = (-below.slope, -above.slope);
    let d1 = falls + rises + 3.0 * (above.touching.size - below.touching.size) / width;
    let d2 = (d1 * d1 - falls * rises).sqrt();
    above.at - width * (rises + d2 - d1) / (rises - falls + 2.0 * d2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::frequency::family::Family;
    use crate::model::{Process, Seconds};
    use crate::tuning::optimise::design::{Design, Structure};
    use crate::tuning::optimise::filter::Filter;
    use crate::tuning::optimise::gain::SEARCHING;
    use crate::tuning::optimise::limits::Limits;

    #[test]
    fn no_gain_of_a_row_has_a_larger_box() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let family = Family::ranges([0.8, 1.2], [0.8, 1.2]).unwrap();
        for (structure, filter) in [
            (Structure::Pi, Filter::None),
            (Structure::Pid, Filter::None),
            (Structure::Pid, Filter::Held(0.1)),
            (Structure::PdObserver, Filter::None),
        ] {
            let design = Design::new(&process, structure, filter, false);
            for sensitivity_peak in [1.4, 2.0] {
                let limits = Limits::default();
                let objective = Objective::RobustBox { family, sensitivity_peak };
                let gains = Gains::new(&design, objective, &limits, SEARCHING);
                for first in [0.1, 0.4, 0.7, 0.95] {
                    for second in [0.2, 0.5, 0.8] {
                        let parts: Vec<f64> =
                            [first, second].into_iter().take(design.variables.len()).collect();
                        let row = (0..60).map(|i| -6.0 + 0.1 * f64::from(i));
                        let stable = row.filter(|at| gains.slack(&parts, at.exp()) >= 0.0);
                        let row: Vec<Sized> =
                            stable.filter_map(|at| gains.sized(&parts, at, DIFFERENCE)).collect();
                        let best =
                            row.iter().map(|sized| sized.touching.size).fold(f64::NEG_INFINITY, f64::max);
                        // Up to the limit of stability.
                        let (mut inside, mut outside) = (row[row.len() - 1].at, row[row.len() - 1].at + 0.1);
                        while outside - inside > 1e-12 {
                            let middle = f64::midpoint(inside, outside);
                            let stable = gains.slack(&parts, middle.exp()) >= 0.0;
                            *(if stable { &mut inside } else { &mut outside }) = middle;
                        }
                        let (low, high) = (row[0].at, inside);
                        let found = gains.largest(&parts, 0.5 * (low + high), [low, high], FIRST_OF_ALL.ln());
                        let found = found.map(|found| (found.touching.size, found.at));
                        if !found.is_some_and(|found| found.0 >= best * (1.0 - 1e-9)) {
                            println!(
                                "{structure:?} {filter:?} {sensitivity_peak} {parts:?} {found:?} {best}"
                            );
                            for sized in row {
                                println!("   {} {:?} {}", sized.at, sized.touching, sized.slope);
                            }
                            panic!();
                        }
                    }
                }
            }
        }
    }
}
