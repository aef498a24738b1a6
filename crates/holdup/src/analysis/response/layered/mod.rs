//! The fast way through a scenario: every signal as a polynomial plus a layer, one segment from breakpoint to breakpoint.
//!
//! Right after a breakpoint a loop with one fast pole −N (the derivative filter) has a layer of width 1/N, and nothing else
//! happens at that speed. So every signal is written as
//!
//! ```text
//! P(s) + e^(−θ)·Q(θ),   s = −1 … 1 over the segment,   θ = N·(time since the start of the segment)
//! ```
//!
//! with P in powers of s and Q in the basis θ^j/j!. Both are closed under what a loop does: an integrator shifts the index of
//! P and sums Q backwards; the fast lag is a backward recurrence in P and an index shift in Q; a delay only renames the
//! segment. A layer that goes through the loop once more gains one degree in Q and a factor K·Kc·Td.
//!
//! This is an expansion of the smooth part in ω/N. It is used only where its last terms are at rounding level; everywhere
//! else, and for loops of another structure, [`run`] returns `None` and the Legendre cells of `solver.rs` do the work.

#![expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the instruction set chosen at run time"
)]

mod alone;
mod areas;
mod crossings;
mod extrema;
mod gathered;
mod integrals;
mod lanes;
mod measure;
mod plan;
mod propagate;
mod segment;
mod signal;
mod signals;
mod squares;
mod states;
mod tables;

pub(super) use gathered::Gathered;
pub(super) use lanes::{MOST, exponential};
pub(super) use segment::Segment;
pub(super) use signal::{LAYER_TERMS, Layer, Signal};
pub(super) use tables::INVERSE;

use fearless_simd::{Level, Simd as _, dispatch, f64x8};

use super::cell::{Outcome, Watch};
use super::error::ResponseError;
use super::scenario::Scenario;
use super::system::{System, are_alike};
use crate::model::ClosedLoop;
use alone::Alone;
use gathered::OfOne;
use integrals::Integrals;
use lanes::{Lanes, One};
use plan::Plan;
use propagate::{Follow, Propagation};

#[cfg(test)]
mod tests;

/// Runs the scenario and shows every segment to `watch`; `None` where the loop is of another structure or the
/// expansion does not hold to rounding, and then what `watch` was shown is worth nothing.
pub(super) fn run(
    closed_loop: &ClosedLoop,
    scenario: &Scenario,
    watch: &mut dyn Watch,
) -> Option<Result<Outcome, ResponseError>> {
    dispatch!(Level::new(), simd => simd.vectorize(
        #[inline(always)]
        || run_together::<One<_>>(simd, std::slice::from_ref(closed_loop), scenario, &mut Alone::new(watch))
    ))
}

/// IAE, ISE, ITAE and control energy of a loop; `None` as for [`run`].
pub(super) fn integrals(closed_loop: &ClosedLoop, scenario: &Scenario) -> Option<[f64; 4]> {
    dispatch!(Level::new(), simd => simd.vectorize(
        #[inline(always)]
        || {
            let mut integrals = OfOne::<f64x8<_>>::new(simd);
            run_together::<One<_>>(simd, std::slice::from_ref(closed_loop), scenario, &mut integrals)?.ok()?;
            Some(integrals.finish())
        }
    ))
}

/// The same of up to [`MOST`] loops, to which the same happens in the same order; `None` as for [`run`] for any of them, or where
/// they part ways.
pub(super) fn integrals_together(loops: &[ClosedLoop], scenario: &Scenario) -> Option<Vec<[f64; 4]>> {
    dispatch!(Level::new(), simd => simd.vectorize(
        #[inline(always)]
        || integrals_of::<f64x8<_>>(simd, loops, scenario)
    ))
}

#[inline(always)]
fn integrals_of<V: Lanes>(
    token: V::Token,
    loops: &[ClosedLoop],
    scenario: &Scenario,
) -> Option<Vec<[f64; 4]>> {
    let mut integrals = Integrals::<V>::new(token);
    run_together(token, loops, scenario, &mut integrals)?.ok()?;
    Some(integrals.finish(loops.len()))
}

/// Runs the scenario with several loops, the last of them in all lanes that are left; `None` as for [`run`] for any of them, or
/// where they part ways.
#[inline(always)]
fn run_together<V: Lanes>(
    token: V::Token,
    loops: &[ClosedLoop],
    scenario: &Scenario,
    watch: &mut impl Follow<V>,
) -> Option<Result<Outcome, ResponseError>> {
    if loops.is_empty() || !are_alike(loops) {
        return None;
    }
    let system = System::<V>::of(
        token,
        #[inline(always)]
        |l| &loops[l.min(loops.len() - 1)],
    );
    let plan = Plan::new(&system, scenario)?;
    Propagation::new(&system, &plan).run(scenario, watch)
}
