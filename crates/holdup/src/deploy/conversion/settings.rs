//! Settings of a block as they are typed: names and values.

use std::fmt;

use serde::{Serialize, Serializer};

use super::numbers::decoded;
use super::vendor::{Action, Filter, Gain, Number, Vendor, Weight, Weights};
use crate::model::quantity::read_number;
use crate::model::text::{Problem, TextError};

/// What is typed into a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// A number, in the unit of the parameter.
    Number(f64),
    /// A choice.
    Word(&'static str),
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Number(number) => number.serialize(serializer),
            Self::Word(word) => word.serialize(serializer),
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => number.fmt(out),
            Self::Word(word) => word.fmt(out),
        }
    }
}

/// What a known parameter of a block takes.
enum Takes {
    Number,
    Words(Vec<&'static str>),
    /// It has no bearing on the law: a span or the sample period, which the scaling says.
    Nothing,
}

/// Settings read out of a block: known names, each once.
///
/// ```
/// use holdup::deploy::conversion::{Given, Value, vendor};
/// let given = Given::read(vendor("rockwell-pide-independent")?, &["PGain=2,IGain=0.4"])?;
/// assert_eq!(given.get("IGain"), Some(Value::Number(0.4)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Given(Vec<(&'static str, Value)>);

impl Given {
    /// Reads `name=value` pairs, one or several to a text, separated by commas.
    ///
    /// A long name may be given by its part behind the last dot; letter case does not matter. A comma within a word
    /// stays in it.
    ///
    /// # Errors
    /// [`TextError`] for an unknown name, one given twice, or a value that the parameter does not take.
    pub fn read(vendor: &Vendor, texts: &[impl AsRef<str>]) -> Result<Self, TextError> {
        let known = known(vendor);
        let mut given = Self::default();
        for pair in texts.iter().flat_map(|text| pairs(text.as_ref())) {
            let Some((name, text)) = pair.split_once('=') else {
                let message = format!("is not name=value: must be such as {}=1", known[0].0);
                return Err(TextError::at(pair, Problem::Syntax { message }));
            };
            let (name, text) = (name.trim(), text.trim());
            let leaf = |long: &str| long.rsplit('.').next().unwrap_or(long).eq_ignore_ascii_case(name);
            let found = known
                .iter()
                .find(|(long, _)| long.eq_ignore_ascii_case(name))
                .or_else(|| known.iter().find(|(long, _)| leaf(long)));
            let Some((long, takes)) = found else {
                return Err(TextError::unknown(
                    name,
                    &known.iter().map(|(long, _)| *long).collect::<Vec<_>>(),
                ));
            };
            if given.get(long).is_some() {
                return Err(TextError::at(*long, Problem::Twice));
            }
            let value = match takes {
                Takes::Number | Takes::Nothing => Value::Number(read_number(long, text)?),
                Takes::Words(words) => {
                    let word = words.iter().find(|word| word.eq_ignore_ascii_case(text));
                    Value::Word(word.ok_or_else(|| TextError::value(*long, text, one_of(words)))?)
                }
            };
            given.0.push((long, value));
        }
        Ok(given)
    }

    /// Settings that were typed, in this order.
    pub(super) fn of(pairs: impl IntoIterator<Item = (&'static str, Value)>) -> Self {
        Self(pairs.into_iter().collect())
    }

    /// The value of a parameter, by its full name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<Value> {
        self.0.iter().find(|(given, _)| *given == name).map(|(_, value)| *value)
    }

    /// The value of a parameter, where its number was given.
    pub(super) fn number(&self, number: &Number) -> Option<f64> {
        match self.get(number.name) {
            Some(Value::Number(typed)) => Some(decoded(number, typed)),
            _ => None,
        }
    }

    /// Whether a switch stands on this word.
    pub(super) fn is(&self, name: &str, word: &str) -> bool {
        matches!(self.get(name), Some(Value::Word(given)) if given == word)
    }
}

/// The pairs of a text: a comma separates only where a name and `=` follow.
fn pairs(text: &str) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for piece in text.split(',') {
        match found.last_mut() {
            Some(last) if !piece.contains('=') => {
                last.push(',');
                last.push_str(piece);
            }
            _ => found.push(piece.to_owned()),
        }
    }
    found
}

fn one_of(words: &[&str]) -> String {
    format!("one of {}", words.iter().map(|word| format!("'{word}'")).collect::<Vec<_>>().join(", "))
}

/// The names that a block knows, in the order in which they are typed.
fn known(vendor: &Vendor) -> Vec<(&'static str, Takes)> {
    let (Gain::Gain(gain) | Gain::Band(gain)) = vendor.gain;
    let mut known: Vec<(&'static str, Takes)> = [gain, vendor.integral.number, vendor.derivative.number]
        .map(|number| (number.name, Takes::Number))
        .into();
    match vendor.filter {
        Filter::Absent | Filter::Fixed(_) => {}
        Filter::Switch { name, on, off, .. } => known.push((name, Takes::Words(vec![off, on]))),
        Filter::Ratio(number, _) | Filter::Divisor(number, _) | Filter::Time(number, _, _) => {
            known.push((number.name, Takes::Number));
        }
    }
    match vendor.weights {
        Weights::Each { b, c } => known.extend([b, c].into_iter().filter_map(|weight| match weight {
            Weight::Fixed(_) => None,
            Weight::Number(number, _) | Weight::Complement(number, _) => Some((number.name, Takes::Number)),
            Weight::Words { name, one, zero, .. } => Some((name, Takes::Words(vec![one, zero]))),
        })),
        Weights::Choice { name, choices, free } => {
            let words = choices.iter().map(|choice| choice.word).chain(free.map(|free| free.0)).collect();
            known.push((name, Takes::Words(words)));
            if let Some((_, b, c)) = free {
                known.extend([(b.name, Takes::Number), (c.name, Takes::Number)]);
            }
        }
    }
    if let Action::Words { name, reverse, direct } = vendor.action {
        known.push((name, Takes::Words(vec![reverse, direct])));
    }
    known.extend(vendor.fixed.iter().map(|fixed| (fixed.name, Takes::Words(vec![fixed.word]))));
    let spans = vendor.spans.iter().flat_map(|spans| [spans.pv, spans.op]).flatten();
    known.extend(spans.flat_map(|(low, high)| [low, high]).map(|name| (name, Takes::Nothing)));
    known.extend(vendor.sample_period.map(|(number, _)| (number.name, Takes::Nothing)));
    known
}

#[cfg(test)]
mod tests {
    use super::super::vendor;
    use super::*;

    #[test]
    fn a_comma_within_a_word_stays_in_it() {
        let text = "GAIN=2,STRUCTURE=PI action on Error, D action on PV,RESET=30";
        assert_eq!(pairs(text).len(), 3);
    }

    #[test]
    fn faults_name_the_parameter_and_what_is_allowed() {
        let vendor = vendor("siemens-pid-compact").unwrap();
        for (text, part) in [
            ("Gain", "is not name=value"),
            ("Gane=1", "did you mean"),
            ("Gain=x", "Gain is x: must be a finite number"),
            ("Gain=1,gain=2", "given twice"),
            ("InvertControl=maybe", "one of 'FALSE', 'TRUE'"),
        ] {
            let error = Given::read(vendor, &[text]).unwrap_err().to_string();
            assert!(error.contains(part) && !error.contains('\n'), "{text}: {error}");
        }
    }
}
