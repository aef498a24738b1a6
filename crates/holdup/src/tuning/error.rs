//! Why a rule gives no controller.

use serde::Serialize;
use thiserror::Error;

use super::expression::ExpressionError;
use super::specification::Specification;
use crate::model::ModelError;

/// Why a rule gives no controller.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RuleError {
    /// No rule has this identifier.
    #[error("no rule is called `{given}`{}", suggestion(*.nearest))]
    UnknownRule {
        /// What was given.
        given: String,
        /// The nearest identifier.
        nearest: Option<&'static str>,
    },
    /// The rule has no such parameter.
    #[error("{rule} has no parameter `{given}`{}", parameters(*.nearest, .known))]
    UnknownParameter {
        /// The rule.
        rule: &'static str,
        /// What was given.
        given: String,
        /// The nearest parameter.
        nearest: Option<&'static str>,
        /// All its parameters.
        known: Vec<&'static str>,
    },
    /// A parameter is given twice.
    #[error("{rule}: `{parameter}` is given twice")]
    Twice {
        /// The rule.
        rule: &'static str,
        /// The parameter.
        parameter: String,
    },
    /// A parameter lies outside its range.
    #[error("{rule}: {parameter} is {value}: must be {range}")]
    OutOfRange {
        /// The rule.
        rule: &'static str,
        /// The parameter.
        parameter: &'static str,
        /// The value given.
        value: f64,
        /// The range.
        range: String,
    },
    /// The parameters do not make one question: too few, too many, or contradictory.
    #[error("{rule}: {reason}")]
    Combination {
        /// The rule.
        rule: &'static str,
        /// What is needed.
        reason: &'static str,
    },
    /// The rule is for another kind of process.
    #[error("{rule} does not apply: it is for a process {needs}")]
    DoesNotApply {
        /// The rule.
        rule: &'static str,
        /// What it is for.
        needs: &'static str,
    },
    /// The settings are no controller, for example because a number overflows.
    #[error("{rule}: {error}")]
    Setting {
        /// The rule.
        rule: &'static str,
        /// What is wrong with the setting.
        error: ModelError,
    },
    /// A formula has no value: a table has no such row.
    #[error("{rule}: {error}")]
    Formula {
        /// The rule.
        rule: &'static str,
        /// What is wrong.
        error: ExpressionError,
    },
    /// No controller of this structure meets the specification. An answer, not a mistake of the caller.
    #[error("{0}")]
    Infeasible(Box<Infeasible>),
    /// The analysis of the loop that the search needs has failed.
    #[error("{rule}: {reason}")]
    Analysis {
        /// The rule.
        rule: &'static str,
        /// What the analysis says.
        reason: String,
    },
}

/// A specification that no controller of the structure meets, and what can be had instead.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Infeasible {
    /// The rule that was asked.
    pub rule: &'static str,
    /// What was asked for.
    pub asked: Specification,
    /// Why it cannot be had.
    pub reason: String,
    /// The nearest specifications that can be had: both sides of a jump, or the nearest pair.
    pub nearest: Vec<Specification>,
}

impl std::fmt::Display for Infeasible {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: infeasible: {}", self.rule, self.reason)?;
        for (index, specification) in self.nearest.iter().enumerate() {
            write!(f, "{}{specification}", if index == 0 { "; feasible: " } else { " or " })?;
        }
        Ok(())
    }
}

fn suggestion(nearest: Option<&str>) -> String {
    nearest.map_or_else(String::new, |name| format!(": did you mean `{name}`?"))
}

fn parameters(nearest: Option<&str>, known: &[&str]) -> String {
    match nearest {
        Some(_) => suggestion(nearest),
        None if known.is_empty() => ": it has none".to_owned(),
        None => format!(": it has {}", known.join(", ")),
    }
}
