//! From segment to segment: what comes out of the delay, the states it drives, what goes in again.
//!
//! Several loops go together, one in each lane, as long as the same things happen to them in the same order: their
//! segments then differ in length only.

use std::collections::VecDeque;
use std::mem::{replace, swap};

use super::super::cell::Outcome;
use super::super::error::ResponseError;
use super::super::instant::Instant;
use super::super::legendre::TERMS;
use super::super::scenario::Scenario;
use super::super::solver::{CELL_BUDGET, SETTLED, merged_events};
use super::super::system::{Rest, System};
use super::lanes::{Lanes, MOST, Set, agreed};
use super::plan::Plan;
use super::signal::LAYER_TERMS;
use super::signals::{End, Signals, Sizes};
use super::states::{combine, solve};
use super::tables::INVERSE;

/// The last two coefficients of a smooth part may change a signal by this part of its largest value so far.
const TOLERANCE: f64 = 2e-14;
/// Coefficients below this part of the largest value so far are not carried on.
const FLOOR: f64 = 1e-16;
/// A layer's coefficients may be larger than the signal by this factor: then cancellation has cost three digits of 16.
const CANCELLATION: f64 = 1e3;
/// Shortest segment, as a part of the delay: below, powers of the ratio of lengths leave the range of numbers.
const SHORTEST: f64 = 1e-9;

/// What happens to each loop from one breakpoint to the next.
pub(super) struct Stretch<'a, V: Lanes> {
    /// Start [s].
    pub(super) start: V,
    /// Length [s].
    pub(super) length: V,
    /// Setpoint, relative to the initial level.
    pub(super) setpoint: f64,
    /// Rate of the fast pole [1/s].
    pub(super) rate: V,
    /// Coefficients of the layers.
    pub(super) terms: usize,
    /// Where it ends on the layers' axis.
    pub(super) end: &'a End<V>,
    /// Controlled variable less setpoint: the control error with its sign turned.
    pub(super) deviation: &'a Signals<V>,
    pub(super) deviation_sizes: Sizes<V>,
    /// Controller output.
    pub(super) manipulated: &'a Signals<V>,
    pub(super) manipulated_sizes: Sizes<V>,
    /// Load estimate of the observer.
    pub(super) load_estimate: Option<&'a Signals<V>>,
}

/// Receives the response of several loops as it is computed.
pub(super) trait Follow<V: Lanes> {
    /// The next stretch, in order.
    fn stretch(&mut self, stretch: &Stretch<'_, V>);
}

/// What is under way in the delay, from breakpoint to breakpoint.
struct Piece<V: Lanes> {
    length: V,
    /// Coefficients of the layers.
    terms: usize,
    channels: Vec<Signals<V>>,
}

/// Some loops on their way through one scenario.
pub(super) struct Propagation<'a, V: Lanes> {
    system: &'a System<V>,
    plan: &'a Plan<V>,
    delay: V,
    /// States, deviations from the point of rest; of a fast state its difference from what it follows. Within a segment their
    /// smooth parts at its end.
    states: Vec<V>,
    line: VecDeque<Piece<V>>,
    /// Storage for what goes in next.
    spare: Vec<Signals<V>>,
    now: [Instant; MOST],
    setpoint: f64,
    load: f64,
    rest: Rest<V>,
    /// Largest bounds on states and inputs so far.
    scales: Vec<V>,
    /// Largest values of the inputs at ends of segments so far.
    values: Vec<V>,
    quiet: V,
    /// Smooth coefficients below this part of the largest value so far are not carried on.
    floor: f64,
    /// Signals of the segment at hand: the states.
    signals: Vec<Signals<V>>,
    /// Bounds on states, inputs and, where it is not an input, `manipulated` over the segment at hand.
    sizes: Vec<Sizes<V>>,
    end: End<V>,
    /// Storage.
    drive: Signals<V>,
    manipulated: Signals<V>,
    load_estimate: Signals<V>,
}

impl<'a, V: Lanes> Propagation<'a, V> {
    #[inline(always)]
    pub(super) fn new(system: &'a System<V>, plan: &'a Plan<V>) -> Self {
        let (token, n) = (plan.rate.token(), plan.states.len());
        let zero = V::zero(token);
        let inputs = plan.inputs.len();
        let mut new = Self {
            system,
            plan,
            delay: system.delays[0],
            states: vec![zero; n],
            line: VecDeque::new(),
            spare: vec![Signals::zero(token); inputs],
            now: [Instant::new(0.0); MOST],
            setpoint: 0.0,
            load: 0.0,
            rest: system.rest(0.0, 0.0),
            scales: vec![zero; n + inputs],
            values: vec![zero; inputs],
            quiet: zero.like(f64::INFINITY),
            floor: 0.0,
            signals: vec![Signals::zero(token); n],
            sizes: vec![Sizes { swing: zero, layer: zero }; n + inputs + 1],
            end: End::new(token),
            drive: Signals::zero(token),
            manipulated: Signals::zero(token),
            load_estimate: Signals::zero(token),
        };
        new.empty_the_line();
        new
    }

    #[inline(always)]
    fn empty_the_line(&mut self) {
        self.line.clear();
        let length = self.delay / self.delay.like(f64::from(self.plan.pieces));
        for _ in 0..self.plan.pieces {
            let channels = vec![Signals::zero(length.token()); self.plan.inputs.len()];
            self.line.push_back(Piece { length, terms: 0, channels });
        }
    }

    /// Runs the scenario; `None` where the expansion does not hold to rounding, or the loops part ways.
    #[inline(always)]
    pub(super) fn run(
        mut self,
        scenario: &Scenario,
        watch: &mut impl Follow<V>,
    ) -> Option<Result<Outcome, ResponseError>> {
        let events = merged_events(scenario);
        let mut next_event = 0;
        let horizon = scenario.horizon();
        let mut segments = 0;
        loop {
            let now = self.now;
            let mut tiny = self.delay;
            for l in 0..V::COUNT {
                tiny[l] = 4.0 * f64::EPSILON * now[l].seconds().max(self.delay[l]);
            }
            let reached = |time: f64| agreed(V::COUNT, |l| now[l].until(time) <= tiny[l]);
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
            let room = V::from_fn(tiny.token(), |l| now[l].until(until));
            if self.delay.below(self.quiet) == V::every() {
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
    #[inline(always)]
    fn event(&mut self, setpoint: f64, load: f64) {
        self.setpoint += setpoint;
        self.load += load;
        let before = replace(&mut self.rest, self.system.rest(self.setpoint, self.load));
        let jump = self.system.rest(setpoint, load).states;
        for (i, state) in self.plan.states.iter().enumerate() {
            let mut followed = self.delay.like(0.0);
            for &(j, weight) in &state.follows {
                followed += weight * jump[j];
            }
            self.states[i] = self.states[i] - (jump[i] - followed);
        }
        for c in 0..self.plan.inputs.len() {
            let shift = before.delayed[c] - self.rest.delayed[c];
            for piece in &mut self.line {
                piece.channels[c].smooth[0] += shift;
            }
        }
        self.quiet = self.delay.like(0.0);
    }

    /// Nothing moves until the next event: one segment of constants.
    #[inline(always)]
    fn stand_still(&mut self, room: V, watch: &mut impl Follow<V>) {
        let zero = room.like(0.0);
        self.states.fill(zero);
        self.empty_the_line();
        for signal in &mut self.signals {
            signal.clear(0);
        }
        for spare in &mut self.spare {
            spare.clear(0);
        }
        self.end.move_to(room, 0);
        self.watched(0, &[]);
        self.show(room, 0, watch);
        self.advance(room);
        self.quiet = zero.like(f64::INFINITY);
    }

    #[inline(always)]
    fn advance(&mut self, length: V) {
        for l in 0..V::COUNT {
            self.now[l] = self.now[l].plus(length[l]);
        }
    }

    /// What comes out of the delay next, cut to `room`.
    #[inline(always)]
    fn next_piece(&mut self, room: V, tiny: V) -> Option<Piece<V>> {
        let mut piece = self.line.pop_front()?;
        if agreed(V::COUNT, |l| room[l] >= piece.length[l] - tiny[l])? {
            return Some(piece);
        }
        let rest = piece.length - room;
        if !(self.delay * SHORTEST).all_at_most(room.min(rest)) {
            return None;
        }
        let s = room * 2.0 / piece.length - room.like(1.0);
        let theta = self.plan.rate * room;
        self.end.move_to(theta, piece.terms);
        let mut channels = Vec::with_capacity(piece.channels.len());
        for signal in &mut piece.channels {
            channels.push(signal.split(s, &self.end, piece.terms));
        }
        let terms = if self.end.decayed { 0 } else { piece.terms };
        self.line.push_front(Piece { length: rest, terms, channels });
        piece.length = room;
        Some(piece)
    }

    /// Computes the segment over which `piece` comes out, shows it, and leaves in `piece` what goes in.
    #[inline(always)]
    fn compute(&mut self, piece: &mut Piece<V>, watch: &mut impl Follow<V>) -> Option<()> {
        let length = piece.length;
        let layered = self.plan.rate[0] > 0.0;
        let terms = if layered { (piece.terms + 1).min(LAYER_TERMS) } else { 0 };
        V::widest(
            length.token(),
            #[inline(always)]
            || self.solve(piece, terms),
        );
        self.show(length, terms, watch);
        piece.terms = V::widest(
            length.token(),
            #[inline(always)]
            || self.settle(length, terms),
        )?;
        swap(&mut piece.channels, &mut self.spare);
        Some(())
    }

    /// All signals over the segment.
    #[inline(always)]
    fn solve(&mut self, piece: &mut Piece<V>, terms: usize) {
        let (plan, length) = (self.plan, piece.length);
        for channel in &mut piece.channels {
            channel.layer[piece.terms..terms].fill(length.like(0.0));
        }
        let delayed = &piece.channels;
        solve(plan, (length, delayed), terms, &mut self.states, &mut self.signals, &mut self.drive);
        for (input, row) in self.spare.iter_mut().zip(&plan.inputs) {
            combine(input, row, &self.signals, delayed, terms);
        }
        self.end.move_to(plan.rate * length, terms);
        self.watched(terms, delayed);
    }

    /// What else is shown of the segment over which `delayed` comes out and whose inputs are in `spare`, and how large all is.
    #[inline(always)]
    fn watched(&mut self, terms: usize, delayed: &[Signals<V>]) {
        let (plan, system) = (self.plan, self.system);
        if !system.input_is_manipulated {
            combine(&mut self.manipulated, &plan.manipulated, &self.signals, delayed, terms);
        }
        if let Some(row) = &plan.load_estimate {
            combine(&mut self.load_estimate, row, &self.signals, delayed, terms);
        }
        let signals = self.signals.iter_mut().chain(&mut self.spare);
        let own = (!system.input_is_manipulated).then_some(&mut self.manipulated);
        for (sizes, signal) in self.sizes.iter_mut().zip(signals.chain(own)) {
            signal.fill(terms);
            *sizes = signal.sizes(terms);
        }
    }

    /// Goes to the end of the segment, and returns how many coefficients of the inputs' layers count; `None` where the expansion
    /// does not hold.
    #[inline(always)]
    fn settle(&mut self, length: V, terms: usize) -> Option<usize> {
        let quiet = self.judge(length)?;
        let kept = self.cut(terms)?;
        let zero = length.like(0.0);
        for (state, signal) in self.states.iter_mut().zip(&self.signals) {
            *state += self.end.value(&signal.layer[..terms], zero);
        }
        self.quiet = (self.quiet + length).only_in(quiet, zero);
        self.advance(length);
        Some(kept)
    }

    /// Which loops hardly move; `None` where numbers leave their range or the expansion does not hold.
    #[inline(always)]
    fn judge(&mut self, length: V) -> Option<Set> {
        let amplification = amplification((length * self.plan.rate * 0.5).smallest());
        let mut quiet = V::every();
        let signals = self.signals.iter().chain(&self.spare);
        for ((signal, sizes), scale) in signals.zip(&self.sizes).zip(&mut self.scales) {
            let size = signal.smooth[0].abs() + sizes.swing + sizes.layer;
            let mut tail = size.like(0.0);
            for c in signal.smooth[..signal.order].iter().skip(TERMS - 2) {
                tail += c.abs();
            }
            // The general way says where an unstable loop overflows.
            if !size.all_at_most(size.like(1e280)) {
                return None;
            }
            *scale = scale.max(size);
            quiet = quiet & size.at_most(*scale * SETTLED);
            if !(tail * amplification).all_at_most(*scale * TOLERANCE) {
                return None;
            }
        }
        // What is cut off comes back amplified.
        self.floor = if FLOOR * amplification < 1e-2 * TOLERANCE { FLOOR } else { 0.0 };
        Some(quiet)
    }

    /// Cuts off the coefficients of the inputs that do not count, and returns how many of their layers do; `None` where
    /// too many do, or where they cancel.
    #[inline(always)]
    fn cut(&mut self, terms: usize) -> Option<usize> {
        let mut kept = 0;
        let states = self.plan.states.len();
        let known = self.scales[states..].iter().zip(&self.sizes[states..]);
        for ((signal, value), (scale, sizes)) in self.spare.iter_mut().zip(&mut self.values).zip(known) {
            let (start, end) = signal.smooth_ends();
            let first = if terms > 0 { start + signal.layer[0] } else { start };
            *value = value.max(first.abs()).max(end.abs());
            if !sizes.layer.all_at_most(*value * CANCELLATION) {
                return None;
            }
            let counts = |c: &V, part: f64| !c.abs().all_at_most(*scale * part);
            let needed = signal.layer[..terms].iter().rposition(|q| counts(q, FLOOR)).map_or(0, |j| j + 1);
            kept = kept.max(needed);
            let order = signal.smooth[1..signal.order].iter().rposition(|c| counts(c, self.floor));
            signal.order = order.map_or(1, |j| j + 2);
        }
        // A full layer has lost the coefficient that this segment would have added.
        (kept < LAYER_TERMS).then_some(kept)
    }

    /// Shows the segment at hand.
    #[inline(always)]
    fn show(&mut self, length: V, terms: usize, watch: &mut impl Follow<V>) {
        let (output, states) = (self.system.output, self.plan.states.len());
        let (manipulated, manipulated_sizes) = if self.system.input_is_manipulated {
            (&mut self.spare[0], self.sizes[states])
        } else {
            (&mut self.manipulated, self.sizes[states + self.spare.len()])
        };
        // States and inputs are deviations from rest: what is shown is not, and they go on as they were.
        let (state, input) = (self.signals[output].smooth[0], manipulated.smooth[0]);
        self.signals[output].smooth[0] = state - self.rest.error;
        manipulated.smooth[0] = input + self.rest.manipulated;
        if self.plan.load_estimate.is_some() {
            self.load_estimate.smooth[0] += self.rest.load_estimate;
        }
        watch.stretch(&Stretch {
            start: V::from_fn(length.token(), |l| self.now[l].seconds()),
            length,
            setpoint: self.setpoint,
            rate: self.plan.rate,
            terms,
            end: &self.end,
            deviation: &self.signals[output],
            deviation_sizes: self.sizes[output],
            manipulated,
            manipulated_sizes,
            load_estimate: self.plan.load_estimate.as_ref().map(|_| &self.load_estimate),
        });
        manipulated.smooth[0] = input;
        self.signals[output].smooth[0] = state;
    }
}

/// The largest effect on any coefficient, through the fast lag, of an error of 1 in the last one.
#[inline(always)]
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
