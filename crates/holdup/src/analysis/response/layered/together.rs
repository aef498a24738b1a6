//! The plans of several loops of one structure, as one.

use super::super::system::Row;
use super::lanes::Lanes;
use super::plan::{Kind, Plan};

/// A weighted sum of states and of what comes out of the delays, with weights for each of the loops.
pub(super) struct Weights<V> {
    pub(super) states: Vec<(usize, V)>,
    pub(super) delayed: Vec<(usize, V)>,
}

/// How a state moves by itself; see [`Kind`].
#[derive(Clone, Copy)]
pub(super) enum Motion<V> {
    Integral,
    Slow(V),
    Fast,
}

/// One state of each loop; see [`State`](super::plan::State).
pub(super) struct Coordinate<V> {
    pub(super) motion: Motion<V>,
    pub(super) drive: Weights<V>,
    pub(super) follows: Vec<(usize, V)>,
}

/// [`Plan`] of some loops.
pub(super) struct Together<V> {
    pub(super) states: Vec<Coordinate<V>>,
    pub(super) inputs: Vec<Weights<V>>,
    pub(super) manipulated: Weights<V>,
    pub(super) load_estimate: Option<Weights<V>>,
    pub(super) rate: V,
    pub(super) pieces: u32,
}

impl<V: Lanes> Together<V> {
    /// `None` where the loops differ in structure.
    #[inline(always)]
    pub(super) fn new(token: V::Token, plans: &[Plan]) -> Option<Self> {
        let first = &plans[0];
        let alike = plans.iter().all(|plan| {
            plan.pieces == first.pieces
                && (plan.rate > 0.0) == (first.rate > 0.0)
                && plan.states.len() == first.states.len()
                && plan.inputs.len() == first.inputs.len()
                && plan.load_estimate.is_some() == first.load_estimate.is_some()
        });
        if !alike {
            return None;
        }
        let state = |i: usize| {
            let motion = match first.states[i].kind {
                Kind::Integral => Motion::Integral,
                Kind::Slow(_) => Motion::Slow(V::from_fn(token, |l| match plans[l].states[i].kind {
                    Kind::Slow(own) => own,
                    _ => f64::NAN,
                })),
                Kind::Fast => Motion::Fast,
            };
            let same_kind = |plan: &Plan| {
                std::mem::discriminant(&plan.states[i].kind) == std::mem::discriminant(&first.states[i].kind)
            };
            if !plans.iter().all(same_kind) {
                return None;
            }
            Some(Coordinate {
                motion,
                drive: row(token, plans, |plan| &plan.states[i].drive)?,
                follows: terms(token, plans, |plan| &plan.states[i].follows)?,
            })
        };
        let load_estimate = match first.load_estimate {
            None => None,
            Some(_) => {
                Some(row(token, plans, |plan| plan.load_estimate.as_ref().unwrap_or(&plan.manipulated))?)
            }
        };
        Some(Self {
            states: (0..first.states.len()).map(state).collect::<Option<_>>()?,
            inputs: (0..first.inputs.len())
                .map(|c| row(token, plans, |plan| &plan.inputs[c]))
                .collect::<Option<_>>()?,
            manipulated: row(token, plans, |plan| &plan.manipulated)?,
            load_estimate,
            rate: V::from_fn(token, |l| plans[l].rate),
            pieces: first.pieces,
        })
    }
}

#[inline(always)]
fn row<V: Lanes>(token: V::Token, plans: &[Plan], of: impl Fn(&Plan) -> &Row) -> Option<Weights<V>> {
    Some(Weights {
        states: terms(token, plans, |plan| &of(plan).states)?,
        delayed: terms(token, plans, |plan| &of(plan).delayed)?,
    })
}

#[inline(always)]
fn terms<V: Lanes>(
    token: V::Token,
    plans: &[Plan],
    of: impl Fn(&Plan) -> &[(usize, f64)],
) -> Option<Vec<(usize, V)>> {
    let first = of(&plans[0]);
    let alike =
        |list: &[(usize, f64)]| list.len() == first.len() && list.iter().zip(first).all(|(a, b)| a.0 == b.0);
    if !plans.iter().all(|plan| alike(of(plan))) {
        return None;
    }
    let weights = |k: usize| V::from_fn(token, |l| of(&plans[l])[k].1);
    Some(
        (0..first.len())
            .map(
                #[inline(always)]
                |k| (first[k].0, weights(k)),
            )
            .collect(),
    )
}
