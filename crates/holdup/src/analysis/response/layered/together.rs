//! The plans of several loops of one structure, as one.

use super::super::system::Row;
use super::lanes::Lanes;
use super::plan::{Kind, Plan};

/// A weighted sum of states and of what comes out of the delays, with weights for each of `L` loops.
#[derive(Debug, Clone, Default)]
pub(super) struct Weights<const L: usize> {
    pub(super) states: Vec<(usize, Lanes<L>)>,
    pub(super) delayed: Vec<(usize, Lanes<L>)>,
}

/// How a state moves by itself; see [`Kind`].
#[derive(Debug, Clone, Copy)]
pub(super) enum Motion<const L: usize> {
    Integral,
    Slow(Lanes<L>),
    Fast,
}

/// One state of each loop; see [`State`](super::plan::State).
#[derive(Debug, Clone)]
pub(super) struct Coordinate<const L: usize> {
    pub(super) motion: Motion<L>,
    pub(super) drive: Weights<L>,
    pub(super) follows: Vec<(usize, Lanes<L>)>,
}

/// [`Plan`] of `L` loops.
#[derive(Debug, Clone)]
pub(super) struct Together<const L: usize> {
    pub(super) states: Vec<Coordinate<L>>,
    pub(super) inputs: Vec<Weights<L>>,
    pub(super) manipulated: Weights<L>,
    pub(super) load_estimate: Option<Weights<L>>,
    pub(super) rate: Lanes<L>,
    pub(super) pieces: u32,
}

impl<const L: usize> Together<L> {
    /// `None` where the loops differ in structure.
    pub(super) fn new(plans: &[Plan; L]) -> Option<Self> {
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
                Kind::Slow(_) => {
                    Motion::Slow(Lanes(plans.each_ref().map(|plan| match plan.states[i].kind {
                        Kind::Slow(own) => own,
                        _ => f64::NAN,
                    })))
                }
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
                drive: row(plans, |plan| &plan.states[i].drive)?,
                follows: terms(plans, |plan| &plan.states[i].follows)?,
            })
        };
        let load_estimate = match first.load_estimate {
            None => None,
            Some(_) => Some(row(plans, |plan| plan.load_estimate.as_ref().unwrap_or(&plan.manipulated))?),
        };
        Some(Self {
            states: (0..first.states.len()).map(state).collect::<Option<_>>()?,
            inputs: (0..first.inputs.len())
                .map(|c| row(plans, |plan| &plan.inputs[c]))
                .collect::<Option<_>>()?,
            manipulated: row(plans, |plan| &plan.manipulated)?,
            load_estimate,
            rate: Lanes(plans.each_ref().map(|plan| plan.rate)),
            pieces: first.pieces,
        })
    }
}

fn row<const L: usize>(plans: &[Plan; L], of: impl Fn(&Plan) -> &Row) -> Option<Weights<L>> {
    Some(Weights {
        states: terms(plans, |plan| &of(plan).states)?,
        delayed: terms(plans, |plan| &of(plan).delayed)?,
    })
}

fn terms<const L: usize>(
    plans: &[Plan; L],
    of: impl Fn(&Plan) -> &Vec<(usize, f64)>,
) -> Option<Vec<(usize, Lanes<L>)>> {
    let lists = plans.each_ref().map(&of);
    let first = lists[0];
    let alike = |list: &Vec<(usize, f64)>| {
        list.len() == first.len() && list.iter().zip(first).all(|(a, b)| a.0 == b.0)
    };
    if !lists.iter().all(|list| alike(list)) {
        return None;
    }
    Some((0..first.len()).map(|k| (first[k].0, Lanes(lists.map(|list| list[k].1)))).collect())
}
