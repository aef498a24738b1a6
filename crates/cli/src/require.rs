//! `--require 'gain_margin>=2'`: a demand on a numeric field of the result.

use holdup::model::quantity::read_number;
use holdup::model::text::{nearest, one_line};
use serde_json::Value;

use crate::fault::Fault;

/// Parts of a result that hold what was asked for or what is possible: a bare name means what was achieved.
const ASIDE: [&str; 8] = [
    "designed",
    "bounds",
    "percent_of_best",
    "specification",
    "published",
    "loops",
    "alternatives",
    "sampled",
];

/// One demand.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Requirement {
    text: String,
    name: String,
    comparison: Comparison,
    value: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Comparison {
    AtLeast,
    AtMost,
    Above,
    Below,
    Equal,
}

/// The signs, the longer before those they begin with.
const SIGNS: [(&str, Comparison); 6] = [
    (">=", Comparison::AtLeast),
    ("<=", Comparison::AtMost),
    ("==", Comparison::Equal),
    (">", Comparison::Above),
    ("<", Comparison::Below),
    ("=", Comparison::Equal),
];

impl Requirement {
    /// Reads a demand.
    pub(crate) fn read(text: &str) -> Result<Self, Fault> {
        let refused = |what: &str| {
            let given = one_line(text);
            Fault::option(
                "--require",
                format!("'{given}' {what}: must be such as 'gain_margin>=2', with >=, <=, >, < or =="),
            )
        };
        let start = text.find(['>', '<', '=']).ok_or_else(|| refused("has no comparison"))?;
        let (name, rest) = text.split_at(start);
        let (sign, comparison) = SIGNS
            .into_iter()
            .find(|(sign, _)| rest.starts_with(sign))
            .ok_or_else(|| refused("has no comparison"))?;
        let value = read_number("value", rest[sign.len()..].trim())
            .map_err(|_| refused("compares with no finite number"))?;
        let name = name.trim();
        if name.is_empty() {
            return Err(refused("names no field"));
        }
        Ok(Self { text: text.to_owned(), name: name.to_owned(), comparison, value })
    }

    /// What is not met, in one sentence; `None` where it is met.
    pub(crate) fn check(&self, result: &Value) -> Result<Option<String>, Fault> {
        let mut fields = Vec::new();
        leaves(result, &mut Vec::new(), &mut fields);
        let (path, value) = self.find(&fields)?;
        let Some(value) = value else {
            return Ok(Some(format!("--require '{}' is not met: {path} has no value", self.text)));
        };
        let met = match self.comparison {
            Comparison::AtLeast => value >= self.value,
            Comparison::AtMost => value <= self.value,
            Comparison::Above => value > self.value,
            Comparison::Below => value < self.value,
            Comparison::Equal => value == self.value,
        };
        Ok((!met).then(|| format!("--require '{}' is not met: {path} is {value}", self.text)))
    }

    /// The field that is meant: the one at this path, else the one of this name that lies least deep, among
    /// what was achieved first.
    fn find(&self, fields: &[Field]) -> Result<(String, Option<f64>), Fault> {
        let wanted: Vec<&str> = self.name.split('.').collect();
        let ends = |field: &&Field| {
            let start = field.path.len().checked_sub(wanted.len());
            start.is_some_and(|start| {
                field.path[start..].iter().zip(&wanted).all(|(step, name)| step.is(name))
            })
        };
        let whole = fields.iter().find(|field| field.path.len() == wanted.len() && ends(field));
        if let Some(field) = whole {
            return Ok((field.name(), field.value));
        }
        let matching: Vec<&Field> = fields.iter().filter(ends).collect();
        let achieved: Vec<&Field> = matching.iter().copied().filter(|field| !field.is_aside()).collect();
        let candidates = if achieved.is_empty() { matching } else { achieved };
        let Some(least) = candidates.iter().map(|field| field.path.len()).min() else {
            return Err(self.unknown(fields));
        };
        let mut candidates = candidates.into_iter().filter(|field| field.path.len() == least);
        match (candidates.next(), candidates.next()) {
            (Some(only), None) => Ok((only.name(), only.value)),
            (Some(first), Some(second)) => Err(Fault::option(
                "--require",
                format!(
                    "'{}' names several fields: must be one of {}, {}, …",
                    one_line(&self.name),
                    first.name(),
                    second.name()
                ),
            )),
            (None, _) => Err(self.unknown(fields)),
        }
    }

    fn unknown(&self, fields: &[Field]) -> Fault {
        let mut names: Vec<&str> =
            fields.iter().filter_map(|field| field.path.last()).map(|step| step.key.as_str()).collect();
        names.sort_unstable();
        names.dedup();
        let last = self.name.rsplit('.').next().unwrap_or_default();
        let hint = match nearest(last, names.iter().copied()) {
            Some(found) => format!(": did you mean '{found}'?"),
            None => format!(": must be one of {}", names.join(", ")),
        };
        Fault::option(
            "--require",
            format!("the result has no numeric field '{}'{hint}", one_line(&self.name)),
        )
    }
}

/// A step of a path: a key, or an index with the name that the item bears.
#[derive(Debug, Clone)]
struct Step {
    key: String,
    title: Option<String>,
}

impl Step {
    fn is(&self, name: &str) -> bool {
        self.key == name || self.title.as_deref() == Some(name)
    }
}

/// A numeric field of a result; its value is absent where it is null.
#[derive(Debug)]
struct Field {
    path: Vec<Step>,
    value: Option<f64>,
}

impl Field {
    fn name(&self) -> String {
        let steps = self.path.iter().map(|step| step.title.as_deref().unwrap_or(&step.key));
        steps.collect::<Vec<_>>().join(".")
    }

    fn is_aside(&self) -> bool {
        self.path.iter().any(|step| ASIDE.contains(&step.key.as_str()))
    }
}

fn leaves(value: &Value, path: &mut Vec<Step>, fields: &mut Vec<Field>) {
    let mut enter = |key: String, title: Option<String>, value: &Value| {
        path.push(Step { key, title });
        leaves(value, path, fields);
        path.pop();
    };
    match value {
        Value::Object(map) => map.iter().for_each(|(key, value)| enter(key.clone(), None, value)),
        Value::Array(items) => items.iter().enumerate().for_each(|(index, item)| {
            let title = ["name", "controller", "rule", "id"].iter().find_map(|key| item.get(key)?.as_str());
            enter(index.to_string(), title.map(str::to_owned), item);
        }),
        Value::Number(number) => fields.push(Field { path: path.clone(), value: number.as_f64() }),
        Value::Bool(truth) => {
            fields.push(Field { path: path.clone(), value: Some(f64::from(u8::from(*truth))) });
        }
        Value::Null => fields.push(Field { path: path.clone(), value: None }),
        Value::String(_) => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn check(text: &str, result: &Value) -> Result<bool, String> {
        let read = Requirement::read(text).and_then(|requirement| requirement.check(result));
        match read {
            Ok(unmet) => Ok(unmet.is_none()),
            Err(Fault::Input(line)) => Err(line),
            Err(Fault::ClosedPipe) => Err(String::new()),
        }
    }

    #[test]
    fn a_bare_name_means_what_was_achieved_and_null_meets_nothing() {
        let result = json!({"specification": {"gain_margin": 2.0}, "achieved": {"gain_margin": 3.8, "delay_margin_s": null}});
        assert_eq!(check("gain_margin>=3", &result), Ok(true));
        assert_eq!(check("specification.gain_margin >= 3", &result), Ok(false));
        assert_eq!(check("delay_margin_s>0", &result), Ok(false));
        assert_eq!(check("delay_margin_s<0", &result), Ok(false));
    }

    #[test]
    fn items_are_found_by_index_and_by_name() {
        let result = json!({"controllers": [{"name": "A", "achieved": {"gain_margin": 2}}, {"name": "B", "achieved": {"gain_margin": 4}}]});
        assert_eq!(check("controllers.0.achieved.gain_margin==2", &result), Ok(true));
        assert_eq!(check("B.achieved.gain_margin>3", &result), Ok(true));
        assert!(check("gain_margin>3", &result).unwrap_err().contains("several fields"));
    }

    #[test]
    fn faults_name_the_demand() {
        let result = json!({"margins": {"gain_margin": 2.0}});
        assert!(check("gain_margn>=2", &result).unwrap_err().contains("did you mean 'gain_margin'?"));
        for text in ["gain_margin", ">=2", "gain_margin>=nan", "gain_margin>=", "gain_margin>==2"] {
            assert!(check(text, &result).unwrap_err().starts_with("--require: "), "{text}");
        }
    }
}
