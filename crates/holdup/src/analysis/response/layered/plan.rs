//! Which loops can be written with one layer, and their equations in the form that loses nothing by cancellation.

use super::super::scenario::Scenario;
use super::super::system::{Row, System, Terms};

/// A pole up to this rate times half a segment is resolved by the polynomials: 2^24/24! is 3e-17.
const SLOW: f64 = 2.0;
/// A pole from this rate times the dead time on is fast enough for a layer of its own; the propagation decides.
const FAST: f64 = 12.0;
/// Most segments from breakpoint to breakpoint: with more of them the Legendre cells are as good.
const MOST_PIECES: f64 = 4.0;

/// How a state moves by itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// An integrator.
    Integral,
    /// A lag of this rate (negative) [1/s] that polynomials resolve.
    Slow(f64),
    /// The fast lag.
    Fast,
}

/// One state: its kind and what drives it.
#[derive(Debug, Clone)]
pub(super) struct State {
    pub(super) kind: Kind,
    pub(super) drive: Row,
    /// What a fast state would equal were it infinitely fast. The propagation carries the difference from that: of a state
    /// that only follows another almost all digits would cancel.
    pub(super) follows: Terms,
}

/// A loop that can be written with one layer.
#[derive(Debug, Clone)]
pub(super) struct Plan {
    pub(super) states: Vec<State>,
    /// Inputs of the channels, which all have the same delay.
    pub(super) inputs: Vec<Row>,
    pub(super) manipulated: Row,
    pub(super) load_estimate: Option<Row>,
    /// Rate of the fast pole [1/s], or 0 if there is none.
    pub(super) rate: f64,
    /// Segments from breakpoint to breakpoint.
    pub(super) pieces: u32,
}

impl Plan {
    /// `None` where the loop has several delays, coupled states, no point of rest, or several fast poles, or where the
    /// scenario makes an impulse.
    pub(super) fn new(system: &System, scenario: &Scenario) -> Option<Self> {
        let delay = system.delays[0];
        let single = system.delays.iter().all(|&d| d == delay);
        let plain = system.blocks.iter().all(|(from, to)| to - from == 1);
        let impulse = system.rates.iter().chain(&system.inputs).any(|row| row.setpoint_rate != 0.0);
        if !(single && plain && system.has_rest) || impulse && !scenario.setpoint_moves().is_empty() {
            return None;
        }
        let own: Vec<f64> = (0..system.rates.len()).map(|i| system.own_rate(i)).collect();
        if own.iter().any(|&rate| rate > 0.0) {
            return None;
        }
        let fastest = own.iter().fold(0.0f64, |m, rate| m.max(-rate));
        let rate = if fastest * delay >= FAST { fastest } else { 0.0 };
        let is_fast = |own: f64| rate > 0.0 && own == -rate;
        if own.iter().filter(|o| is_fast(**o)).count() > 1 {
            return None;
        }
        let resolved = own.iter().filter(|o| !is_fast(**o)).fold(0.0f64, |m, o| m.max(-o));
        let pieces = (resolved * delay / (2.0 * SLOW)).ceil().max(1.0);
        if pieces > MOST_PIECES {
            return None;
        }
        let mut states: Vec<State> = Vec::with_capacity(own.len());
        for (i, row) in system.rates.iter().enumerate() {
            let mut drive = substituted(row, &states);
            drive.states.retain(|(j, _)| *j != i);
            let kind = match own[i] {
                0.0 => Kind::Integral,
                own if is_fast(own) => Kind::Fast,
                own => Kind::Slow(own),
            };
            let mut follows = Terms::new();
            if kind == Kind::Fast && drive.states.iter().all(|&(j, _)| states[j].kind != Kind::Fast) {
                follows = drive.states.iter().map(|&(j, weight)| (j, weight / rate)).collect();
                let mut difference = Row { delayed: drive.delayed.clone(), ..Row::default() };
                for &(j, weight) in &follows {
                    let moves = &states[j];
                    accumulate(&mut difference.states, &moves.drive.states, -weight);
                    accumulate(&mut difference.delayed, &moves.drive.delayed, -weight);
                    if let Kind::Slow(own) = moves.kind {
                        accumulate(&mut difference.states, &[(j, own)], -weight);
                    }
                }
                drive = difference;
            }
            states.push(State { kind, drive, follows });
        }
        let inputs = system.inputs.iter().map(|row| substituted(row, &states)).collect();
        let manipulated = substituted(&system.manipulated, &states);
        let load_estimate = system.load_estimate.as_ref().map(|row| substituted(row, &states));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to 4")]
        let pieces = pieces as u32;
        Some(Self { states, inputs, manipulated, load_estimate, rate, pieces })
    }
}

/// A row in terms of the differences that stand for the fast states.
fn substituted(row: &Row, states: &[State]) -> Row {
    let mut new = Row { delayed: row.delayed.clone(), ..Row::default() };
    for &(i, weight) in &row.states {
        accumulate(&mut new.states, &[(i, weight)], 1.0);
        if let Some(state) = states.get(i) {
            accumulate(&mut new.states, &state.follows, weight);
        }
    }
    new
}

fn accumulate(sum: &mut Terms, terms: &[(usize, f64)], factor: f64) {
    for &(index, weight) in terms {
        match sum.iter_mut().find(|(i, _)| *i == index) {
            Some((_, w)) => *w += factor * weight,
            None => sum.push((index, factor * weight)),
        }
    }
}
