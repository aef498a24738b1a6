//! From segment to segment: what comes out of the delay, the states it drives, what goes in again.
//!
//! Several loops go together, one in each lane, as long as the same things happen to them in the same order: their
//! segments then differ in length only.

use std::collections::VecDeque;
use std::mem::swap;

use super::super::cell::Outcome;
use super::super::error::ResponseError;
use super::super::instant::Instant;
use super::super::legendre::TERMS;
use super::super::scenario::Scenario;
use super::super::solver::{CELL_BUDGET, SETTLED, merged_events};
use super::super::system::{Rest, System};
use super::lanes::{Lanes, agreed};
use super::signal::{LAYER_TERMS, decay};
use super::signals::Signals;
use super::states::{arrive, size_and_tail, solve, weighted};
use super::tables::INVERSE;
use super::together::Together;

/// The last two coefficients of a smooth part may change a signal by this part of its largest value so far.
const TOLERANCE: f64 = 2e-14;
/// Coefficients below this part of the largest value so far are not carried on.
const FLOOR: f64 = 1e-16;
/// A layer's coefficients may be larger than the signal by this factor: then cancellation has cost three digits of 16.
const CANCELLATION: f64 = 1e3;
/// Shortest segment, as a part of the delay: below, powers of the ratio of lengths leave the range of numbers.
const SHORTEST: f64 = 1e-9;

/// What happens to each loop from one breakpoint to the next.
pub(super) struct Stretch<'a, const L: usize> {
    /// Start [s].
    pub(super) start: Lanes<L>,
    /// Length [s].
    pub(super) length: Lanes<L>,
    /// Setpoint, relative to the initial level.
    pub(super) setpoint: f64,
    /// Rate of the fast pole [1/s].
    pub(super) rate: Lanes<L>,
    /// Coefficients of the layers.
    pub(super) terms: usize,
    /// Control error.
    pub(super) error: &'a Signals<L>,
    /// Controller output.
    pub(super) manipulated: &'a Signals<L>,
    /// Load estimate of the observer.
    pub(super) load_estimate: Option<&'a Signals<L>>,
}

/// Receives the response of several loops as it is computed.
pub(super) trait Follow<const L: usize> {
    /// The next stretch, in order.
    fn stretch(&mut self, stretch: &Stretch<'_, L>);
}

/// What is under way in the delay, from breakpoint to breakpoint.
#[derive(Debug, Clone)]
struct Piece<const L: usize> {
    length: Lanes<L>,
    /// Coefficients of the layers.
    terms: usize,
    channels: Vec<Signals<L>>,
}

/// `L` loops on their way through one scenario.
pub(super) struct Propagation<'a, const L: usize> {
    systems: [&'a System; L],
    plan: &'a Together<L>,
    delay: Lanes<L>,
    /// States, deviations from the point of rest; of a fast state its difference from what it follows.
    states: Vec<Lanes<L>>,
    line: VecDeque<Piece<L>>,
    /// Storage for what goes in next.
    spare: Vec<Signals<L>>,
    now: [Instant; L],
    setpoint: f64,
    load: f64,
    rests: [Rest; L],
    /// Largest bounds on states and inputs so far.
    scales: Vec<Lanes<L>>,
    /// Largest values of the inputs at ends of segments so far.
    values: Vec<Lanes<L>>,
    quiet: Lanes<L>,
    /// Smooth coefficients below this part of the largest value so far are not carried on.
    floor: f64,
    /// Signals of the segment at hand: the states.
    signals: Vec<Signals<L>>,
    error: Signals<L>,
    manipulated: Signals<L>,
    load_estimate: Signals<L>,
}

impl<'a, const L: usize> Propagation<'a, L> {
    pub(super) fn new(systems: [&'a System; L], plan: &'a Together<L>) -> Self {
        let n = plan.states.len();
        let inputs = plan.inputs.len();
        let mut new = Self {
            systems,
            plan,
            delay: Lanes(systems.map(|system| system.delays[0])),
            states: vec![Lanes::ZERO; n],
            line: VecDeque::new(),
            spare: vec![Signals::ZERO; inputs],
            now: [Instant::new(0.0); L],
            setpoint: 0.0,
            load: 0.0,
            rests: systems.map(|system| system.rest(0.0, 0.0)),
            scales: vec![Lanes::ZERO; n + inputs],
            values: vec![Lanes::ZERO; inputs],
            quiet: Lanes::all(f64::INFINITY),
            floor: 0.0,
            signals: vec![Signals::ZERO; n],
            error: Signals::ZERO,
            manipulated: Signals::ZERO,
            load_estimate: Signals::ZERO,
        };
        new.empty_the_line();
        new
    }

    fn empty_the_line(&mut self) {
        self.line.clear();
        let length = self.delay / f64::from(self.plan.pieces);
        for _ in 0..self.plan.pieces {
            let channels = vec![Signals::ZERO; self.plan.inputs.len()];
            self.line.push_back(Piece { length, terms: 0, channels });
        }
    }

    /// Runs the scenario; `None` where the expansion does not hold to rounding, or the loops part ways.
    pub(super) fn run(
        mut self,
        scenario: &Scenario,
        watch: &mut impl Follow<L>,
    ) -> Option<Result<Outcome, ResponseError>> {
        let events = merged_events(scenario);
        let mut next_event = 0;
        let horizon = scenario.horizon();
        let mut segments = 0;
        loop {
            let now = self.now;
            let mut tiny = self.delay;
            for l in 0..L {
                tiny.0[l] = 4.0 * f64::EPSILON * now[l].seconds().max(self.delay.0[l]);
            }
            let reached = |time: f64| agreed::<L>(|l| now[l].until(time) <= tiny.0[l]);
            while let Some(&(time, setpoint, load)) = events.get(next_event)
                && reached(time)?
            {
                self.event(setpoint, load);
                next_event += 1;
            }
            if reached(horizon)? {
                return Some(Ok(Outcome { overflow_at: None, impulsive: false }));
            }
            let until = events.get(next_event).map_or(horizon, |event| event.0.min(horizon));
            let room = Lanes(now.map(|now| now.until(until)));
            let (quiet, delay) = (self.quiet, self.delay);
            if quiet.every(delay, |quiet, delay| quiet > delay) {
                self.stand_still(room, watch);
                continue;
            }
            let mut piece = self.next_piece(room, tiny)?;
            self.compute(&mut piece, watch)?;
            self.line.push_back(piece);
            segments += 1;
            if segments > CELL_BUDGET {
                let reached = self.now[0].seconds();
                return Some(Err(ResponseError::HorizonTooLong { horizon, reached, cells: CELL_BUDGET }));
            }
        }
    }

    /// The setpoint and the load change by these amounts.
    fn event(&mut self, setpoint: f64, load: f64) {
        self.setpoint += setpoint;
        self.load += load;
        for (l, system) in self.systems.iter().enumerate() {
            let before = std::mem::replace(&mut self.rests[l], system.rest(self.setpoint, self.load));
            let jump = system.rest(setpoint, load).states;
            for (i, state) in self.plan.states.iter().enumerate() {
                let followed: f64 = state.follows.iter().map(|&(j, weight)| weight.0[l] * jump[j]).sum();
                self.states[i].0[l] -= jump[i] - followed;
            }
            for c in 0..self.plan.inputs.len() {
                let shift = before.delayed[c] - self.rests[l].delayed[c];
                for piece in &mut self.line {
                    piece.channels[c].smooth[0].0[l] += shift;
                }
            }
        }
        self.quiet = Lanes::ZERO;
    }

    /// Nothing moves until the next event: one segment of constants.
    fn stand_still(&mut self, room: Lanes<L>, watch: &mut impl Follow<L>) {
        self.states.fill(Lanes::ZERO);
        self.empty_the_line();
        self.signals.fill(Signals::ZERO);
        for spare in &mut self.spare {
            spare.clear(0);
        }
        self.show(room, 0, &[], watch);
        self.advance(room);
        self.quiet = Lanes::all(f64::INFINITY);
    }

    fn advance(&mut self, length: Lanes<L>) {
        for l in 0..L {
            self.now[l] = self.now[l].plus(length.0[l]);
        }
    }

    /// What comes out of the delay next, cut to `room`.
    fn next_piece(&mut self, room: Lanes<L>, tiny: Lanes<L>) -> Option<Piece<L>> {
        let piece = self.line.pop_front()?;
        if agreed::<L>(|l| room.0[l] >= piece.length.0[l] - tiny.0[l])? {
            return Some(piece);
        }
        let rest = piece.length - room;
        if !room.min(rest).every(self.delay, |short, delay| short >= SHORTEST * delay) {
            return None;
        }
        let s = room * 2.0 / piece.length - Lanes::all(1.0);
        let theta = self.plan.rate * room;
        let (first, second): (Vec<Signals<L>>, Vec<Signals<L>>) =
            piece.channels.iter().map(|signal| signal.split(s, theta, piece.terms)).unzip();
        let second_terms = if theta.smallest() > decay(piece.terms) { 0 } else { piece.terms };
        self.line.push_front(Piece { length: rest, terms: second_terms, channels: second });
        Some(Piece { length: room, terms: piece.terms, channels: first })
    }

    /// Computes the segment over which `piece` comes out, shows it, and leaves in `piece` what goes in.
    fn compute(&mut self, piece: &mut Piece<L>, watch: &mut impl Follow<L>) -> Option<()> {
        let (plan, length) = (self.plan, piece.length);
        let layered = plan.rate.0[0] > 0.0;
        let terms = if layered { (piece.terms + 1).min(LAYER_TERMS) } else { 0 };
        for channel in &mut piece.channels {
            channel.layer[piece.terms..terms].fill(Lanes::ZERO);
        }
        solve(plan, (length, &piece.channels), terms, &self.states, &mut self.signals, &mut self.spare);
        self.show(length, terms, &piece.channels, watch);
        let quiet = self.judge(length, terms)?;
        let kept = self.cut(terms)?;
        let theta = plan.rate * length;
        arrive(&self.signals, terms, theta, &mut self.states);
        for l in 0..L {
            self.quiet.0[l] = if quiet[l] { self.quiet.0[l] + length.0[l] } else { 0.0 };
        }
        self.advance(length);
        piece.terms = kept;
        swap(&mut piece.channels, &mut self.spare);
        Some(())
    }

    /// Which loops hardly move; `None` where numbers leave their range or the expansion does not hold.
    fn judge(&mut self, length: Lanes<L>, terms: usize) -> Option<[bool; L]> {
        let amplification = amplification((length * self.plan.rate * 0.5).smallest());
        let mut quiet = [true; L];
        for (signal, scale) in self.signals.iter().chain(&self.spare).zip(&mut self.scales) {
            let (size, tail) = size_and_tail(signal, terms);
            // The general way says where an unstable loop overflows.
            if !size.every(*scale, |size, _| size <= 1e280) {
                return None;
            }
            *scale = scale.max(size);
            for l in 0..L {
                quiet[l] &= size.0[l] <= SETTLED * scale.0[l];
            }
            if !tail.every(*scale, |tail, scale| tail * amplification <= TOLERANCE * scale) {
                return None;
            }
        }
        // What is cut off comes back amplified.
        self.floor = if FLOOR * amplification < 1e-2 * TOLERANCE { FLOOR } else { 0.0 };
        Some(quiet)
    }

    /// Cuts off the coefficients of the inputs that do not count, and returns how many of their layers do; `None` where
    /// too many do, or where they cancel.
    fn cut(&mut self, terms: usize) -> Option<usize> {
        let mut kept = 0;
        let scales = &self.scales[self.plan.states.len()..];
        for ((signal, value), scale) in self.spare.iter_mut().zip(&mut self.values).zip(scales) {
            let (start, end) = signal.smooth_ends();
            let first = if terms > 0 { start + signal.layer[0] } else { start };
            *value = value.max(first.abs()).max(end.abs());
            let layer = signal.sizes(terms).1;
            if !layer.every(*value, |layer, value| layer <= CANCELLATION * value) {
                return None;
            }
            let counts = |c: &Lanes<L>, part: f64| !c.every(*scale, |c, scale| c.abs() <= part * scale);
            let needed = signal.layer[..terms].iter().rposition(|q| counts(q, FLOOR)).map_or(0, |j| j + 1);
            kept = kept.max(needed);
            let order = signal.smooth[1..signal.order].iter().rposition(|c| counts(c, self.floor));
            signal.order = order.map_or(1, |j| j + 2);
        }
        // A full layer has lost the coefficient that this segment would have added.
        (kept < LAYER_TERMS).then_some(kept)
    }

    /// Shows the segment at hand, whose inputs are in `spare`.
    fn show(&mut self, length: Lanes<L>, terms: usize, delayed: &[Signals<L>], watch: &mut impl Follow<L>) {
        let (plan, system) = (self.plan, self.systems[0]);
        let rest = |of: fn(&Rest) -> f64| Lanes(self.rests.each_ref().map(of));
        self.error.clear(terms);
        self.error.add(Lanes::all(-1.0), &self.signals[system.output], terms);
        self.error.smooth[0] += rest(|rest| rest.error);
        if system.input_is_manipulated {
            self.manipulated.clear(terms);
            self.manipulated.add(Lanes::all(1.0), &self.spare[0], terms);
        } else {
            weighted(&mut self.manipulated, &plan.manipulated, &self.signals, delayed, terms);
        }
        self.manipulated.smooth[0] += rest(|rest| rest.manipulated);
        if let Some(row) = &plan.load_estimate {
            weighted(&mut self.load_estimate, row, &self.signals, delayed, terms);
            self.load_estimate.smooth[0] += rest(|rest| rest.load_estimate);
        }
        watch.stretch(&Stretch {
            start: Lanes(self.now.map(Instant::seconds)),
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
