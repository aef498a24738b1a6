//! The method of steps: cell by cell, every signal a polynomial, every cell accepted by its last coefficients.
//!
//! States are deviations from the point of rest of the current setpoint and load, so that what decays keeps its
//! relative accuracy and a settled loop is exactly at rest.

use super::cell::{Cell, Outcome, Watch};
use super::delay_line::DelayLine;
use super::error::ResponseError;
use super::instant::Instant;
use super::lag::{CoupledLags, Lag};
use super::legendre::{Poly, TERMS, add, ends, integrated, magnitude, significant, tail};
use super::scenario::Scenario;
use super::system::{Rest, Row, System};

/// Cells, those that were too long included, after which a simulation gives up (a few seconds of computing).
pub(super) const CELL_BUDGET: u64 = 1_000_000;
/// Cells of a loop with states that drive each other count as so many.
const COUPLED_COST: u64 = 10;
/// A cell is accepted when its last coefficients are below this part of the signal's largest value so far.
const TOLERANCE: f64 = 2e-14;
/// The same where states drive each other: stiff coupled lags leave 24² roundings in the last coefficients.
const COUPLED_TOLERANCE: f64 = 4e-13;
/// And always when they are below this part of the sum of magnitudes it was made from: that is rounding.
const ROUNDING: f64 = 1e-15;
/// Last coefficients below this part of the signal's largest value so far, and below a millionth of the signal here, are
/// not carried on.
const FLOOR: f64 = 1e-18;
/// Signals below this part of their largest value so far, for the longest delay, are at rest.
pub(super) const SETTLED: f64 = 1e-20;
/// Breakpoints that went through the loop more often than this are left to the acceptance test.
const BREAKPOINT_ORDER: u32 = 40;

/// Factors of one block for one cell length.
#[derive(Debug, Clone)]
#[expect(clippy::large_enum_variant, reason = "a box would cost an indirection in the hot loop")]
enum Factors {
    Integral,
    Lag(Lag),
    Coupled(CoupledLags),
    Unusable,
}

/// An impulse on its way through a channel.
#[derive(Debug, Clone, Copy)]
struct Impulse {
    arrival: Instant,
    channel: usize,
    mass: f64,
}

/// One loop on its way through one scenario.
pub(super) struct Solver<'a> {
    system: &'a System,
    states: Vec<f64>,
    lines: Vec<DelayLine>,
    impulses: Vec<Impulse>,
    now: Instant,
    setpoint: f64,
    load: f64,
    rest: Rest,
    state_scales: Vec<f64>,
    input_scales: Vec<f64>,
    /// Longest next cell [s], from how the last ones went.
    cap: f64,
    /// Cells since the last event, while the fastest pole's layer lasts.
    since_event: usize,
    /// Rate of the fastest pole [1/s].
    fastest: f64,
    quiet: f64,
    tolerance: f64,
    /// Cells computed so far.
    tried: u64,
    /// What a cell counts: states that drive each other cost many times more.
    cost: u64,
    longest_delay: f64,
    impulsive: bool,
    cache: Vec<(u64, Vec<Factors>)>,
    /// Bounds on the last computed cell.
    state_sizes: Vec<f64>,
    input_sizes: Vec<f64>,
    state_polys: Vec<Poly>,
    delayed_polys: Vec<Poly>,
    input_polys: Vec<Poly>,
    end_states: Vec<f64>,
}

const CACHE: usize = 64;

/// Cells after an event, in time constants of the fastest pole, that resolve the layer it leaves to 1e-14.
const LAYER: [f64; 4] = [6.0, 8.0, 12.0, 30.0];

impl<'a> Solver<'a> {
    pub(super) fn new(system: &'a System) -> Self {
        let (n, channels) = (system.rates.len(), system.inputs.len());
        let fastest = system.fastest();
        let coupled = system.blocks.iter().any(|(from, to)| to - from > 1);
        Self {
            system,
            states: vec![0.0; n],
            lines: system.delays.iter().map(|&d| DelayLine::at_rest(d, channels > 1)).collect(),
            impulses: Vec::new(),
            now: Instant::new(0.0),
            setpoint: 0.0,
            load: 0.0,
            rest: system.rest(0.0, 0.0),
            state_scales: vec![0.0; n],
            input_scales: vec![0.0; channels],
            cap: f64::INFINITY,
            since_event: LAYER.len(),
            fastest,
            quiet: f64::INFINITY,
            tolerance: if coupled { COUPLED_TOLERANCE } else { TOLERANCE },
            tried: 0,
            cost: if coupled { COUPLED_COST } else { 1 },
            longest_delay: system.delays.iter().copied().fold(0.0, f64::max),
            impulsive: false,
            cache: vec![(0, Vec::new()); CACHE],
            state_sizes: vec![0.0; n],
            input_sizes: vec![0.0; channels],
            state_polys: vec![[0.0; TERMS]; n],
            delayed_polys: vec![[0.0; TERMS]; channels],
            input_polys: vec![[0.0; TERMS]; channels],
            end_states: vec![0.0; n],
        }
    }

    /// Runs the scenario and shows every cell to `watch`.
    pub(super) fn run(
        mut self,
        scenario: &Scenario,
        watch: &mut dyn Watch,
    ) -> Result<Outcome, ResponseError> {
        let events = merged_events(scenario);
        let mut next_event = 0;
        let horizon = scenario.horizon();
        loop {
            let tiny = self.tiny();
            let mut breakpoint = None;
            while let Some(&(_, setpoint, load)) =
                events.get(next_event).filter(|e| self.now.until(e.0) <= tiny)
            {
                self.event(setpoint, load);
                next_event += 1;
                breakpoint = Some(0);
            }
            if self.deliver_impulses(tiny) {
                breakpoint = Some(0);
            }
            let mut room = self.now.until(horizon);
            if room <= tiny {
                return Ok(self.outcome(None));
            }
            if let Some(event) = events.get(next_event) {
                room = room.min(self.now.until(event.0));
            }
            if self.quiet > self.longest_delay && self.impulses.is_empty() {
                self.stand_still(room, watch);
                continue;
            }
            for impulse in &self.impulses {
                room = room.min(impulse.arrival.since(self.now));
            }
            for line in &self.lines {
                if let Some(order) = line.breakpoint_now(tiny) {
                    breakpoint = Some(breakpoint.map_or(order, |b: u32| b.min(order)));
                }
            }
            let Some(length) = self.step(room, tiny) else {
                return Ok(self.outcome(Some(self.now.seconds())));
            };
            self.show(length, watch);
            self.commit(length, tiny, breakpoint);
            if self.tried > CELL_BUDGET {
                let reached = self.now.seconds();
                let cells = CELL_BUDGET / self.cost;
                return Err(ResponseError::HorizonTooLong { horizon, reached, cells });
            }
        }
    }

    fn outcome(&self, overflow_at: Option<f64>) -> Outcome {
        Outcome { overflow_at, impulsive: self.impulsive }
    }

    /// Times closer than this are the same time [s].
    fn tiny(&self) -> f64 {
        4.0 * f64::EPSILON * self.now.seconds().max(self.longest_delay)
    }

    /// The setpoint and the load change by these amounts.
    fn event(&mut self, setpoint: f64, load: f64) {
        self.setpoint += setpoint;
        self.load += load;
        let before = std::mem::replace(&mut self.rest, self.system.rest(self.setpoint, self.load));
        let step = self.system.rest(setpoint, load);
        for (i, state) in self.states.iter_mut().enumerate() {
            *state += self.system.rates[i].setpoint_rate * setpoint - step.states[i];
        }
        for (c, line) in self.lines.iter_mut().enumerate() {
            let shift = before.delayed[c] - self.rest.delayed[c];
            if shift != 0.0 {
                line.shift(shift);
            }
            let mass = self.system.inputs[c].setpoint_rate * setpoint;
            if mass != 0.0 {
                self.impulses.push(Impulse {
                    arrival: self.now.plus(self.system.delays[c]),
                    channel: c,
                    mass,
                });
            }
        }
        self.impulsive |= self.system.manipulated.setpoint_rate * setpoint != 0.0;
        self.quiet = 0.0;
        self.cap = f64::INFINITY;
        self.since_event = 0;
    }

    /// Impulses that come out of their channel now: states jump and what passes straight on goes in again.
    fn deliver_impulses(&mut self, tiny: f64) -> bool {
        let mut any = false;
        let mut index = 0;
        while index < self.impulses.len() {
            if self.impulses[index].arrival.since(self.now) > tiny {
                index += 1;
                continue;
            }
            let Impulse { channel, mass, arrival } = self.impulses.swap_remove(index);
            any = true;
            for (state, row) in self.states.iter_mut().zip(&self.system.rates) {
                *state += row.channel(channel) * mass;
            }
            self.impulsive |= self.system.manipulated.channel(channel) != 0.0;
            for (c, row) in self.system.inputs.iter().enumerate() {
                let passed = row.channel(channel) * mass;
                // Below the smallest normal number nothing is left to carry.
                if passed.abs() > f64::MIN_POSITIVE {
                    let arrival = arrival.plus(self.system.delays[c]);
                    self.impulses.push(Impulse { arrival, channel: c, mass: passed });
                }
            }
        }
        if any {
            self.quiet = 0.0;
        }
        any
    }

    /// Nothing moves until the next event: one cell of constants.
    fn stand_still(&mut self, room: f64, watch: &mut dyn Watch) {
        self.states.fill(0.0);
        for (line, &delay) in self.lines.iter_mut().zip(&self.system.delays) {
            *line = DelayLine::at_rest(delay, self.system.delays.len() > 1);
        }
        self.state_polys.fill([0.0; TERMS]);
        self.input_polys.fill([0.0; TERMS]);
        self.delayed_polys.fill([0.0; TERMS]);
        self.show(room, watch);
        self.now = self.now.plus(room);
        self.quiet = f64::INFINITY;
    }

    /// Finds the next acceptable cell; returns its length, or `None` on overflow.
    fn step(&mut self, room: f64, tiny: f64) -> Option<f64> {
        let several = self.lines.len() > 1;
        if !several && self.lines[0].at_edge() {
            // A new parent cell: how its neighbour had to be cut says nothing.
            self.cap = f64::INFINITY;
        }
        let ahead = self
            .lines
            .iter()
            .map(|line| if several { line.to_edge_within(2, tiny) } else { line.to_edge() })
            .fold(f64::INFINITY, f64::min);
        let mut length = ahead;
        if room < length - tiny {
            length = room;
        }
        let layer = LAYER.get(self.since_event).map_or(f64::INFINITY, |&part| part / self.fastest);
        self.since_event += 1;
        let cap = self.cap.min(layer);
        // No slivers: what is left after this cell is at least a third of it.
        if cap * 1.3 < length {
            length = cap;
        }
        let shortest = tiny.max(1e-13 * self.longest_delay);
        let mut halved = false;
        loop {
            self.compute(length, tiny);
            let good = self.acceptable();
            if good.is_none() && length <= shortest * 2.0 {
                return None;
            }
            // A small part of one resolved cell, short against every pole, is resolved: what is left is rounding.
            let smooth = length * self.fastest <= 1.0 && self.lines.iter().all(|l| l.is_within(8.0 * length));
            if good == Some(true) || good.is_some() && smooth || length <= shortest * 2.0 {
                self.cap = if halved { 2.0 * length } else { 3.0 * self.cap };
                return good.map(|_| length);
            }
            if good.is_none() && self.at_the_end_of_range() {
                return None;
            }
            length *= 0.5;
            halved = true;
        }
    }

    /// Computes all polynomials of the next cell of this length.
    fn compute(&mut self, length: f64, tiny: f64) {
        for (poly, line) in self.delayed_polys.iter_mut().zip(&self.lines) {
            *poly = line.ahead(length, tiny).0;
        }
        self.tried += self.cost;
        let system = self.system;
        let slot = self.factors(length);
        let half = 0.5 * length;
        for (factors, &(from, to)) in self.cache[slot].1.iter().zip(&system.blocks) {
            if let Factors::Coupled(lags) = factors {
                let forcing: Vec<Poly> = (from..to)
                    .map(|i| forcing(system, i, from, half, &self.state_polys, &self.delayed_polys, self))
                    .collect();
                lags.solve(&forcing, &self.states[from..to], &mut self.state_polys[from..to]);
                for i in from..to {
                    self.end_states[i] = ends(&self.state_polys[i]).1;
                }
                continue;
            }
            let g = forcing(system, from, from, half, &self.state_polys, &self.delayed_polys, self);
            let start = self.states[from];
            match factors {
                Factors::Lag(lag) => {
                    self.state_polys[from] = lag.solve(&g, start);
                    self.end_states[from] = ends(&self.state_polys[from]).1;
                }
                Factors::Unusable | Factors::Coupled(_) => self.state_polys[from] = [f64::NAN; TERMS],
                Factors::Integral => {
                    self.state_polys[from] = integrated(&g);
                    self.state_polys[from][0] += start;
                    self.end_states[from] = start + 2.0 * g[0];
                }
            }
        }
        for (c, row) in system.inputs.iter().enumerate() {
            let mut input = combined(row, &self.state_polys, &self.delayed_polys);
            if !system.has_rest {
                input[0] += row.constant(self.setpoint, self.load);
            }
            self.input_sizes[c] = magnitude(&input);
            self.input_polys[c] = input;
        }
        for (size, poly) in self.state_sizes.iter_mut().zip(&self.state_polys) {
            *size = magnitude(poly);
        }
    }

    /// Whether the cell resolves its signals; `None` if they are not finite.
    fn acceptable(&self) -> Option<bool> {
        if !self.finite() {
            return None;
        }
        let resolved = |poly: &Poly, size: f64, scale: f64, noise: f64| {
            tail(poly) <= self.tolerance * scale.max(size) + ROUNDING * noise
        };
        let noise = |row: &Row| row.states.iter().map(|&(i, w)| w.abs() * self.state_scales[i]).sum();
        let mut good = true;
        for (i, poly) in self.state_polys.iter().enumerate() {
            good &= resolved(poly, self.state_sizes[i], self.state_scales[i], 0.0);
        }
        for (c, row) in self.system.inputs.iter().enumerate() {
            let (scale, noise) = (self.input_scales[c], noise(row));
            good &= resolved(&self.input_polys[c], self.input_sizes[c], scale, noise);
            if self.lines.len() > 1 {
                good &= resolved(&self.delayed_polys[c], 0.0, scale, noise);
            }
        }
        Some(good)
    }

    fn finite(&self) -> bool {
        let bounds = self.state_sizes.iter().chain(&self.input_sizes).chain(&self.end_states);
        bounds.map(|x| x.abs()).sum::<f64>().is_finite()
    }

    /// Whether the signals are so large that the next cell overflows.
    fn at_the_end_of_range(&self) -> bool {
        self.state_scales.iter().chain(&self.input_scales).any(|&s| s > 1e280)
    }

    fn show(&self, length: f64, watch: &mut dyn Watch) {
        let system = self.system;
        let mut error = self.state_polys[system.output].map(|c| -c);
        error[0] += self.rest.error;
        let mut manipulated = if system.input_is_manipulated && system.has_rest {
            self.input_polys[0]
        } else {
            combined(&system.manipulated, &self.state_polys, &self.delayed_polys)
        };
        manipulated[0] += if system.has_rest {
            self.rest.manipulated
        } else {
            system.manipulated.constant(self.setpoint, self.load)
        };
        let estimate = system.load_estimate.as_ref().map(|row| {
            let mut estimate = combined(row, &self.state_polys, &self.delayed_polys);
            estimate[0] += self.rest.load_estimate;
            estimate
        });
        if !system.has_rest {
            error[0] += self.setpoint - self.rest.error;
        }
        watch.cell(&Cell {
            start: self.now.seconds(),
            length,
            setpoint: self.setpoint,
            error: &error,
            manipulated: &manipulated,
            load_estimate: estimate.as_ref(),
        });
    }

    fn commit(&mut self, length: f64, tiny: f64, breakpoint: Option<u32>) {
        let mut quiet = true;
        for (i, state) in self.states.iter_mut().enumerate() {
            *state = self.end_states[i];
            let size = self.state_sizes[i];
            self.state_scales[i] = self.state_scales[i].max(size);
            quiet &= size <= SETTLED * self.state_scales[i];
        }
        let order = breakpoint.filter(|&b| self.lines.len() > 1 && b < BREAKPOINT_ORDER).map(|b| b + 1);
        for (c, line) in self.lines.iter_mut().enumerate() {
            let size = self.input_sizes[c];
            self.input_scales[c] = self.input_scales[c].max(size);
            quiet &= size <= SETTLED * self.input_scales[c];
            line.advance(length, tiny);
            let terms = significant(&self.input_polys[c], (FLOOR * self.input_scales[c]).min(1e-6 * size));
            line.push(length, &self.input_polys[c], terms, order);
        }
        self.quiet = if quiet { self.quiet + length } else { 0.0 };
        self.now = self.now.plus(length);
    }

    /// Index of the factors for this cell length, computed if they are not there.
    fn factors(&mut self, length: f64) -> usize {
        let bits = length.to_bits();
        let hash = bits.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 58;
        let slot = usize::try_from(hash).unwrap_or(0) % CACHE;
        if self.cache[slot].0 != bits {
            let system = self.system;
            let half = 0.5 * length;
            let made = system.blocks.iter().map(|&(from, to)| {
                if to > from + 1 {
                    let matrix = system.block_matrix((from, to), half);
                    CoupledLags::new(matrix, to - from).map_or(Factors::Unusable, Factors::Coupled)
                } else if system.own_rate(from) == 0.0 {
                    Factors::Integral
                } else {
                    Factors::Lag(Lag::new(half * system.own_rate(from)))
                }
            });
            self.cache[slot] = (bits, made.collect());
        }
        slot
    }
}

/// Forcing of state `i` by earlier blocks (states before `from`) and delayed signals, times half the cell.
fn forcing(
    system: &System,
    i: usize,
    from: usize,
    half: f64,
    states: &[Poly],
    delayed: &[Poly],
    solver: &Solver<'_>,
) -> Poly {
    let row = &system.rates[i];
    let mut g = [0.0; TERMS];
    for &(c, weight) in &row.delayed {
        add(&mut g, half * weight, &delayed[c]);
    }
    for &(j, weight) in row.states.iter().filter(|(j, _)| *j < from) {
        add(&mut g, half * weight, &states[j]);
    }
    if !system.has_rest {
        g[0] += half * row.constant(solver.setpoint, solver.load);
    }
    g
}

fn combined(row: &Row, states: &[Poly], delayed: &[Poly]) -> Poly {
    let mut sum = [0.0; TERMS];
    for &(i, weight) in &row.states {
        add(&mut sum, weight, &states[i]);
    }
    for &(c, weight) in &row.delayed {
        add(&mut sum, weight, &delayed[c]);
    }
    sum
}

/// Time and change of setpoint and load, in order of time.
pub(super) fn merged_events(scenario: &Scenario) -> Vec<(f64, f64, f64)> {
    let mut events: Vec<(f64, f64, f64)> = scenario
        .setpoint_moves()
        .into_iter()
        .map(|(t, step)| (t, step, 0.0))
        .chain(scenario.load_moves().into_iter().map(|(t, step)| (t, 0.0, step)))
        .collect();
    events.sort_by(|a, b| a.0.total_cmp(&b.0));
    events
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::response::layered::Segment;
    use crate::model::{ClosedLoop, Controller, Process, Seconds};

    /// Lengths of all cells.
    struct Lengths(Vec<f64>);

    impl Watch for Lengths {
        fn cell(&mut self, cell: &Cell<'_>) {
            self.0.push(cell.length);
        }

        fn segment(&mut self, _: &Segment<'_>) {
            unreachable!("this solver makes cells");
        }

        fn restart(&mut self) {
            self.0.clear();
        }
    }

    fn lengths(controller: Controller, horizon: f64) -> Vec<f64> {
        let process = Process::integrating(0.0506, Seconds(6.0)).unwrap();
        let load = vec![(horizon / 2.0, 1.0)];
        let scenario = Scenario::new(vec![(0.0, 1.0)], load, Seconds(horizon), 0.0).unwrap();
        let system = System::new(&ClosedLoop::new(&process, &controller));
        let mut lengths = Lengths(Vec::new());
        Solver::new(&system).run(&scenario, &mut lengths).unwrap();
        lengths.0
    }

    #[test]
    fn a_loop_without_a_fast_pole_takes_one_cell_between_breakpoints() {
        let pi = Controller::proportional(1.6).unwrap().with_integral_time(Seconds(48.0)).unwrap();
        // 200 s: 34 images of the first event, 17 of the second.
        assert_eq!(lengths(pi, 200.0).len(), 34 + 17);
    }

    #[test]
    fn a_filtered_derivative_takes_a_few_cells_between_breakpoints() {
        let pid = Controller::proportional(2.95).unwrap().with_integral_time(Seconds(15.0)).unwrap();
        let pid = pid.with_derivative_time(Seconds(3.0)).unwrap().with_filter_bandwidth(100.0).unwrap();
        let lengths = lengths(pid, 200.0);
        assert!(lengths.len() <= 51 * 5, "{} {lengths:?}", lengths.len());
    }

    #[test]
    fn a_settled_loop_reaches_any_horizon_in_few_cells() {
        let pi = Controller::proportional(1.6).unwrap().with_integral_time(Seconds(48.0)).unwrap();
        assert!(lengths(pi, 1e9).len() < 1000);
    }
}
