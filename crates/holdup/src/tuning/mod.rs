//! How to choose the controller: published rules, and tuning that meets its specification exactly.
//!
//! Every rule is one file of `tuning/rules`, registered by its identifier:
//!
//! ```
//! use holdup::model::{Process, Seconds};
//! use holdup::tuning::{Parameters, rule, rules};
//! let process = Process::integrating(0.0506, Seconds(6.0)).expect("valid");
//! let tuning = rule("pid-wang-cluett-z1")?.tune(&process, &Parameters::new().set("beta", 4.0))?;
//! assert!((tuning.controller.proportional_gain() - 1.2416).abs() < 5e-5);
//! assert!(rules().iter().any(|entry| entry.id == "pd-kadam"));
//! # Ok::<(), holdup::tuning::RuleError>(())
//! ```

use serde::Serialize;

use crate::model::Controller;

mod achieved;
mod entry;
mod error;
mod exact;
mod expression;
mod formula;
mod line;
mod nearest;
pub mod optimise;
mod parameters;
mod published;
mod range;
pub mod ranking;
pub mod robust;
mod rules;
mod specification;

pub use entry::{Applies, Default, Entry, Form, Law, Parameter, Provenance, Status, Unit};
pub use error::{Infeasible, RuleError};
pub use expression::{ExpressionError, evaluate};
pub use formula::{CompensatorOf, by_formula, compensated, from_settings};
pub use parameters::{Parameters, Values};
pub use published::Judgement;
pub use specification::{Property, Specification};

/// Every registered rule, in the order of the identifiers.
#[must_use]
pub fn rules() -> &'static [&'static Entry] {
    rules::REGISTRY
}

/// The rule of this identifier; underscores count as hyphens.
///
/// # Errors
/// [`RuleError::UnknownRule`], with the nearest identifier.
pub fn rule(id: &str) -> Result<&'static Entry, RuleError> {
    let wanted = id.replace('_', "-");
    rules().iter().copied().find(|entry| entry.id == wanted).ok_or_else(|| RuleError::UnknownRule {
        given: id.to_owned(),
        nearest: nearest::nearest(&wanted, rules().iter().map(|entry| entry.id)),
    })
}

/// What a rule gives: the controller, how its source writes it, and what was asked for.
///
/// What is achieved is not here: the analysis says it.
#[derive(Debug, Clone, PartialEq)]
pub struct Tuning {
    /// Identifier of the rule.
    pub rule: &'static str,
    /// The controller in ideal form.
    pub controller: Controller,
    /// The settings in the source's own form.
    pub published: Published,
    /// What was asked for.
    pub specification: Specification,
    /// What the user must know.
    pub warnings: Vec<String>,
    /// Further controllers that meet the same specification, by falling preference.
    pub alternatives: Vec<Controller>,
    /// What more observer gain buys and costs, where the rule has an observer to choose.
    pub trade_off: Vec<TradeOff>,
}

impl Tuning {
    pub(crate) fn new(rule: &'static str, controller: Controller, specification: Specification) -> Self {
        Self {
            rule,
            controller,
            published: Published { form: Form::Ideal.text(), settings: Vec::new() },
            specification,
            warnings: Vec::new(),
            alternatives: Vec::new(),
            trade_off: Vec::new(),
        }
    }
}

/// The settings in the form of the source.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Published {
    /// The form for reading.
    pub form: &'static str,
    /// The settings.
    pub settings: Vec<Setting>,
}

/// One setting of a controller.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Setting {
    /// Name: `Kc`, `Ti`, `Td`, `Tf`, `N`, `b`, `Ko` …
    pub name: &'static str,
    /// Value, in its unit.
    pub value: f64,
    /// Unit for reading; empty for a ratio.
    pub unit: &'static str,
}

/// One point of the trade between load rejection and robustness of a loop with an observer.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct TradeOff {
    /// Observer gain Ko [input/output unit].
    pub observer_gain: f64,
    /// Sensitivity peak of the whole loop, broken at the process input; absent where it is unstable.
    pub sensitivity_peak: Option<f64>,
    /// Integral of the control error after a unit load step, 1/(K·Kc·Ko) in absolute value [output unit · s].
    #[serde(rename = "load_integral_error")]
    pub load_integral_error: f64,
}
