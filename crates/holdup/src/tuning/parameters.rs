//! The parameters of a rule: what the caller sets, and what the rule reads.

use std::f64::consts::PI;

use super::entry::{Default, Entry, Parameter, Unit};
use super::error::RuleError;
use super::expression::{ExpressionError, evaluate};
use super::nearest::nearest;
use super::range;
use super::specification::{Property, Specification};
use crate::model::Process;

/// What the caller sets, by the names of the rule; angles in radians, times in seconds.
///
/// ```
/// use holdup::tuning::Parameters;
/// let parameters = Parameters::new().set("Ts", 40.0).set("phi_m", std::f64::consts::PI);
/// assert_eq!(parameters.names().count(), 2);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Parameters(Vec<(String, f64)>);

impl Parameters {
    /// No parameter set: the rule's defaults.
    #[must_use]
    pub const fn new() -> Self {
        Self(Vec::new())
    }

    /// The same with one more parameter. A name set twice is refused by the rule.
    #[must_use]
    pub fn set(mut self, name: impl Into<String>, value: f64) -> Self {
        self.0.push((name.into(), value));
        self
    }

    /// The names that are set.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|(name, _)| name.as_str())
    }

    fn get(&self, name: &str) -> Option<f64> {
        self.0.iter().find(|(n, _)| n == name).map(|(_, value)| *value)
    }
}

impl std::default::Default for Parameters {
    fn default() -> Self {
        Self::new()
    }
}

/// What a rule reads: its parameters, set or by default, the process, and the settings computed so far.
///
/// The process gain K is its absolute value, and gains among the parameters are turned to the same sign.
#[derive(Debug, Clone)]
pub struct Values<'a> {
    entry: &'static Entry,
    set: &'a Parameters,
    process: &'a Process,
    computed: Vec<(&'static str, f64)>,
}

impl<'a> Values<'a> {
    pub(super) fn new(
        entry: &'static Entry,
        process: &'a Process,
        set: &'a Parameters,
    ) -> Result<Self, RuleError> {
        let rule = entry.id;
        let known = || entry.parameters.iter().map(|parameter| parameter.name);
        for (index, given) in set.names().enumerate() {
            if !known().any(|name| name == given) {
                let (given, nearest) = (given.to_owned(), nearest(given, known()));
                return Err(RuleError::UnknownParameter { rule, given, nearest, known: known().collect() });
            }
            if set.names().take(index).any(|name| name == given) {
                return Err(RuleError::Twice { rule, parameter: given.to_owned() });
            }
        }
        let values = Self { entry, set, process, computed: Vec::new() };
        for parameter in entry.parameters {
            if let Some(given) = set.get(parameter.name) {
                values.check(parameter, given)?;
            }
        }
        Ok(values)
    }

    fn check(&self, parameter: &'static Parameter, given: f64) -> Result<(), RuleError> {
        let value = self.turned(parameter, given);
        match range::contains(parameter.range, value, &|name| self.get(name).ok()) {
            Ok(true) => Ok(()),
            Ok(false) => Err(RuleError::OutOfRange {
                rule: self.entry.id,
                parameter: parameter.name,
                value: given,
                range: if parameter.unit == Unit::Gain && self.sign() < 0.0 {
                    format!("{} times -1, the sign of the process gain", parameter.range)
                } else {
                    parameter.range.to_owned()
                },
            }),
            Err(error) => Err(self.formula_error(error)),
        }
    }

    /// A gain with the sign that it has for a positive process gain.
    fn turned(&self, parameter: &Parameter, given: f64) -> f64 {
        if parameter.unit == Unit::Gain { given * self.sign() } else { given }
    }

    fn formula_error(&self, error: ExpressionError) -> RuleError {
        RuleError::Formula { rule: self.entry.id, error }
    }

    /// 1 or −1, the sign of the process gain.
    #[must_use]
    pub fn sign(&self) -> f64 {
        self.process.process_gain().signum()
    }

    /// The value of a name: a computed setting, a parameter, K, d or T.
    ///
    /// # Errors
    /// [`RuleError::Formula`] if nothing has this name, or a default has no value.
    pub fn get(&self, name: &str) -> Result<f64, RuleError> {
        self.value(name, 0).map_err(|error| self.formula_error(error))
    }

    fn value(&self, name: &str, depth: u8) -> Result<f64, ExpressionError> {
        let unknown = || ExpressionError::UnknownName { name: name.to_owned() };
        if let Some((_, value)) = self.computed.iter().rev().find(|(n, _)| *n == name) {
            return Ok(*value);
        }
        if let Some(parameter) = self.entry.parameters.iter().find(|p| p.name == name) {
            if let Some(given) = self.set.get(name) {
                return Ok(self.turned(parameter, given));
            }
            return match parameter.default {
                Default::Number(number) => Ok(number),
                Default::Formula(text) if depth < 8 => evaluate(text, &|n| self.value(n, depth + 1).ok()),
                Default::Formula(_) | Default::Absent => Err(unknown()),
            };
        }
        match name {
            "K" => Ok(self.process.process_gain().abs()),
            "d" => Ok(self.process.dead_time()),
            "T" => self.process.lag().ok_or_else(unknown),
            _ => Err(unknown()),
        }
    }

    /// The value of a parameter where the caller set it.
    #[must_use]
    pub fn given(&self, name: &str) -> Option<f64> {
        let parameter = self.entry.parameters.iter().find(|p| p.name == name)?;
        Some(self.turned(parameter, self.set.get(name)?))
    }

    /// Evaluates a formula of the rule and keeps its value under its name.
    ///
    /// # Errors
    /// [`RuleError::Formula`] if it has no value.
    pub fn compute(&mut self, name: &'static str, formula: &str) -> Result<f64, RuleError> {
        let value =
            evaluate(formula, &|n| self.value(n, 0).ok()).map_err(|error| self.formula_error(error))?;
        self.keep(name, value);
        Ok(value)
    }

    /// Keeps a value under a name.
    pub fn keep(&mut self, name: &'static str, value: f64) {
        self.computed.push((name, value));
    }

    /// Forgets the settings computed so far.
    pub(super) fn clear(&mut self) {
        self.computed.clear();
    }

    /// The settings computed so far, in their order.
    #[must_use]
    pub fn computed(&self) -> &[(&'static str, f64)] {
        &self.computed
    }

    /// What the parameters ask for.
    #[must_use]
    pub fn specification(&self) -> Specification {
        let mut asked = Specification::default();
        for parameter in self.entry.parameters {
            let (Some(property), Ok(value)) = (parameter.asks, self.get(parameter.name)) else { continue };
            let in_unit = match parameter.unit {
                Unit::Degree => value * PI / 180.0,
                Unit::Percent => value / 100.0,
                _ => value,
            };
            let place = match property {
                Property::GainMargin => &mut asked.gain_margin,
                Property::PhaseMargin => &mut asked.phase_margin,
                Property::SettlingTime => &mut asked.settling_time,
                Property::SensitivityPeak => &mut asked.sensitivity_peak,
                Property::RelativeDelayMargin => &mut asked.delay_margin,
                Property::Overshoot => &mut asked.overshoot,
                Property::ClosedLoopTimeConstant => &mut asked.closed_loop_time_constant,
                Property::DampingRatio => &mut asked.damping_ratio,
            };
            let relative = property == Property::RelativeDelayMargin;
            *place = Some(if relative { in_unit * self.process.dead_time() } else { in_unit });
        }
        asked
    }
}
