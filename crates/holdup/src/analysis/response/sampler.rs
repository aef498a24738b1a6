//! Values of the signals at requested times, from cells and from segments.

use std::iter::once;

use smallvec::SmallVec;

use super::cell::{Cell, Outcome, Watch};
use super::error::ResponseError;
use super::layered::{Segment, Signal};
use super::legendre::{Poly, ends};
use super::scenario::Scenario;
use super::trajectory::Trajectory;
use super::values::{Curve, Place, evaluate};
use crate::analysis::widest;
use crate::model::ClosedLoop;

/// Controlled variable, controller output and load estimate.
type Curves = SmallVec<[Curve; 3]>;

/// Value at each time of what starts at `rest` and is held from event to event, which are in order.
fn hold(values: &mut Vec<f64>, times: &[f64], sorted: bool, rest: f64, events: &[(f64, f64)]) {
    values.resize(times.len(), rest);
    if !sorted {
        values.fill(rest);
        for &(at, value) in events {
            for (held, _) in values.iter_mut().zip(times).filter(|(_, t)| **t >= at) {
                *held = value;
            }
        }
        return;
    }
    let (mut from, mut held) = (0, rest);
    for &(at, value) in events {
        let to = times.partition_point(|&t| t < at);
        values[from..to].fill(held);
        (from, held) = (to, value);
    }
    values[from..].fill(held);
}

/// Whether no time is before the one ahead of it; what is not a number is in no order.
fn are_sorted(times: &[f64]) -> bool {
    // Counting has no way out of the loop, so it is done in vectors.
    let steps_on: usize = widest(
        #[inline(always)]
        || times.iter().zip(times.iter().skip(1)).map(|(a, b)| usize::from(a <= b)).sum(),
    );
    steps_on + 1 >= times.len()
}

/// Fills in the requested times, which it walks through in increasing order.
pub(super) struct Sampler<'a> {
    scenario: &'a Scenario,
    /// Indices of the times in increasing order; `None` if they are in order already.
    order: Option<Vec<usize>>,
    next: usize,
    result: Trajectory,
    last: Option<[f64; 3]>,
}

impl<'a> Sampler<'a> {
    pub(super) fn new(
        closed_loop: &ClosedLoop,
        scenario: &'a Scenario,
        times: &[f64],
    ) -> Result<Self, ResponseError> {
        Self::reusing(closed_loop, scenario, Trajectory { time: times.to_vec(), ..Trajectory::default() })
    }

    /// Overwrites the signals of a trajectory at its times, in its memory.
    pub(super) fn reusing(
        closed_loop: &ClosedLoop,
        scenario: &'a Scenario,
        mut result: Trajectory,
    ) -> Result<Self, ResponseError> {
        let horizon = scenario.horizon();
        let times = &result.time;
        let is_within = |t: f64| t >= 0.0 && t <= horizon;
        let sorted = are_sorted(times);
        let ends = [times.first(), times.last()];
        if !(sorted && ends.into_iter().flatten().all(|t| is_within(*t)))
            && let Some(&value) = times.iter().find(|t| !is_within(**t))
        {
            return Err(ResponseError::TimeOutside { value, horizon });
        }
        let order = (!sorted).then(|| {
            let mut order: Vec<usize> = (0..times.len()).collect();
            order.sort_by(|&a, &b| times[a].total_cmp(&times[b]));
            order
        });
        hold(&mut result.setpoint, times, sorted, scenario.initial(), scenario.setpoint());
        hold(&mut result.load, times, sorted, 0.0, scenario.load());
        // Every value is overwritten.
        result.controlled_variable.resize(times.len(), 0.0);
        result.manipulated_variable.resize(times.len(), 0.0);
        result.load_estimate = closed_loop.load_estimate().map(|_| {
            let mut estimates = result.load_estimate.take().unwrap_or_default();
            estimates.resize(times.len(), 0.0);
            estimates
        });
        Ok(Self { scenario, order, next: 0, result, last: None })
    }

    fn index(&self, position: usize) -> usize {
        self.order.as_ref().map_or(position, |order| order[position])
    }

    /// The positions of the times before `end` that have not been filled in yet.
    fn until(&mut self, end: f64) -> (usize, usize) {
        let from = self.next;
        self.next = match &self.order {
            None => from + self.result.time[from..].partition_point(|&t| t < end),
            Some(order) => from + order[from..].partition_point(|&i| self.result.time[i] < end),
        };
        (from, self.next)
    }

    fn set(&mut self, index: usize, [y, u, estimate]: [f64; 3]) {
        self.result.controlled_variable[index] = y;
        self.result.manipulated_variable[index] = u;
        if let Some(estimates) = &mut self.result.load_estimate {
            estimates[index] = estimate;
        }
    }

    /// The times that no cell contains: the horizon itself, or everything after an overflow.
    pub(super) fn finish(mut self, outcome: Outcome) -> Trajectory {
        if outcome.overflow_at.is_none() {
            for position in self.next..self.result.time.len() {
                let index = self.index(position);
                self.set(index, self.last.unwrap_or_default());
            }
            return self.result;
        }
        let mut kept: Vec<usize> = (0..self.next).map(|position| self.index(position)).collect();
        kept.sort_unstable();
        let pick = |values: &[f64]| kept.iter().map(|&i| values[i]).collect::<Vec<f64>>();
        Trajectory {
            time: pick(&self.result.time),
            setpoint: pick(&self.result.setpoint),
            controlled_variable: pick(&self.result.controlled_variable),
            manipulated_variable: pick(&self.result.manipulated_variable),
            load: pick(&self.result.load),
            load_estimate: self.result.load_estimate.as_deref().map(pick),
        }
    }
}

impl Sampler<'_> {
    /// Fills in the times before the end of a stretch of time over which the signals are these curves: controlled
    /// variable, controller output and, where there is one, load estimate.
    fn fill(&mut self, (from, to): (usize, usize), place: Place, curves: &[Curve]) {
        let Trajectory { time, controlled_variable, manipulated_variable, load_estimate, .. } =
            &mut self.result;
        let signals = [Some(controlled_variable), Some(manipulated_variable), load_estimate.as_mut()];
        let signals = signals.into_iter().flatten();
        let Some(order) = &self.order else {
            let mut values: SmallVec<[&mut [f64]; 3]> = signals.map(|signal| &mut signal[from..to]).collect();
            evaluate(place, curves, &time[from..to], &mut values);
            return;
        };
        let order = &order[from..to];
        let times: Vec<f64> = order.iter().map(|&i| time[i]).collect();
        let mut found = vec![vec![0.0; times.len()]; curves.len()];
        evaluate(place, curves, &times, &mut found.iter_mut().map(Vec::as_mut_slice).collect::<Vec<_>>());
        for (signal, found) in signals.zip(&found) {
            for (&i, value) in order.iter().zip(found) {
                signal[i] = *value;
            }
        }
    }
}

impl Watch for Sampler<'_> {
    fn cell(&mut self, cell: &Cell<'_>) {
        let level = self.scenario.initial() + cell.setpoint;
        let at_end = |p: &Poly| ends(p).1;
        let estimate = cell.load_estimate;
        self.last =
            Some([level - at_end(cell.error), at_end(cell.manipulated), estimate.map_or(0.0, at_end)]);
        let range = self.until(cell.start + cell.length);
        if range.0 == range.1 {
            return;
        }
        let place = Place { start: cell.start, length: cell.length, rate: 0.0 };
        let y = Curve::of_cell(cell.error).below(level);
        let others = [Some(cell.manipulated), estimate].into_iter().flatten().map(Curve::of_cell);
        self.fill(range, place, &once(y).chain(others).collect::<Curves>());
    }

    fn segment(&mut self, segment: &Segment<'_>) {
        let level = self.scenario.initial() + segment.setpoint;
        let at_end = |signal: &Signal| segment.ends(signal).1;
        let estimate = segment.load_estimate;
        self.last =
            Some([level - at_end(segment.error), at_end(segment.manipulated), estimate.map_or(0.0, at_end)]);
        let range = self.until(segment.start + segment.length);
        if range.0 == range.1 {
            return;
        }
        let place = Place { start: segment.start, length: segment.length, rate: segment.rate };
        let curve = |signal| Curve::of_segment(segment, signal);
        let others = [Some(segment.manipulated), estimate].into_iter().flatten().map(curve);
        self.fill(range, place, &once(curve(segment.error).below(level)).chain(others).collect::<Curves>());
    }

    fn restart(&mut self) {
        self.next = 0;
        self.last = None;
    }
}
