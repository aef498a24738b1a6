//! From segment to segment: what comes out of the delay, the states it drives, what goes in again.

use std::collections::VecDeque;

use super::super::cell::{Outcome, Watch};
use super::super::error::ResponseError;
use super::super::instant::Instant;
use super::super::legendre::TERMS;
use super::super::scenario::Scenario;
use super::super::solver::{CELL_BUDGET, SETTLED, merged_events};
use super::super::system::{Rest, Row, System};
use super::plan::{Kind, Plan};
use super::segment::{Segment, layer_at};
use super::signal::{LAYER_TERMS, Signal, has_decayed};
use super::tables::INVERSE;

/// The last two coefficients of a smooth part may change a signal by this part of its largest value so far.
const TOLERANCE: f64 = 2e-14;
/// A layer's coefficients below this part of the largest value so far are not carried on.
const FLOOR: f64 = 1e-18;
/// A layer's coefficients may be larger than the signal by this factor: then cancellation has cost three digits of 16.
const CANCELLATION: f64 = 1e3;
/// Shortest segment, as a part of the delay: below, powers of the ratio of lengths leave the range of numbers.
const SHORTEST: f64 = 1e-9;

/// What is under way in the delay, from breakpoint to breakpoint.
#[derive(Debug, Clone)]
struct Piece {
    length: f64,
    /// Coefficients of the layers.
    terms: usize,
    channels: Vec<Signal>,
}

/// One loop on its way through one scenario.
pub(super) struct Propagation<'a> {
    system: &'a System,
    plan: &'a Plan,
    delay: f64,
    /// States, deviations from the point of rest; of a fast state its difference from what it follows.
    states: Vec<f64>,
    line: VecDeque<Piece>,
    now: Instant,
    setpoint: f64,
    load: f64,
    rest: Rest,
    /// Largest bounds on states and inputs so far.
    scales: Vec<f64>,
    /// Largest values of the inputs at ends of segments so far.
    values: Vec<f64>,
    quiet: f64,
    /// Signals of the segment at hand: the states.
    signals: Vec<Signal>,
    error: Signal,
    manipulated: Signal,
    load_estimate: Signal,
}

impl<'a> Propagation<'a> {
    pub(super) fn new(system: &'a System, plan: &'a Plan) -> Self {
        let n = plan.states.len();
        let mut new = Self {
            system,
            plan,
            delay: system.delays[0],
            states: vec![0.0; n],
            line: VecDeque::new(),
            now: Instant::new(0.0),
            setpoint: 0.0,
            load: 0.0,
            rest: system.rest(0.0, 0.0),
            scales: vec![0.0; n + plan.inputs.len()],
            values: vec![0.0; plan.inputs.len()],
            quiet: f64::INFINITY,
            signals: vec![Signal::ZERO; n],
            error: Signal::ZERO,
            manipulated: Signal::ZERO,
            load_estimate: Signal::ZERO,
        };
        new.empty_the_line();
        new
    }

    fn empty_the_line(&mut self) {
        self.line.clear();
        let length = self.delay / f64::from(self.plan.pieces);
        for _ in 0..self.plan.pieces {
            let channels = vec![Signal::ZERO; self.plan.inputs.len()];
            self.line.push_back(Piece { length, terms: 0, channels });
        }
    }

    pub(super) fn run(
        mut self,
        scenario: &Scenario,
        watch: &mut impl Watch,
    ) -> Option<Result<Outcome, ResponseError>> {
        let events = merged_events(scenario);
        let mut next_event = 0;
        let horizon = scenario.horizon();
        let mut segments = 0;
        loop {
            let tiny = 4.0 * f64::EPSILON * self.now.seconds().max(self.delay);
            while let Some(&(_, setpoint, load)) =
                events.get(next_event).filter(|e| self.now.until(e.0) <= tiny)
            {
                self.event(setpoint, load);
                next_event += 1;
            }
            let mut room = self.now.until(horizon);
            if room <= tiny {
                return Some(Ok(Outcome { overflow_at: None, impulsive: false }));
            }
            if let Some(event) = events.get(next_event) {
                room = room.min(self.now.until(event.0));
            }
            if self.quiet > self.delay {
                self.stand_still(room, watch);
                continue;
            }
            let mut piece = self.next_piece(room, tiny)?;
            self.compute(&mut piece, watch)?;
            self.line.push_back(piece);
            segments += 1;
            if segments > CELL_BUDGET {
                let reached = self.now.seconds();
                return Some(Err(ResponseError::HorizonTooLong { horizon, reached, cells: CELL_BUDGET }));
            }
        }
    }

    /// The setpoint and the load change by these amounts.
    fn event(&mut self, setpoint: f64, load: f64) {
        self.setpoint += setpoint;
        self.load += load;
        let before = std::mem::replace(&mut self.rest, self.system.rest(self.setpoint, self.load));
        let jump = self.system.rest(setpoint, load).states;
        for (i, state) in self.plan.states.iter().enumerate() {
            self.states[i] -=
                jump[i] - state.follows.iter().map(|&(j, weight)| weight * jump[j]).sum::<f64>();
        }
        for c in 0..self.plan.inputs.len() {
            let shift = before.delayed[c] - self.rest.delayed[c];
            for piece in &mut self.line {
                piece.channels[c].smooth[0] += shift;
            }
        }
        self.quiet = 0.0;
    }

    /// Nothing moves until the next event: one segment of constants.
    fn stand_still(&mut self, room: f64, watch: &mut impl Watch) {
        self.states.fill(0.0);
        self.empty_the_line();
        self.signals.fill(Signal::ZERO);
        self.show(room, 0, &vec![Signal::ZERO; self.plan.inputs.len()], &[], watch);
        self.now = self.now.plus(room);
        self.quiet = f64::INFINITY;
    }

    /// What comes out of the delay next, cut to `room`.
    fn next_piece(&mut self, room: f64, tiny: f64) -> Option<Piece> {
        let piece = self.line.pop_front()?;
        if room >= piece.length - tiny {
            return Some(piece);
        }
        let rest = piece.length - room;
        if room.min(rest) < SHORTEST * self.delay {
            return None;
        }
        let s = 2.0 * room / piece.length - 1.0;
        let theta = self.plan.rate * room;
        let (first, second): (Vec<Signal>, Vec<Signal>) =
            piece.channels.iter().map(|signal| signal.split(s, theta, piece.terms)).unzip();
        let second_terms = if has_decayed(theta, piece.terms) { 0 } else { piece.terms };
        self.line.push_front(Piece { length: rest, terms: second_terms, channels: second });
        Some(Piece { length: room, terms: piece.terms, channels: first })
    }

    /// Computes the segment over which `piece` comes out, shows it, and leaves in `piece` what goes in.
    fn compute(&mut self, piece: &mut Piece, watch: &mut impl Watch) -> Option<()> {
        let (plan, length) = (self.plan, piece.length);
        let inputs = plan.inputs.len();
        let terms = if plan.rate > 0.0 { (piece.terms + 1).min(LAYER_TERMS) } else { 0 };
        solve(plan, piece, terms, &self.states, &mut self.signals);
        let mut next = vec![Signal::ZERO; inputs];
        for (input, row) in next.iter_mut().zip(&plan.inputs) {
            combine(input, row, &self.signals, &piece.channels, terms);
        }
        self.show(length, terms, &next, &piece.channels, watch);

        let amplification = amplification(0.5 * length * plan.rate);
        let mut quiet = true;
        for (i, signal) in self.signals.iter().chain(&next).enumerate() {
            let size = signal.smooth_size() + signal.layer_size(terms);
            // The general way says where an unstable loop overflows.
            if !size.is_finite() || size > 1e280 {
                return None;
            }
            let scale = &mut self.scales[i];
            *scale = scale.max(size);
            quiet &= size <= SETTLED * *scale;
            let tail = signal.smooth[TERMS - 1].abs() + signal.smooth[TERMS - 2].abs();
            if tail * amplification > TOLERANCE * *scale {
                return None;
            }
        }
        let theta = plan.rate * length;
        for (state, signal) in self.states.iter_mut().zip(&self.signals) {
            *state = signal.smooth_ends().1 + layer_at(signal, theta, terms);
        }
        let mut kept = 0;
        for (c, signal) in next.iter().enumerate() {
            let (start, end) = signal.smooth_ends();
            self.values[c] = self.values[c].max((start + signal.layer[0]).abs()).max(end.abs());
            if signal.layer_size(terms) > CANCELLATION * self.values[c] {
                return None;
            }
            let floor = FLOOR * self.scales[plan.states.len() + c];
            let needed = signal.layer[..terms].iter().rposition(|q| q.abs() > floor).map_or(0, |j| j + 1);
            kept = kept.max(needed);
        }
        // A full layer has lost the coefficient that this segment would have added.
        if kept == LAYER_TERMS {
            return None;
        }
        for signal in &mut next {
            signal.layer[kept..].fill(0.0);
        }
        self.quiet = if quiet { self.quiet + length } else { 0.0 };
        self.now = self.now.plus(length);
        piece.terms = kept;
        piece.channels = next;
        Some(())
    }

    fn show(
        &mut self,
        length: f64,
        terms: usize,
        inputs: &[Signal],
        delayed: &[Signal],
        watch: &mut impl Watch,
    ) {
        let (plan, system) = (self.plan, self.system);
        self.error = Signal::ZERO;
        self.error.add(-1.0, &self.signals[system.output], terms);
        self.error.smooth[0] += self.rest.error;
        if system.input_is_manipulated {
            self.manipulated = inputs[0].clone();
        } else {
            self.manipulated = Signal::ZERO;
            combine(&mut self.manipulated, &plan.manipulated, &self.signals, delayed, terms);
        }
        self.manipulated.smooth[0] += self.rest.manipulated;
        if let Some(row) = &plan.load_estimate {
            self.load_estimate = Signal::ZERO;
            combine(&mut self.load_estimate, row, &self.signals, delayed, terms);
            self.load_estimate.smooth[0] += self.rest.load_estimate;
        }
        watch.segment(&Segment {
            start: self.now.seconds(),
            length,
            setpoint: self.setpoint,
            rate: plan.rate,
            terms,
            error: &self.error,
            manipulated: &self.manipulated,
            load_estimate: plan.load_estimate.as_ref().map(|_| &self.load_estimate),
        });
    }
}

/// The largest effect on any coefficient, through the fast lag, of an error of 1 in the last one.
fn amplification(half: f64) -> f64 {
    let (mut effect, mut largest) = (1.0, 1.0f64);
    if half > 0.0 && half < 24.0 {
        for inverse in INVERSE[1..TERMS].iter().rev() {
            effect /= half * inverse;
            largest = largest.max(effect);
        }
    }
    largest
}

#[inline(always)]
fn combine(sum: &mut Signal, row: &Row, states: &[Signal], delayed: &[Signal], terms: usize) {
    for &(i, weight) in &row.states {
        sum.add(weight, &states[i], terms);
    }
    for &(c, weight) in row.delayed.iter().filter(|(c, _)| *c < delayed.len()) {
        sum.add(weight, &delayed[c], terms);
    }
}

/// All states over the segment in which `piece` comes out.
#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
fn solve(plan: &Plan, piece: &Piece, terms: usize, start: &[f64], signals: &mut [Signal]) {
    let half = 0.5 * piece.length;
    for (i, state) in plan.states.iter().enumerate() {
        let mut drive = Signal::ZERO;
        combine(&mut drive, &state.drive, signals, &piece.channels, terms);
        let x = &mut signals[i];
        match state.kind {
            Kind::Integral => {
                for j in 0..TERMS - 1 {
                    x.smooth[j + 1] = half * INVERSE[j + 1] * drive.smooth[j];
                }
                x.smooth[0] = 0.0;
                if terms > 0 {
                    sum_backwards(x, &drive, 1.0 / plan.rate, 1.0, terms);
                }
                x.smooth[0] = start[i] - x.layer[0] - x.smooth_ends().0;
            }
            Kind::Slow(own) => {
                let (mut particular, mut homogeneous) = (0.0, 1.0);
                let mut all = Signal::ZERO;
                x.smooth[0] = 0.0;
                all.smooth[0] = 1.0;
                for j in 0..TERMS - 1 {
                    particular = half * INVERSE[j + 1] * (own * particular + drive.smooth[j]);
                    homogeneous *= half * own * INVERSE[j + 1];
                    x.smooth[j + 1] = particular;
                    all.smooth[j + 1] = homogeneous;
                }
                if terms > 0 {
                    sum_backwards(x, &drive, 1.0 / plan.rate, 1.0 / (1.0 + own / plan.rate), terms);
                }
                let missing = start[i] - x.layer[0] - x.smooth_ends().0;
                let reach = missing / all.smooth_ends().0;
                x.add(reach, &all, 0);
            }
            Kind::Fast => {
                let (inverse_rate, inverse_half) = (1.0 / plan.rate, 1.0 / (half * plan.rate));
                let mut above = 0.0;
                let mut index = 24.0;
                for j in (0..TERMS).rev() {
                    above = drive.smooth[j] * inverse_rate - index * inverse_half * above;
                    index -= 1.0;
                    x.smooth[j] = above;
                }
                for j in 1..terms {
                    x.layer[j] = drive.layer[j - 1] * inverse_rate;
                }
                x.layer[terms..].fill(0.0);
                x.layer[0] = start[i] - x.smooth_ends().0;
            }
        }
    }
}

/// The layer of an integrator or a slow lag: `q_j = damping·(q_(j+1) − step·drive_j)`.
#[inline(always)]
fn sum_backwards(x: &mut Signal, drive: &Signal, step: f64, damping: f64, terms: usize) {
    x.layer[terms..].fill(0.0);
    let mut above = 0.0;
    for j in (0..terms).rev() {
        above = damping * (above - step * drive.layer[j]);
        x.layer[j] = above;
    }
}
