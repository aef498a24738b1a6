//! The best proportional gain for given times and ratios.

use super::design::Design;
use super::limits::{Limits, Quantity};
use super::objective::{Objective, integrals};
use crate::analysis::frequency::margins;
use crate::analysis::infinite_horizon::Input;
use crate::model::{ClosedLoop, Controller};

/// The gains that are tried first, in units of 1/(K·d): from the greatest that any loop of these structures bears down to
/// one that is hardly control, a ratio apart.
const GREATEST: f64 = 2.0;
const LEAST: f64 = 2e-3;
const RATIO: f64 = 0.6;

/// How closely the best gain is found: relative widths of the end of an interval of gains, and of a minimum inside, where
/// the value is flat, so that the square of the width remains.
#[derive(Debug, Clone, Copy)]
pub(super) struct Precision {
    end: f64,
    inside: f64,
}

/// While the times are searched.
pub(super) const SEARCHING: Precision = Precision { end: 1e-9, inside: 3e-4 };
/// For the optimum.
pub(super) const POLISHED: Precision = Precision { end: 1e-12, inside: 1e-6 };

/// A controller and its value.
#[derive(Debug, Clone, Copy)]
pub(super) struct Candidate {
    pub(super) controller: Controller,
    pub(super) value: f64,
}

pub(super) struct Gains<'a> {
    pub(super) design: &'a Design,
    pub(super) limits: &'a Limits,
    pub(super) objective: Objective,
    pub(super) precision: Precision,
}

impl Gains<'_> {
    /// The best controller of these parts; `None` where no gain keeps the limits.
    pub(super) fn best(&self, parts: &[f64]) -> Option<Candidate> {
        let mut gains = vec![GREATEST];
        while gains[gains.len() - 1] > LEAST {
            gains.push(gains[gains.len() - 1] * RATIO);
        }
        let keeps: Vec<bool> = gains.iter().map(|&gain| self.keeps(parts, gain)).collect();
        let mut best: Option<Candidate> = None;
        let mut index = 0;
        while index < gains.len() {
            if !keeps[index] {
                index += 1;
                continue;
            }
            let last =
                keeps[index..].iter().position(|keep| !keep).map_or(gains.len(), |length| index + length) - 1;
            let high = if index == 0 { gains[0] } else { self.end(parts, gains[index], gains[index - 1]) };
            let low =
                || gains.get(last + 1).map_or(gains[last], |&outside| self.end(parts, gains[last], outside));
            let found = self.inside(parts, &low, high);
            if let Some(found) = found.filter(|found| best.is_none_or(|best| found.value < best.value)) {
                best = Some(found);
            }
            index = last + 1;
        }
        best
    }

    fn keeps(&self, parts: &[f64], gain: f64) -> bool {
        let Ok(controller) = self.design.controller(parts, gain) else { return false };
        margins(&ClosedLoop::new(&self.design.process, &controller))
            .is_ok_and(|achieved| self.limits.keep(&controller, &achieved))
    }

    /// The gain between one that keeps the limits and one that does not, on the side that does.
    fn end(&self, parts: &[f64], mut inside: f64, mut outside: f64) -> f64 {
        while (outside - inside).abs() > self.precision.end * inside {
            let middle = f64::midpoint(inside, outside);
            if middle == inside || middle == outside {
                break;
            }
            *(if self.keeps(parts, middle) { &mut inside } else { &mut outside }) = middle;
        }
        inside
    }

    /// The best gain of an interval, which is an end or a minimum inside: golden section, the value taken as having one.
    fn inside(&self, parts: &[f64], low: &dyn Fn() -> f64, high: f64) -> Option<Candidate> {
        let at = |gain: f64| self.candidate(parts, gain);
        let value = |candidate: &Option<Candidate>| candidate.map_or(f64::INFINITY, |found| found.value);
        let mut best = at(high);
        // Most often the value falls up to the greatest gain that is allowed.
        let falling = at(high * (1.0 - 1e-4));
        if value(&falling) > value(&best) {
            return best;
        }
        let low = low();
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        let (mut a, mut b) = (low, high);
        let (mut c, mut d) = (b - golden * (b - a), a + golden * (b - a));
        let (mut at_c, mut at_d) = (at(c), at(d));
        while b - a > self.precision.inside * b {
            if value(&at_c) <= value(&at_d) {
                (b, d, at_d) = (d, c, at_c);
                c = b - golden * (b - a);
                at_c = at(c);
            } else {
                (a, c, at_c) = (c, d, at_d);
                d = a + golden * (b - a);
                at_d = at(d);
            }
        }
        for candidate in [falling, at_c, at_d, at(low)] {
            if value(&candidate) < value(&best) {
                best = candidate;
            }
        }
        best
    }

    /// The controller and its value; `None` where the value is infinite or an integral exceeds its limit.
    fn candidate(&self, parts: &[f64], gain: f64) -> Option<Candidate> {
        let controller = self.design.controller(parts, gain).ok()?;
        for (quantity, input) in [(Quantity::LoadIae, Input::Load), (Quantity::SetpointIae, Input::Setpoint)]
        {
            if let Some(greatest) = self.limits.of(quantity) {
                let found = integrals(&self.design.process, &controller, input)?.iae?;
                if found > greatest {
                    // Outside of the limit the excess alone counts, so that the search finds its way back.
                    return Some(Candidate { controller, value: OUTSIDE * (found / greatest) });
                }
            }
        }
        let value = self.objective.value(self.design, &controller)?;
        value.is_finite().then_some(Candidate { controller, value })
    }
}

/// Values from here on say that an integral exceeds its limit.
pub(super) const OUTSIDE: f64 = 1e30;
