//! The published values of a rule, and what recomputing says of each.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::achieved::achieved;
use super::entry::Entry;
use super::expression::evaluate;
use super::parameters::Parameters;
use crate::model::{Process, Seconds};

/// The file `tests/rules/<id>.toml`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    /// Why there is no published value, where there is none.
    none: Option<String>,
    #[serde(default)]
    value: Vec<Value>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Value {
    what: String,
    printed: String,
    source: String,
    #[serde(default)]
    process: Example,
    #[serde(default)]
    set: BTreeMap<String, f64>,
    accept: Option<f64>,
    differs: Option<bool>,
    reason: Option<String>,
}

/// The process of a published value; all units 1 where the value is dimensionless.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case, reason = "the symbols of the sources")]
struct Example {
    K: f64,
    d: f64,
    T: Option<f64>,
}

impl std::default::Default for Example {
    fn default() -> Self {
        Self { K: 1.0, d: 1.0, T: None }
    }
}

/// A published value beside the computed one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Judgement {
    /// What is compared: a formula in the settings, in K, d, T, and in what the loop achieves (`sensitivity_peak` …).
    pub what: String,
    /// The value as printed.
    pub printed: String,
    /// The value computed.
    pub computed: f64,
    /// Where it is printed.
    pub source: String,
    /// Whether it is reproduced: within half a unit of the last printed digit, or within a stated tolerance.
    pub reproduced: bool,
    /// Whether the values file says so beforehand.
    pub expected: bool,
    /// Why a wider tolerance or a difference is right, where the file says so.
    pub reason: Option<String>,
}

impl Entry {
    /// What recomputing says of every published value of this rule.
    ///
    /// # Errors
    /// A sentence, if the values file is not what it must be: no value and no reason for that, an unknown key, a
    /// name that nothing has. A test keeps this from happening for registered rules.
    ///
    /// ```
    /// let rule = holdup::tuning::rule("pid-ali-majhi").expect("registered");
    /// let judged = rule.judge().expect("a valid values file");
    /// assert!(judged.iter().all(|value| value.reproduced));
    /// ```
    pub fn judge(&'static self) -> Result<Vec<Judgement>, String> {
        let file: File = toml::from_str(self.values).map_err(|error| error.to_string())?;
        if file.value.is_empty() && file.none.is_none() {
            return Err("no `[[value]]`, and no `none = \"why\"`".to_owned());
        }
        file.value
            .iter()
            .map(|value| self.judge_value(value).map_err(|e| format!("{}: {e}", value.what)))
            .collect()
    }

    fn judge_value(&'static self, value: &Value) -> Result<Judgement, String> {
        let process = value.process.process(self)?;
        let parameters =
            value.set.iter().fold(Parameters::new(), |set, (name, v)| set.set(name.as_str(), *v));
        let tuning = self.tune(&process, &parameters).map_err(|error| error.to_string())?;
        let setting = |name: &str| {
            let found = tuning.published.settings.iter().find(|setting| setting.name == name);
            found.map(|setting| setting.value).or(match name {
                "K" => Some(process.process_gain()),
                "d" => Some(process.dead_time()),
                "T" => process.lag(),
                _ => value.set.get(name).copied().or_else(|| achieved(name, &process, &tuning.controller)),
            })
        };
        let computed = evaluate(&value.what, &setting).map_err(|error| error.to_string())?;
        let printed: f64 = value.printed.parse().map_err(|_| format!("`{}` is no number", value.printed))?;
        let tolerance =
            value.accept.map_or_else(|| half_unit(&value.printed), |accept| accept * printed.abs());
        // A computed value may stand exactly between two printed ones: rounding then decides.
        let reproduced = (computed - printed).abs() <= tolerance * (1.0 + 1e-9);
        if (value.accept.is_some() || value.differs.is_some()) && value.reason.is_none() {
            return Err("`accept` and `differs` need a `reason`".to_owned());
        }
        Ok(Judgement {
            what: value.what.clone(),
            printed: value.printed.clone(),
            computed,
            source: value.source.clone(),
            reproduced,
            expected: reproduced != value.differs.unwrap_or(false),
            reason: value.reason.clone(),
        })
    }
}

impl Example {
    fn process(&self, entry: &Entry) -> Result<Process, String> {
        use super::Applies;
        let dead_time = Seconds(self.d);
        let process = match entry.process {
            Applies::DoubleIntegrating => Process::double_integrating(self.K, dead_time),
            Applies::Integrating => Process::integrating(self.K, dead_time),
            Applies::IntegratingWithLag => Process::integrating(self.K, dead_time)
                .and_then(|process| process.with_lag(Seconds(self.T.unwrap_or(1.0)))),
        };
        process.map_err(|error| error.to_string())
    }
}

/// Half a unit of the last printed digit.
fn half_unit(printed: &str) -> f64 {
    let digits = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    0.5 * 0.1_f64.powi(i32::try_from(digits).unwrap_or(i32::MAX))
}

#[cfg(test)]
mod tests {
    use super::half_unit;

    #[test]
    fn tolerance_follows_the_printed_digits() {
        assert_eq!(half_unit("55"), 0.5);
        assert!((half_unit("1.2416") - 5e-5).abs() < 1e-18);
    }
}
