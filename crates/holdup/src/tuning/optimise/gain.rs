//! The best proportional gain for given times and ratios.

use super::design::Design;
use super::limits::{Limits, Quantity};
use super::objective::{Objective, Transients};
use super::widest::Widest;
use crate::analysis::frequency::margins;
use crate::model::{ClosedLoop, Controller};
use crate::tuning::line::{Place, boundary, least};

/// The gains that are tried first, in units of 1/(K·d): from the greatest that any loop of these structures bears down to
/// one that is hardly control, a ratio apart.
const GREATEST: f64 = 2.0;
const LEAST: f64 = 2e-3;
const RATIO: f64 = 0.6;
/// How far about the gain of a neighbour that of this design is looked for, and how often farther.
const NEAR: f64 = 1.01;
const FARTHER: u32 = 6;
/// How far about a minimum of a neighbour that of this design is looked for.
const ASIDE: f64 = 1.03;
/// Gains of the row where the limits jump.
const ROW: u32 = 40;
/// Relative width within which a limit on the responses is reached.
const REACHED: f64 = 1e-12;
/// Limits exceeded by more, relative, are too far away for the value to matter.
pub(super) const FAR_OUTSIDE: f64 = 0.1;
/// How long a response may be followed, in settling times that are allowed: what lasts longer loses less than a quarter of a
/// swing in one of them. And where the settling time itself is searched, in times of the loop.
const SWINGS: f64 = 100.0;
const SWINGS_AT_ALL: f64 = 2e3;
/// A step down from the greatest gain that tells whether the value falls up to there.
const BELOW: f64 = 1.0 - 1e-4;

/// How closely the best gain is found: relative widths of the end of an interval of gains, and of a minimum inside, where
/// the value is flat, so that the square of the width remains.
#[derive(Debug, Clone, Copy)]
pub(super) struct Precision {
    end: f64,
    pub(super) inside: f64,
}

/// While the whole space is swept, while the times are searched, and for the optimum.
pub(super) const SWEEPING: Precision = Precision { end: 1e-4, inside: 1e-2 };
pub(super) const SEARCHING: Precision = Precision { end: 1e-10, inside: 1e-5 };
pub(super) const POLISHED: Precision = Precision { end: 1e-12, inside: 1e-6 };

/// A controller and its value.
#[derive(Debug, Clone, Copy)]
pub(super) struct Candidate {
    pub(super) controller: Controller,
    /// In units of 1/(K·d).
    pub(super) gain: f64,
    /// The value of the objective.
    pub(super) value: f64,
    /// By how much limits are exceeded, relative.
    pub(super) excess: f64,
    /// Whether the gain is the greatest that the limits allow.
    pub(super) at_end: bool,
    /// Whether the gain is where a limit on the responses is reached.
    pub(super) at_reach: bool,
}

/// What an exceeded limit costs: much more than it may buy.
const PENALTY: f64 = 300.0;
/// An integral that exceeds its limit by less is at it.
pub(super) const KEPT: f64 = 1e-9;

impl Candidate {
    /// What is made small: the value, and the excess many times over.
    pub(super) fn merit(&self) -> f64 {
        self.value + PENALTY * self.excess * self.value.abs()
    }

    /// Whether every limit is kept.
    pub(super) fn keeps(&self) -> bool {
        self.excess <= KEPT
    }
}

/// Merits from here on say that no gain keeps the limits on margins; the more, the farther.
pub(super) const OUTSIDE: f64 = 1e200;

/// What is known of a design.
#[derive(Debug, Clone, Copy)]
#[expect(clippy::large_enum_variant, reason = "one at a time, on the stack")]
pub(super) enum Best {
    /// The best of the gains that keep the limits on margins.
    Of(Candidate),
    /// None keeps them; how little they are exceeded.
    None(f64),
}

impl Best {
    pub(super) fn merit(&self) -> f64 {
        match self {
            Self::Of(candidate) => candidate.merit(),
            Self::None(slack) if slack.is_finite() => OUTSIDE * (1.0 - slack),
            Self::None(_) => f64::INFINITY,
        }
    }

    pub(super) fn candidate(self) -> Option<Candidate> {
        match self {
            Self::Of(candidate) => Some(candidate),
            Self::None(_) => None,
        }
    }
}

pub(super) struct Gains<'a> {
    pub(super) design: &'a Design,
    pub(super) limits: &'a Limits,
    pub(super) objective: Objective,
    pub(super) precision: Precision,
    /// Whether next to a neighbour whose best gain is the greatest one a lesser gain may be better.
    pub(super) looks_below: bool,
}

impl<'a> Gains<'a> {
    pub(super) fn new(
        design: &'a Design,
        objective: Objective,
        limits: &'a Limits,
        precision: Precision,
    ) -> Self {
        // A load is rejected the better the more gain there is; only the last search makes sure of it.
        let looks_below =
            !matches!(objective, Objective::LoadIae | Objective::LoadIse) || precision.end < 1e-11;
        Self { design, limits, objective, precision, looks_below }
    }

    /// Whether a limit or the objective jumps.
    pub(super) fn jumps(&self) -> bool {
        let settling = Quantity::SetpointSettlingTime;
        self.limits.of(settling).is_some() || self.objective == Objective::Extreme(settling)
    }

    /// The best controller of these parts.
    pub(super) fn best(&self, parts: &[f64]) -> Best {
        let mut gains = vec![GREATEST * self.design.headroom()];
        while gains[gains.len() - 1] > LEAST {
            gains.push(gains[gains.len() - 1] * RATIO);
        }
        let mut places: Vec<Place> = gains.iter().map(|&gain| (gain, self.slack(parts, gain))).collect();
        if places.iter().all(|place| place.1 < 0.0) {
            // The gains that keep the limits may lie between two of the row.
            let finite = (0..places.len()).filter(|&index| places[index].1.is_finite());
            let Some(top) = finite.max_by(|&a, &b| places[a].1.total_cmp(&places[b].1)) else {
                return Best::None(f64::NEG_INFINITY);
            };
            let (low, high) = (places[(top + 1).min(places.len() - 1)].0, places[top.saturating_sub(1)].0);
            let found = self.least_exceeded(parts, low, high, places[top]);
            if found.1 < 0.0 {
                return self.outside(parts, found);
            }
            let at = places.partition_point(|place| place.0 > found.0);
            places.insert(at, found);
        }
        let mut best: Option<Candidate> = None;
        let mut index = 0;
        while index < places.len() {
            if places[index].1 < 0.0 {
                index += 1;
                continue;
            }
            let rest = &places[index..];
            let last = rest.iter().position(|place| place.1 < 0.0).map_or(places.len(), |n| index + n) - 1;
            let high =
                if index == 0 { places[0].0 } else { self.end(parts, places[index], places[index - 1]) };
            let low = || match places.get(last + 1) {
                Some(&outside) => self.end(parts, places[last], outside),
                None => places[last].0,
            };
            let found = self.inside(parts, &low, high);
            if let Some(found) = found.filter(|found| best.is_none_or(|best| found.merit() < best.merit())) {
                best = Some(found);
            }
            index = last + 1;
        }
        best.map_or(Best::None(f64::NEG_INFINITY), Best::Of)
    }

    /// The same next to a design whose best is known, where that helps: a fraction of the work.
    pub(super) fn best_near(&self, parts: &[f64], known: Option<Candidate>) -> Best {
        let Some(known) = known else { return self.best(parts) };
        let (end, reach) = (|| self.end_near(parts, known), || self.reach_near(parts, known));
        let found = if self.sizes_boxes() && known.keeps() && !known.at_reach {
            self.widest_near(parts, &known).map(Best::Of)
        } else if known.at_end || !known.keeps() {
            // Next to where two limits meet the other one may end the gains.
            end().or_else(reach)
        } else if known.at_reach {
            reach().or_else(end)
        } else {
            self.minimum_near(parts, known)
        };
        found.unwrap_or_else(|| self.best(parts))
    }

    /// The greatest gain that the limits allow, next to that of a neighbour.
    fn end_near(&self, parts: &[f64], known: Candidate) -> Option<Best> {
        let mut here = (known.gain, self.slack(parts, known.gain));
        let mut factor = NEAR;
        let mut before: Option<Place> = None;
        for _ in 0..FARTHER {
            let up = here.1 >= 0.0;
            let next = if up { here.0 * factor } else { here.0 / factor };
            let there = (next, self.slack(parts, next));
            if up != (there.1 >= 0.0) {
                let (inside, outside) = if up { (here, there) } else { (there, here) };
                let end = self.candidate(parts, self.end(parts, inside, outside))?;
                let rises = self.looks_below && {
                    let below = self.candidate(parts, end.gain * BELOW);
                    below.is_none_or(|below| below.merit() < end.merit())
                };
                return (end.keeps() && !rises).then_some(Best::Of(Candidate { at_end: true, ..end }));
            }
            if !up && here.1 > there.1 {
                // Less gain exceeds the limits more: none keeps them.
                let high = before.map_or(here.0 * factor, |before| before.0);
                let found = self.least_exceeded(parts, there.0, high, here);
                return (found.1 < 0.0).then(|| self.outside(parts, found));
            }
            (before, here) = (Some(here), there);
            factor *= factor;
        }
        None
    }

    /// Where a limit on the responses is reached, next to that of a neighbour.
    fn reach_near(&self, parts: &[f64], known: Candidate) -> Option<Best> {
        let mut here = (known.gain, self.spare(parts, known.gain));
        let mut factor = NEAR;
        // The side on which the neighbour's limit is kept is told by a small step.
        let rising = self.spare(parts, known.gain / BELOW) > here.1;
        for _ in 0..FARTHER {
            let keeps = here.1 >= 0.0;
            let next = if keeps == rising { here.0 / factor } else { here.0 * factor };
            let there = (next, self.spare(parts, next));
            if keeps != (there.1 >= 0.0) {
                let (inside, outside) = if keeps { (here, there) } else { (there, here) };
                let found = self.reached(parts, inside, outside)?;
                let gain = found.gain;
                // It must keep the margins, and the value fall towards the limit.
                let inwards = if rising { gain / BELOW } else { gain * BELOW };
                let falls = self.candidate(parts, inwards).is_none_or(|other| other.merit() > found.merit());
                let kept = falls && self.slack(parts, gain) >= 0.0;
                return kept.then_some(Best::Of(found));
            }
            here = there;
            factor *= factor;
        }
        None
    }

    /// Where a limit on the responses is reached, on the side that keeps it.
    pub(super) fn reached(&self, parts: &[f64], inside: Place, outside: Place) -> Option<Candidate> {
        let width = (1e-2 * self.precision.end).max(REACHED);
        let precision = (width, 0.1 * KEPT.max(width));
        let gain = boundary(inside, outside, precision, &mut |gain| self.spare(parts, gain));
        let found = self.candidate(parts, gain).filter(Candidate::keeps)?;
        Some(Candidate { at_reach: true, ..found })
    }

    /// A minimum inside of the interval, next to that of a neighbour.
    fn minimum_near(&self, parts: &[f64], known: Candidate) -> Option<Best> {
        let (low, high) = (known.gain / ASIDE, known.gain * ASIDE);
        if self.slack(parts, low) < 0.0
            || self.slack(parts, high) < 0.0
            || !known.keeps()
            || known.excess > 0.0
        {
            return None;
        }
        let mut best: Option<Candidate> = None;
        least(low, high, self.precision.inside, &mut |gain| {
            let found = self.candidate(parts, gain);
            if found.is_some_and(|found| best.is_none_or(|best| found.merit() < best.merit())) {
                best = found;
            }
            found.map_or(f64::INFINITY, |found| found.merit())
        });
        let within = |found: &Candidate| {
            let margin = 4.0 * self.precision.inside * known.gain;
            found.excess == 0.0 && found.gain > low + margin && found.gain < high - margin
        };
        best.filter(within).map(Best::Of)
    }

    /// By how much a gain keeps every limit on margins, relative: −∞ where the loop is not stable.
    pub(super) fn slack(&self, parts: &[f64], gain: f64) -> f64 {
        let Ok(controller) = self.design.controller(parts, gain) else { return f64::NEG_INFINITY };
        margins(&ClosedLoop::new(&self.design.process, &controller))
            .map_or(f64::NEG_INFINITY, |achieved| self.limits.slack(&controller, &achieved))
    }

    /// The gain from `low` to `high` at which the limits are exceeded least, or one that keeps them.
    fn least_exceeded(&self, parts: &[f64], low: f64, high: f64, known: Place) -> Place {
        let mut best = known;
        least(low, high, 0.1 * self.precision.end.max(1e-9), &mut |gain| {
            // One that keeps them is enough.
            if best.1 >= 0.0 {
                return (gain - best.0).abs();
            }
            let here = self.slack(parts, gain);
            if here > best.1 {
                best = (gain, here);
            }
            -here
        });
        best
    }

    /// What a design is worth none of whose gains keeps the limits, given the one that exceeds them least.
    fn outside(&self, parts: &[f64], (gain, slack): Place) -> Best {
        if slack < -FAR_OUTSIDE {
            return Best::None(slack);
        }
        match self.candidate(parts, gain) {
            Some(found) => Best::Of(Candidate { excess: found.excess - slack, ..found }),
            None => Best::None(slack),
        }
    }

    /// The gain at which the limits are reached, on the side that keeps them.
    fn end(&self, parts: &[f64], inside: Place, outside: Place) -> f64 {
        let (end, precision) = (self.precision.end, self.precision.end);
        boundary(inside, outside, (end, precision), &mut |gain| self.slack(parts, gain))
    }

    /// The best gain of an interval, which is an end or a minimum inside, the value taken as having one.
    fn inside(&self, parts: &[f64], low: &dyn Fn() -> f64, high: f64) -> Option<Candidate> {
        if self.sizes_boxes() {
            match self.widest_between(parts, low(), high) {
                Widest::Of(found) => return Some(found),
                Widest::NoSize => return None,
                Widest::NoneKept => {}
            }
        }
        let at = |gain: f64| self.candidate(parts, gain);
        let merit = |candidate: &Option<Candidate>| candidate.map_or(f64::INFINITY, |found| found.merit());
        let top = at(high).map(|found| Candidate { at_end: true, ..found });
        // Most often the value falls up to the greatest gain that is allowed.
        let below = at(high * BELOW);
        let jumps = self.jumps();
        if merit(&below) > merit(&top) && !jumps {
            return top;
        }
        let mut low = low();
        if let (Some(longest), 1) =
            (self.limits.of(Quantity::SetpointSettlingTime), self.design.process.integrators())
        {
            // With less gain more than a third of a step is left after that time.
            low = low.max(self.design.time / longest).min(high);
        }
        let mut tried: Vec<Candidate> = top.into_iter().chain(below).chain(at(low)).collect();
        if jumps {
            // The gains that keep such a limit may be several intervals: a row, and the least value about the best of it.
            let part = (high / low).powf(1.0 / f64::from(ROW));
            let row = (1..ROW).filter_map(|index| at(low * part.powf(f64::from(index))));
            tried.extend(row);
            let best = tried.iter().min_by(|a, b| a.merit().total_cmp(&b.merit())).map(|best| best.gain);
            if let Some(gain) = best {
                let (from, to) = ((gain / part).max(low), (gain * part).min(high));
                least(from, to, self.precision.inside, &mut |gain| {
                    let found = at(gain);
                    tried.extend(found);
                    merit(&found)
                });
            }
        } else {
            least(low, high, self.precision.inside, &mut |gain| {
                let found = at(gain);
                tried.extend(found);
                merit(&found)
            });
        }
        tried.sort_by(|a, b| a.gain.total_cmp(&b.gain));
        let best = (0..tried.len()).min_by(|&a, &b| tried[a].merit().total_cmp(&tried[b].merit()))?;
        // Where the limit on an integral ends what may be chosen, the best is where it is reached.
        let neighbours = [best.checked_sub(1), Some(best + 1)];
        let mut best = tried[best];
        for neighbour in neighbours.into_iter().flatten().filter_map(|index| tried.get(index)) {
            if best.keeps() != neighbour.keeps() {
                let (kept, other) = if best.keeps() { (best, *neighbour) } else { (*neighbour, best) };
                let spare = |gain: f64| self.spare(parts, gain);
                let places = [kept, other].map(|found| (found.gain, spare(found.gain)));
                let precision = (REACHED, 0.1 * KEPT);
                let reached = at(boundary(places[0], places[1], precision, &mut |gain| spare(gain)));
                let reached = reached.map(|found| Candidate { at_reach: true, ..found });
                if let Some(reached) = reached.filter(|found| found.merit() < best.merit()) {
                    best = reached;
                }
            }
        }
        Some(best)
    }

    /// The responses of a candidate. Where it counts when they settle, a loop that swings for very much longer is none.
    fn transients<'b>(&'b self, controller: &'b Controller) -> Transients<'b> {
        let transients = Transients::new(self.design, controller);
        match self.limits.of(Quantity::SetpointSettlingTime) {
            Some(limit) => transients.up_to(SWINGS * limit),
            None if self.jumps() => transients.up_to(SWINGS_AT_ALL * self.design.time),
            None => transients,
        }
    }

    /// The controller and its value; `None` where the value is infinite.
    pub(super) fn candidate(&self, parts: &[f64], gain: f64) -> Option<Candidate> {
        let controller = self.design.controller(parts, gain).ok()?;
        let transients = self.transients(&controller);
        let value = || self.objective.value(self.design, &controller, &transients);
        // What costs less than a simulation, first.
        let known = if self.sizes_boxes() { Some(value()?) } else { None };
        let excess = (-self.limits.spare(&transients)?).max(0.0);
        if excess > FAR_OUTSIDE && self.jumps() {
            // The response to the other step need not be followed.
            let value = OUTSIDE / PENALTY;
            return Some(Candidate { controller, gain, value, excess, at_end: false, at_reach: false });
        }
        let value = known.or_else(value)?;
        let found = Candidate { controller, gain, value, excess, at_end: false, at_reach: false };
        value.is_finite().then_some(found)
    }

    /// By how much a gain keeps every limit on an integral, relative.
    pub(super) fn spare(&self, parts: &[f64], gain: f64) -> f64 {
        let spare = self.design.controller(parts, gain).ok().and_then(|controller| {
            let transients = self.transients(&controller);
            self.limits.spare(&transients)
        });
        spare.unwrap_or(f64::NEG_INFINITY)
    }
}
