//! Values of the signals at requested times, from cells and from segments.

use super::cell::{Cell, Outcome, Watch};
use super::error::ResponseError;
use super::layered::{Segment, Signal, add_layer};
use super::legendre::{Poly, ends, evaluate, magnitude, powers, significant};
use super::scenario::Scenario;
use super::system::System;
use super::trajectory::Trajectory;

/// What is this part of a signal is not seen.
const UNSEEN: f64 = 1e-13;

/// Value at each time of what starts at `rest` and is held from event to event.
fn hold(values: &mut Vec<f64>, times: &[f64], sorted: bool, rest: f64, events: &[(f64, f64)]) {
    values.clear();
    values.resize(times.len(), rest);
    for &(at, value) in events {
        if sorted {
            let from = times.partition_point(|&t| t < at);
            values[from..].fill(value);
        } else {
            for (held, _) in values.iter_mut().zip(times).filter(|(_, t)| **t >= at) {
                *held = value;
            }
        }
    }
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
    pub(super) fn new(system: &System, scenario: &'a Scenario, times: &[f64]) -> Result<Self, ResponseError> {
        Self::reusing(system, scenario, Trajectory { time: times.to_vec(), ..Trajectory::default() })
    }

    /// Overwrites the signals of a trajectory at its times, in its memory.
    pub(super) fn reusing(
        system: &System,
        scenario: &'a Scenario,
        mut result: Trajectory,
    ) -> Result<Self, ResponseError> {
        let horizon = scenario.horizon();
        let times = &result.time;
        let is_within = |t: f64| t >= 0.0 && t <= horizon;
        // Counting has no way out of the loop, so it is done in vectors.
        let outside: usize = times.iter().map(|&t| usize::from(!is_within(t))).sum();
        if let Some(&value) = times.iter().find(|t| outside > 0 && !is_within(**t)) {
            return Err(ResponseError::TimeOutside { value, horizon });
        }
        let steps_back: usize = times.iter().zip(times.iter().skip(1)).map(|(a, b)| usize::from(a > b)).sum();
        let sorted = steps_back == 0;
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
        result.load_estimate = system.load_estimate.as_ref().map(|_| {
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

/// One signal as a function of time: powers of s, and a layer that counts until `over`.
struct Curve<'a> {
    start: f64,
    length: f64,
    powers: Poly,
    terms: usize,
    layer: &'a [f64],
    /// Factor of the layer, and its rate [1/s].
    factor: f64,
    rate: f64,
    over: f64,
}

impl Curve<'_> {
    fn of_cell((start, length): (f64, f64), poly: &Poly) -> Self {
        let (powers, terms) = powers(poly);
        Self { start, length, powers, terms, layer: &[], factor: 0.0, rate: 0.0, over: start }
    }

    fn of_segment<'a>(segment: &Segment<'_>, signal: &'a Signal) -> Curve<'a> {
        let size = magnitude(&signal.smooth);
        let layer = &signal.layer[..segment.terms];
        let floor = UNSEEN * (size + layer.iter().map(|q| q.abs()).sum::<f64>());
        let terms = significant(&signal.smooth, floor);
        // No e^(−θ)·θ^j/j! exceeds 1.
        let mut left_out = 0.0;
        let counts = |q: &f64| {
            left_out += q.abs();
            left_out > floor
        };
        let layer_terms = layer.iter().rposition(counts).map_or(0, |last| last + 1);
        Curve {
            start: segment.start,
            length: segment.length,
            powers: signal.smooth,
            terms,
            layer: &layer[..layer_terms],
            factor: 1.0,
            rate: segment.rate,
            over: segment.start + segment.layer_over(signal, UNSEEN) / segment.rate.max(f64::MIN_POSITIVE),
        }
    }

    /// `level − self`.
    fn below(mut self, level: f64) -> Self {
        for c in &mut self.powers {
            *c = -*c;
        }
        self.powers[0] += level;
        self.terms = self.terms.max(1);
        self.factor = -1.0;
        self
    }

    fn evaluate(&self, times: &[f64], values: &mut [f64]) {
        evaluate(&self.powers[..self.terms], (self.start, 2.0 / self.length), times, values);
        if !self.layer.is_empty() {
            let near = times.partition_point(|&t| t < self.over);
            let place = (self.start, self.rate);
            add_layer(self.layer, self.factor, place, &times[..near], &mut values[..near]);
        }
    }

    /// Fills in the values at these positions.
    fn fill(&self, (from, to): (usize, usize), order: Option<&[usize]>, times: &[f64], values: &mut [f64]) {
        match order {
            None => self.evaluate(&times[from..to], &mut values[from..to]),
            Some(order) => {
                for &i in &order[from..to] {
                    self.evaluate(&times[i..=i], &mut values[i..=i]);
                }
            }
        }
    }
}

impl Sampler<'_> {
    /// Fills in the times before the end of a stretch of time over which the signals are these curves.
    fn add(&mut self, range: (usize, usize), y: &Curve<'_>, u: &Curve<'_>, estimate: Option<&Curve<'_>>) {
        let order = self.order.as_deref();
        let Trajectory { time, controlled_variable, manipulated_variable, load_estimate, .. } =
            &mut self.result;
        y.fill(range, order, time, controlled_variable);
        u.fill(range, order, time, manipulated_variable);
        if let Some((curve, values)) = estimate.zip(load_estimate.as_mut()) {
            curve.fill(range, order, time, values);
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
        let place = (cell.start, cell.length);
        let curve = |poly| Curve::of_cell(place, poly);
        let y = curve(cell.error).below(level);
        self.add(range, &y, &curve(cell.manipulated), estimate.map(curve).as_ref());
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
        let curve = |signal| Curve::of_segment(segment, signal);
        let y = curve(segment.error).below(level);
        self.add(range, &y, &curve(segment.manipulated), estimate.map(curve).as_ref());
    }

    fn restart(&mut self) {
        self.next = 0;
        self.last = None;
    }
}
