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
use super::lanes::{Lanes, agreed, lane_by_lane};
use super::signal::{LAYER_TERMS, decay};
use super::signals::Signals;
use super::tables::INVERSE;
use super::together::{Motion, Together, Weights};

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

/// A bound on the magnitude of a signal, and the magnitude of the last two smooth coefficients that there can be.
#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
fn size_and_tail<const L: usize>(signal: &Signals<L>, terms: usize) -> (Lanes<L>, Lanes<L>) {
    let (smooth, layer) = signal.sizes(terms);
    let mut tail = Lanes::ZERO;
    for c in signal.smooth[..signal.order].iter().skip(TERMS - 2) {
        tail += c.abs();
    }
    (smooth + layer, tail)
}

/// The states at the end of the segment.
#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
fn arrive<const L: usize>(signals: &[Signals<L>], terms: usize, theta: Lanes<L>, states: &mut [Lanes<L>]) {
    for (state, signal) in states.iter_mut().zip(signals) {
        *state = signal.smooth_ends().1 + layer_at(&signal.layer[..terms], theta);
    }
}

/// Value of a layer at `theta`.
#[inline(always)]
fn layer_at<const L: usize>(layer: &[Lanes<L>], theta: Lanes<L>) -> Lanes<L> {
    let over = decay(layer.len());
    if theta.smallest() > over {
        return Lanes::ZERO;
    }
    let mut sum = Lanes::ZERO;
    for (j, q) in layer.iter().enumerate().rev() {
        lane_by_lane::<L>();
        sum = sum * theta * INVERSE[j + 1] + *q;
    }
    sum.with(theta, |sum, theta| if theta > over { 0.0 } else { sum * (-theta).exp() })
}

/// The weighted sum, in vectors.
#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
fn weighted<const L: usize>(
    sum: &mut Signals<L>,
    row: &Weights<L>,
    states: &[Signals<L>],
    delayed: &[Signals<L>],
    terms: usize,
) {
    combine(sum, row, states, delayed, terms);
}

#[inline(always)]
fn combine<const L: usize>(
    sum: &mut Signals<L>,
    row: &Weights<L>,
    states: &[Signals<L>],
    delayed: &[Signals<L>],
    terms: usize,
) {
    sum.clear(terms);
    for &(i, weight) in &row.states {
        sum.add(weight, &states[i], terms);
    }
    for &(c, weight) in row.delayed.iter().filter(|(c, _)| *c < delayed.len()) {
        sum.add(weight, &delayed[c], terms);
    }
}

/// All states over the segment of this length in which `delayed` comes out, and what goes in.
#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
fn solve<const L: usize>(
    plan: &Together<L>,
    (length, delayed): (Lanes<L>, &[Signals<L>]),
    terms: usize,
    start: &[Lanes<L>],
    signals: &mut [Signals<L>],
    inputs: &mut [Signals<L>],
) {
    let half = length * 0.5;
    let step = Lanes::all(1.0) / plan.rate;
    let mut drive = Signals::ZERO;
    for (i, state) in plan.states.iter().enumerate() {
        combine(&mut drive, &state.drive, signals, delayed, terms);
        let x = &mut signals[i];
        let order = drive.order;
        match state.motion {
            Motion::Integral => {
                x.order = (order + 1).min(TERMS);
                for j in 0..x.order - 1 {
                    lane_by_lane::<L>();
                    x.smooth[j + 1] = half * INVERSE[j + 1] * drive.smooth[j];
                }
                x.smooth[0] = Lanes::ZERO;
                if terms > 0 {
                    sum_backwards(x, &drive, step, Lanes::all(1.0), terms);
                }
                x.smooth[0] = start[i] - first(x, terms) - x.smooth_ends().0;
            }
            Motion::Slow(own) => {
                x.order = TERMS;
                drive.smooth[order..].fill(Lanes::ZERO);
                let (mut particular, mut homogeneous) = (Lanes::ZERO, Lanes::all(1.0));
                let mut all = Signals::ZERO;
                all.order = TERMS;
                x.smooth[0] = Lanes::ZERO;
                all.smooth[0] = Lanes::all(1.0);
                for j in 0..TERMS - 1 {
                    lane_by_lane::<L>();
                    particular = half * INVERSE[j + 1] * (own * particular + drive.smooth[j]);
                    homogeneous = homogeneous * (half * own * INVERSE[j + 1]);
                    x.smooth[j + 1] = particular;
                    all.smooth[j + 1] = homogeneous;
                }
                if terms > 0 {
                    let damping = Lanes::all(1.0) / (Lanes::all(1.0) + own * step);
                    sum_backwards(x, &drive, step, damping, terms);
                }
                let missing = start[i] - first(x, terms) - x.smooth_ends().0;
                let reach = missing / all.smooth_ends().0;
                x.add(reach, &all, 0);
            }
            Motion::Fast => {
                x.order = order;
                let inverse_half = step / half;
                let mut above = Lanes::ZERO;
                #[expect(clippy::cast_precision_loss, reason = "at most 24")]
                let mut index = order as f64;
                for j in (0..order).rev() {
                    lane_by_lane::<L>();
                    above = drive.smooth[j] * step - inverse_half * index * above;
                    index -= 1.0;
                    x.smooth[j] = above;
                }
                for j in 1..terms {
                    lane_by_lane::<L>();
                    x.layer[j] = drive.layer[j - 1] * step;
                }
                x.layer[0] = start[i] - x.smooth_ends().0;
            }
        }
    }
    for (input, row) in inputs.iter_mut().zip(&plan.inputs) {
        combine(input, row, signals, delayed, terms);
    }
}

/// The first coefficient of the layer, if there is one.
#[inline(always)]
fn first<const L: usize>(x: &Signals<L>, terms: usize) -> Lanes<L> {
    if terms > 0 { x.layer[0] } else { Lanes::ZERO }
}

/// The layer of an integrator or a slow lag: `q_j = damping·(q_(j+1) − step·drive_j)`.
#[inline(always)]
fn sum_backwards<const L: usize>(
    x: &mut Signals<L>,
    drive: &Signals<L>,
    step: Lanes<L>,
    damping: Lanes<L>,
    terms: usize,
) {
    let mut above = Lanes::ZERO;
    for j in (0..terms).rev() {
        lane_by_lane::<L>();
        above = damping * (above - step * drive.layer[j]);
        x.layer[j] = above;
    }
}
