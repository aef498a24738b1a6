//! Setpoint weights: which equation, switch or number gives them.

use super::settings::{Given, Value};
use super::sheet::Parameter;
use super::vendor::{Number, Weight, Weights};

/// The weights b and c of the ideal form that a block with these weights of its own has; `factor` is P of an
/// interacting block, 1 otherwise.
///
/// In an interacting block the lead acts on what the derivative acts on. With the whole on the error both are 1; with
/// the lead on the measurement alone the setpoint passes `K'·(b + 1/(Ti'·s))`, where K' is K/P.
pub(super) fn ideal((b, c): (f64, f64), factor: f64) -> (f64, f64) {
    if factor == 1.0 || c != 0.0 { (b, c) } else { (b / factor, 0.0) }
}

/// What is typed so that the ideal form has the weights nearest to `wanted`; c does not count without derivative
/// action.
pub(super) fn typed(
    weights: &Weights,
    wanted: (f64, f64),
    factor: f64,
    integral: bool,
    derivative: bool,
) -> Vec<Parameter> {
    match *weights {
        Weights::Each { b, c } => {
            let c = Some(one(c, wanted.1)).filter(|_| derivative);
            [Some(one(b, wanted.0 * factor)), c].into_iter().flatten().flatten().collect()
        }
        Weights::Choice { name, choices, free } => {
            let fitting =
                choices.iter().filter(|choice| choice.integral.is_none_or(|needs| needs == integral));
            let distance = |(b, c): (f64, f64)| {
                (b - wanted.0).abs() + if derivative { (c - wanted.1).abs() } else { 0.0 }
            };
            let best = fitting
                .map(|choice| (distance(ideal((choice.b, choice.c), factor)), choice))
                .min_by(|left, right| left.0.total_cmp(&right.0));
            let word = |word| Parameter::word(name, word, "");
            match (best, free) {
                (Some((0.0, choice)), _) => vec![word(choice.word)],
                (_, Some((free, b, c))) if integral => {
                    let c = Some(number(&c, wanted.1)).filter(|_| derivative);
                    [Some(word(free)), Some(number(&b, wanted.0)), c].into_iter().flatten().collect()
                }
                (Some((_, choice)), _) => vec![word(choice.word)],
                (None, _) => Vec::new(),
            }
        }
    }
}

/// What is typed for one weight; nothing where it is fixed.
fn one(weight: Weight, wanted: f64) -> Option<Parameter> {
    match weight {
        Weight::Fixed(_) => None,
        Weight::Number(key, _) => Some(number(&key, wanted)),
        Weight::Complement(key, _) => Some(number(&key, 1.0 - wanted)),
        Weight::Words { name, one, zero, .. } => {
            Some(Parameter::word(name, if wanted > 0.5 { one } else { zero }, ""))
        }
    }
}

/// A weight that the block limits to its range.
fn number(key: &Number, wanted: f64) -> Parameter {
    let (low, high) = key.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
    Parameter::number(key, wanted.max(low).min(high))
}

/// The block's own weights by its settings.
pub(super) fn read(weights: &Weights, given: &Given) -> (f64, f64) {
    match *weights {
        Weights::Each { b, c } => (value(b, given), value(c, given)),
        Weights::Choice { name, choices, free } => {
            if let Some((word, b, c)) = free
                && given.is(name, word)
            {
                return (given.number(&b).unwrap_or(1.0), given.number(&c).unwrap_or(0.0));
            }
            let chosen = choices.iter().find(|choice| given.get(name) == Some(Value::Word(choice.word)));
            chosen.or(choices.first()).map_or((1.0, 1.0), |choice| (choice.b, choice.c))
        }
    }
}

fn value(weight: Weight, given: &Given) -> f64 {
    match weight {
        Weight::Fixed(value) => value,
        Weight::Number(key, default) => given.number(&key).unwrap_or(default),
        Weight::Complement(key, default) => 1.0 - given.number(&key).unwrap_or(default),
        Weight::Words { name, one, zero, one_is_default } => {
            let is_one = given.is(name, one) || (one_is_default && !given.is(name, zero));
            f64::from(u8::from(is_one))
        }
    }
}
