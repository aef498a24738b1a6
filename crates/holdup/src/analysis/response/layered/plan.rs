//! Which loops can be written with one layer, and their equations in the form that loses nothing by cancellation.

use super::super::scenario::Scenario;
use super::super::system::{Row, System, Terms};
use super::lanes::{Lanes, Set, agreed};

/// A pole up to this rate times half a segment is resolved by the polynomials: 2^24/24! is 3e-17.
const SLOW: f64 = 2.0;
/// A pole from this rate times the dead time on is fast enough for a layer of its own; the propagation decides.
const FAST: f64 = 12.0;
/// Most segments from breakpoint to breakpoint: with more of them the Legendre cells are as good.
const MOST_PIECES: f64 = 4.0;

/// How a state moves by itself.
#[derive(Clone, Copy)]
pub(super) enum Motion<V> {
    /// An integrator.
    Integral,
    /// A lag of this rate (negative) [1/s] that polynomials resolve.
    Slow(V),
    /// The fast lag.
    Fast,
}

/// A weighted sum of states and of what comes out of the delays.
pub(super) struct Weights<V> {
    pub(super) states: Terms<V>,
    pub(super) delayed: Terms<V>,
}

/// One state: how it moves, and what drives it.
pub(super) struct State<V> {
    pub(super) motion: Motion<V>,
    pub(super) drive: Weights<V>,
    /// What a fast state would equal were it infinitely fast. The propagation carries the difference from that: of a state
    /// that only follows another almost all digits would cancel.
    pub(super) follows: Terms<V>,
}

/// Loops that can be written with one layer.
pub(super) struct Plan<V> {
    pub(super) states: Vec<State<V>>,
    /// Inputs of the channels, which all have the same delay.
    pub(super) inputs: Vec<Weights<V>>,
    pub(super) manipulated: Weights<V>,
    pub(super) load_estimate: Option<Weights<V>>,
    /// Rate of the fast pole [1/s], or 0 if there is none.
    pub(super) rate: V,
    /// Segments from breakpoint to breakpoint.
    pub(super) pieces: u32,
}

impl<V: Lanes> Plan<V> {
    /// `None` where a loop has several delays, coupled states, no point of rest, or several fast poles, where the scenario makes
    /// an impulse, or where the loops differ in kind.
    #[inline(always)]
    pub(super) fn new(system: &System<V>, scenario: &Scenario) -> Option<Self> {
        let delay = system.delays[0];
        let zero = delay.like(0.0);
        let single = system.delays.iter().all(|d| equal(*d, delay) == V::every());
        let plain = system.blocks.iter().all(|(from, to)| to - from == 1);
        let impulse =
            system.rates.iter().chain(&system.inputs).any(|row| !row.setpoint_rate.abs().all_at_most(zero));
        if !(single && plain && system.has_rest) || impulse && !scenario.setpoint_moves().is_empty() {
            return None;
        }
        // How each state drives itself.
        let own = |i: usize| {
            let row = system.rates[i].states.iter().find(|(j, _)| *j == i);
            row.map_or(zero, |(_, weight)| *weight)
        };
        let mut fastest = zero;
        for i in 0..system.rates.len() {
            if !own(i).all_at_most(zero) {
                return None;
            }
            fastest = fastest.max(-own(i));
        }
        let rate = if agreed(V::COUNT, |l| fastest[l] * delay[l] >= FAST)? { fastest } else { zero };
        let mut resolved = zero;
        let mut states: Vec<State<V>> = Vec::with_capacity(system.rates.len());
        let mut fast = 0;
        for (i, row) in system.rates.iter().enumerate() {
            let own = own(i);
            let is_fast = rate[0] > 0.0 && all_or_none::<V>(equal(own, -rate))?;
            let motion = if is_fast {
                fast += 1;
                Motion::Fast
            } else if all_or_none::<V>(equal(own, zero))? {
                Motion::Integral
            } else {
                resolved = resolved.max(-own);
                Motion::Slow(own)
            };
            let mut drive = substituted(row, &states);
            drive.states.retain(|(j, _)| *j != i);
            let mut follows = Terms::new();
            if is_fast {
                for &(j, weight) in &drive.states {
                    follows.push((j, weight / rate));
                }
                let mut difference = Weights { states: Terms::new(), delayed: drive.delayed };
                for &(j, weight) in &follows {
                    let moves: &State<V> = &states[j];
                    accumulate(&mut difference.states, &moves.drive.states, -weight);
                    accumulate(&mut difference.delayed, &moves.drive.delayed, -weight);
                    if let Motion::Slow(own) = moves.motion {
                        accumulate(&mut difference.states, &[(j, own)], -weight);
                    }
                }
                drive = difference;
            }
            states.push(State { motion, drive, follows });
        }
        if fast > 1 {
            return None;
        }
        let pieces = |l: usize| (resolved[l] * delay[l] / (2.0 * SLOW)).ceil().max(1.0);
        if pieces(0) > MOST_PIECES || !(0..V::COUNT).all(|l| pieces(l) == pieces(0)) {
            return None;
        }
        let mut inputs = Vec::with_capacity(system.inputs.len());
        for row in &system.inputs {
            inputs.push(substituted(row, &states));
        }
        let manipulated = substituted(&system.manipulated, &states);
        let load_estimate = match &system.load_estimate {
            Some(row) => Some(substituted(row, &states)),
            None => None,
        };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to 4")]
        let pieces = pieces(0) as u32;
        Some(Self { states, inputs, manipulated, load_estimate, rate, pieces })
    }
}

/// Where two numbers are the same.
#[inline(always)]
fn equal<V: Lanes>(a: V, b: V) -> Set {
    a.at_most(b) & !a.below(b)
}

/// Whether these are all loops; `None` where they are some.
#[inline(always)]
fn all_or_none<V: Lanes>(loops: Set) -> Option<bool> {
    let all = loops == V::every();
    (all || loops & V::every() == Set::NONE).then_some(all)
}

/// A row in terms of the differences that stand for the fast states.
#[inline(always)]
fn substituted<V: Lanes>(row: &Row<V>, states: &[State<V>]) -> Weights<V> {
    let one = row.setpoint.like(1.0);
    let mut new = Weights { states: Terms::new(), delayed: Terms::new() };
    accumulate(&mut new.delayed, &row.delayed, one);
    for &(i, weight) in &row.states {
        accumulate(&mut new.states, &[(i, weight)], one);
        if let Some(state) = states.get(i) {
            accumulate(&mut new.states, &state.follows, weight);
        }
    }
    new
}

#[inline(always)]
fn accumulate<V: Lanes>(sum: &mut Terms<V>, terms: &[(usize, V)], factor: V) {
    for &(index, weight) in terms {
        match sum.iter_mut().find(|(i, _)| *i == index) {
            Some((_, sum)) => *sum = factor.times_plus(weight, *sum),
            None => sum.push((index, factor * weight)),
        }
    }
}
