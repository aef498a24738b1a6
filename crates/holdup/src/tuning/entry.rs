//! What a rule is: the entry of the registry that list, documentation and menus iterate.

use super::error::RuleError;
use super::parameters::{Parameters, Values};
use super::specification::Property;
use super::{Tuning, range};
use crate::model::Process;

/// One published rule.
///
/// ```
/// use holdup::model::{Process, Seconds};
/// use holdup::tuning::{Parameters, rule};
/// let process = Process::integrating(0.0506, Seconds(6.0)).expect("valid");
/// let tuning = rule("pi-simc")?.tune(&process, &Parameters::new().set("tau_c", 12.0))?;
/// assert_eq!(tuning.controller.integral_time(), Some(72.0));
/// # Ok::<(), holdup::tuning::RuleError>(())
/// ```
#[derive(Debug)]
pub struct Entry {
    /// Identifier, as on the command line: `pi-simc`.
    pub id: &'static str,
    /// Name for reading.
    pub name: &'static str,
    /// Authors.
    pub authors: &'static str,
    /// Year of the publication.
    pub year: u16,
    /// Title, journal, pages; equation where known.
    pub citation: &'static str,
    /// Structure: `PI`, `PID`, `PD+DOB` …
    pub structure: &'static str,
    /// The process it is for.
    pub process: Applies,
    /// The form of the controller in the source.
    pub form: Form,
    /// What may be set.
    pub parameters: &'static [Parameter],
    /// The settings as formulas, in the order of their evaluation: name and formula. K there is the absolute
    /// value of the process gain; the gains take its sign.
    pub formula: &'static [(&'static str, &'static str)],
    /// When to use it.
    pub when: &'static str,
    /// Its limits.
    pub limits: &'static str,
    /// Where its source says it holds: a formula and the range of its value. Outside, a warning is given.
    pub validity: &'static [(&'static str, &'static str)],
    /// How the formula came here.
    pub provenance: Provenance,
    /// Where from.
    pub source: &'static str,
    /// Whether it is recommended, history or wrong.
    pub status: Status,
    /// Its published values: the text of `tests/rules/<id>.toml`.
    pub values: &'static str,
    /// The rule itself; callers use [`Entry::tune`], which checks parameters and process first.
    pub law: Law,
}

/// How a rule computes: [`super::by_formula`], or a function of its own.
pub type Law = fn(&'static Entry, &Process, &Values<'_>) -> Result<Tuning, RuleError>;

impl Entry {
    /// The controller of this rule for a process; parameters that are not set have their defaults.
    ///
    /// The loop may be unstable where the rule makes it so: analyse it.
    ///
    /// # Errors
    /// [`RuleError`] if the rule is for another kind of process, a parameter is unknown, given twice or out of
    /// its range, or no controller meets the specification.
    pub fn tune(&'static self, process: &Process, parameters: &Parameters) -> Result<Tuning, RuleError> {
        let values = self.values(process, parameters)?;
        let mut tuning = (self.law)(self, process, &values)?;
        tuning.warnings.extend(self.warnings(process, &values, &tuning));
        Ok(tuning)
    }

    /// Whether process and parameters are those of the rule, without computing the controller.
    ///
    /// # Errors
    /// [`RuleError`] as [`Entry::tune`] for what can be seen before.
    pub fn check(&'static self, process: &Process, parameters: &Parameters) -> Result<(), RuleError> {
        self.values(process, parameters).map(|_| ())
    }

    fn values<'a>(
        &'static self,
        process: &'a Process,
        parameters: &'a Parameters,
    ) -> Result<Values<'a>, RuleError> {
        if !self.process.admits(process) {
            return Err(RuleError::DoesNotApply { rule: self.id, needs: self.process.description() });
        }
        Values::new(self, process, parameters)
    }

    /// Whether the rule is for this kind of process.
    #[must_use]
    pub fn applies(&self, process: &Process) -> bool {
        self.process.admits(process)
    }

    fn warnings(&self, process: &Process, values: &Values<'_>, tuning: &Tuning) -> Vec<String> {
        let mut warnings = Vec::new();
        match self.status {
            Status::Recommended => {}
            Status::History(why) => warnings.push(format!("kept as history, not recommended: {why}")),
            Status::Wrong(why) => warnings.push(format!("not to be used: {why}")),
        }
        for parameter in self.parameters {
            if let (Some(advised), Ok(value)) = (parameter.advised, values.get(parameter.name))
                && range::contains(advised, value, &|name| values.get(name).ok()) == Ok(false)
            {
                warnings.push(format!("{} is {value}: its source advises {advised}", parameter.name));
            }
        }
        for (what, allowed) in self.validity {
            let lookup = |name: &str| values.get(name).ok();
            if let Ok(value) = super::evaluate(what, &lookup)
                && range::contains(allowed, value, &lookup) == Ok(false)
            {
                warnings.push(format!("outside the range of its source: {what} is {value}, not {allowed}"));
            }
        }
        let controller = &tuning.controller;
        if let (Some(td), None, None) =
            (controller.derivative_time(), controller.derivative_filter(), controller.output_filter())
        {
            let limit = (process.process_gain() * controller.proportional_gain() * td).abs();
            if process.is_plain() && limit >= 1.0 {
                warnings.push(format!(
                    "unstable: |K·Kc·Td| = {limit} is not below 1, so the unfiltered derivative alone closes an \
                     unstable loop"
                ));
            }
        }
        warnings
    }
}

/// The process that a rule is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Applies {
    /// `K·e^(−d·s)/s`.
    Integrating,
    /// `K·e^(−d·s)/(s·(T·s + 1))`.
    IntegratingWithLag,
    /// `K·e^(−d·s)/s²`.
    DoubleIntegrating,
}

impl Applies {
    /// Every kind of process.
    pub const ALL: [Self; 3] = [Self::Integrating, Self::IntegratingWithLag, Self::DoubleIntegrating];

    /// The word of the list: `integrating`, `integrating with lag`, `double integrating`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Integrating => "integrating",
            Self::IntegratingWithLag => "integrating with lag",
            Self::DoubleIntegrating => "double integrating",
        }
    }

    fn description(self) -> &'static str {
        match self {
            Self::Integrating => "with one integrator and no lag",
            Self::IntegratingWithLag => "with one integrator and a lag",
            Self::DoubleIntegrating => "with two integrators and no lag",
        }
    }

    fn admits(self, process: &Process) -> bool {
        let has_lag = process.lag().is_some();
        match self {
            Self::Integrating => process.integrators() == 1 && !has_lag,
            Self::IntegratingWithLag => process.integrators() == 1 && has_lag,
            Self::DoubleIntegrating => process.integrators() == 2 && !has_lag,
        }
    }
}

/// The form of a controller in its source.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// `Kc·(1 + 1/(Ti·s) + Td·s)`; a filter time Tf or bandwidth N filters the derivative action only.
    Ideal,
    /// As ideal, the whole output filtered by `1/(Tf·s + 1)` or `1/(a2·s² + a1·s + 1)`.
    IdealOutputFilter,
    /// `Kc·(1 + 1/(Ti·s))·(1 + Td·s)`, unfiltered.
    Series,
    /// As series, the whole output filtered by `1/(Tf·s + 1)`.
    SeriesOutputFilter,
    /// `Kc·(1 + 1/(Ti·s))·(1 + Td·s)/(Tf·s + 1)`: the lead of the series form filtered.
    SeriesFilteredLead,
    /// A dead-time compensator with a model of the process; its page has the law.
    Compensator,
}

impl Form {
    /// The transfer function for reading.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Ideal => "ideal: Kc (1 + 1/(Ti s) + Td s)",
            Self::IdealOutputFilter => "ideal with output filter: Kc (1 + 1/(Ti s) + Td s) / (filter)",
            Self::Series => "series: Kc (1 + 1/(Ti s)) (1 + Td s)",
            Self::SeriesOutputFilter => {
                "series with output filter: Kc (1 + 1/(Ti s)) (1 + Td s) / (Tf s + 1)"
            }
            Self::SeriesFilteredLead => "series with filtered lead: Kc (1 + 1/(Ti s)) (1 + Td s)/(Tf s + 1)",
            Self::Compensator => "dead-time compensator with the model K exp(-d s)/s",
        }
    }
}

/// How a formula came here.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Provenance {
    /// From a source that was read.
    Retrieved,
    /// In part from a source that was read, in part from memory.
    RetrievedAndMemory,
    /// From memory, no source was read.
    Memory,
    /// From memory, and derived again here.
    MemoryRederived,
    /// Derived here.
    Derived,
}

impl Provenance {
    /// The sentence for reading.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Retrieved => "from a source that was read",
            Self::RetrievedAndMemory => "partly from a source that was read, partly from memory",
            Self::Memory => "from memory: no source was read",
            Self::MemoryRederived => "from memory, derived again here",
            Self::Derived => "derived here",
        }
    }
}

/// Whether a rule is to be used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// It may be recommended.
    Recommended,
    /// Shown, never recommended; why.
    History(&'static str),
    /// Kept only so that it can be said what is wrong with it.
    Wrong(&'static str),
}

impl Status {
    /// The word of the list: `recommended`, `history` or `wrong`.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Recommended => "recommended",
            Self::History(_) => "history",
            Self::Wrong(_) => "wrong",
        }
    }

    /// Why it is not recommended.
    #[must_use]
    pub fn reason(self) -> Option<&'static str> {
        match self {
            Self::Recommended => None,
            Self::History(why) | Self::Wrong(why) => Some(why),
        }
    }
}

/// The value of a parameter that is not set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Default {
    /// A number.
    Number(f64),
    /// A formula in K, d, T and other parameters.
    Formula(&'static str),
    /// None: the parameter counts only when it is set.
    Absent,
}

/// The unit of a parameter or setting.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// A ratio.
    Ratio,
    /// Seconds.
    Second,
    /// Radians.
    Radian,
    /// Degrees.
    Degree,
    /// Percent.
    Percent,
    /// Controller output per controlled variable: takes the sign of the process gain.
    Gain,
    /// Radians per second.
    RadianPerSecond,
    /// Seconds squared.
    SecondSquared,
    /// Per second.
    PerSecond,
    /// Per second squared.
    PerSecondSquared,
}

impl Unit {
    /// The symbol: `s`, `rad`, `deg`, `%`; empty for a ratio.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Ratio => "",
            Self::Second => "s",
            Self::Radian => "rad",
            Self::Degree => "deg",
            Self::Percent => "%",
            Self::Gain => "input/output unit",
            Self::RadianPerSecond => "rad/s",
            Self::SecondSquared => "s²",
            Self::PerSecond => "1/s",
            Self::PerSecondSquared => "1/s²",
        }
    }
}

/// A parameter of a rule.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// Name, as in the source.
    pub name: &'static str,
    /// Unit.
    pub unit: Unit,
    /// What it is.
    pub description: &'static str,
    /// Its value when it is not set.
    pub default: Default,
    /// The range outside which it is refused: `any`, `1..20`, `> 0 and < pi/(2*K*d)`, `0.26 | 0.44`.
    pub range: &'static str,
    /// The range outside which a warning is given, where the source names one.
    pub advised: Option<&'static str>,
    /// The property that it asks for, where it does.
    pub asks: Option<Property>,
}

impl Parameter {
    /// A parameter that must be greater than 0.
    #[must_use]
    pub const fn new(name: &'static str, unit: Unit, default: Default, description: &'static str) -> Self {
        Self { name, unit, description, default, range: "> 0", advised: None, asks: None }
    }

    /// The same with another range.
    #[must_use]
    pub const fn range(self, range: &'static str) -> Self {
        Self { range, ..self }
    }

    /// The same with the range that the source advises.
    #[must_use]
    pub const fn advised(self, advised: &'static str) -> Self {
        Self { advised: Some(advised), ..self }
    }

    /// The same, asking for a property of the loop.
    #[must_use]
    pub const fn asks(self, property: Property) -> Self {
        Self { asks: Some(property), ..self }
    }

    /// The same under another name.
    #[must_use]
    pub const fn named(self, name: &'static str, description: &'static str) -> Self {
        Self { name, description, ..self }
    }

    /// The same, asking for no property of the loop.
    #[must_use]
    pub const fn no_goal(self) -> Self {
        Self { asks: None, ..self }
    }
}
