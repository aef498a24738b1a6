//! What may be wrong with a text that describes a process, a controller or a study, said in one line.

use std::borrow::Cow;
use std::fmt;

use super::error::ModelError;

/// One thing wrong with a text: where it stands and what is allowed there.
///
/// Its `Display` is one line, whatever the text contained.
///
/// ```
/// use holdup::model::notation::read_process;
/// let error = read_process("K=0.05,d=-6").unwrap_err();
/// assert_eq!(error.to_string(), "d is -6: must be a finite number greater than 0");
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct TextError {
    /// Line of a file, counted from 1; `None` in a compact string.
    pub line: Option<usize>,
    /// The key concerned, as it is written there; empty where the whole text is meant.
    pub key: String,
    /// What is wrong with it.
    pub problem: Problem,
}

/// What may be wrong with one key of a text.
#[derive(Debug, Clone, PartialEq)]
pub enum Problem {
    /// The value is not one of those allowed.
    Value {
        /// The value, as it was written.
        value: String,
        /// What is allowed, in words.
        allowed: Cow<'static, str>,
    },
    /// No key of this name exists here.
    Unknown {
        /// The existing key that looks most like it.
        nearest: Option<String>,
        /// All keys that exist here.
        allowed: Vec<String>,
    },
    /// The key, or a name that must be unique, is there a second time.
    Twice,
    /// The key is required and absent.
    Missing {
        /// What it would have to be, in words.
        allowed: &'static str,
    },
    /// The key contradicts another one, or needs another one.
    Conflict {
        /// Why it cannot stand.
        reason: Cow<'static, str>,
    },
    /// The text does not follow the grammar.
    Syntax {
        /// What is wrong, in words.
        message: String,
    },
}

impl TextError {
    /// An error at this key, in a text without lines.
    #[must_use]
    pub fn at(key: impl Into<String>, problem: Problem) -> Self {
        Self { line: None, key: key.into(), problem }
    }

    /// A value that is not allowed.
    pub(crate) fn value(
        key: impl Into<String>,
        value: impl Into<String>,
        allowed: impl Into<Cow<'static, str>>,
    ) -> Self {
        Self::at(key, Problem::Value { value: value.into(), allowed: allowed.into() })
    }

    /// The refusal of a constructor, under the name that the key has in this text.
    pub(crate) fn from_model(error: &ModelError, key: impl Fn(&'static str) -> &'static str) -> Self {
        match *error {
            ModelError::OutOfRange { name, value, allowed } => {
                Self::value(key(name), value.to_string(), allowed)
            }
            ModelError::Conflict { name, reason } => {
                Self::at(key(name), Problem::Conflict { reason: reason.into() })
            }
        }
    }

    /// A key that does not exist among `allowed`.
    pub(crate) fn unknown(key: &str, allowed: &[&str]) -> Self {
        let nearest = nearest(key, allowed.iter().copied()).map(str::to_owned);
        let allowed = allowed.iter().map(|&a| a.to_owned()).collect();
        Self::at(key, Problem::Unknown { nearest, allowed })
    }
}

impl fmt::Display for TextError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(line) = self.line {
            write!(out, "line {line}: ")?;
        }
        let key = one_line(&self.key);
        match &self.problem {
            Problem::Value { value, allowed } => {
                let value = one_line(value);
                let value = if value.is_empty() { "empty" } else { &value };
                write!(out, "{key} is {value}: must be {allowed}")
            }
            Problem::Unknown { nearest, allowed } => {
                write!(out, "unknown key '{key}'")?;
                if let Some(nearest) = nearest {
                    write!(out, ": did you mean '{nearest}'?")?;
                }
                write!(out, " (allowed: {})", allowed.join(", "))
            }
            Problem::Twice => write!(out, "{key} is given twice: must be given once"),
            Problem::Missing { allowed } => write!(out, "{key} is missing: must be {allowed}"),
            Problem::Conflict { reason } => write!(out, "{key}: {reason}"),
            Problem::Syntax { message } if key.is_empty() => out.write_str(&escaped(message)),
            Problem::Syntax { message } => write!(out, "'{key}' {}", escaped(message)),
        }
    }
}

impl std::error::Error for TextError {}

/// The name among `names` that looks most like `given`, where one is near enough to be meant.
///
/// ```
/// use holdup::model::text::nearest;
/// assert_eq!(nearest("dead_tine_s", ["process_gain", "dead_time_s"]), Some("dead_time_s"));
/// assert_eq!(nearest("zzz", ["process_gain", "dead_time_s"]), None);
/// ```
#[must_use]
pub fn nearest<'n>(given: &str, names: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    let plain = |name: &str| name.to_lowercase().replace(['_', ' '], "-");
    let wanted = plain(given);
    names
        .into_iter()
        .map(|name| {
            let candidate = plain(name);
            let leaf = candidate.rsplit('.').next().unwrap_or(&candidate);
            let score = |text: &str| {
                let likeness = strsim::jaro_winkler(&wanted, text);
                if wanted.len() >= 3 && (text.starts_with(&wanted) || wanted.starts_with(text)) {
                    likeness.max(0.9)
                } else {
                    likeness
                }
            };
            (score(&candidate).max(score(leaf)), name)
        })
        .filter(|(likeness, _)| *likeness >= 0.6)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, name)| name)
}

/// `text` on one line of bounded length: control characters escaped, a long middle left out.
#[must_use]
pub fn one_line(text: &str) -> String {
    const KEPT: usize = 60;
    match text.char_indices().nth(KEPT) {
        Some((end, _)) => escaped(&text[..end]) + "…",
        None => escaped(text),
    }
}

/// `text` on one line: control characters escaped.
fn escaped(text: &str) -> String {
    let mut line = String::with_capacity(text.len());
    for character in text.chars() {
        if character.is_control() {
            line.extend(character.escape_default());
        } else {
            line.push(character);
        }
    }
    line
}
