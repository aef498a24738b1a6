//! One table of a TOML text, read key by key, so that every fault is named with its line, key and value.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::ModelError;
use super::text::{Problem, TextError};

/// A whole TOML text.
pub(crate) struct Document<'t> {
    text: &'t str,
    root: DeTable<'t>,
}

impl<'t> Document<'t> {
    /// Parses the text; the grammar's faults become a [`TextError`] with their line.
    pub(crate) fn parse(text: &'t str) -> Result<Self, TextError> {
        match DeTable::parse(text) {
            Ok(root) => Ok(Self { text, root: root.into_inner() }),
            Err(error) => {
                let line = error.span().map(|span| line_of(text, span.start));
                let message = format!("not valid TOML: {}", error.message());
                Err(TextError { line, key: String::new(), problem: Problem::Syntax { message } })
            }
        }
    }

    /// The top table.
    pub(crate) fn root(&self) -> Section<'_> {
        Section::new(self.text, String::new(), 1, &self.root)
    }
}

/// A table and its place.
pub(crate) struct Section<'d> {
    text: &'d str,
    path: String,
    line: usize,
    table: &'d DeTable<'d>,
}

impl<'d> Section<'d> {
    fn new(text: &'d str, path: String, line: usize, table: &'d DeTable<'d>) -> Self {
        Self { text, path, line, table }
    }

    /// Line where the table begins.
    pub(crate) fn line(&self) -> usize {
        self.line
    }

    /// Whether the key is there, of whatever type.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.find(key).is_some()
    }

    /// A number.
    pub(crate) fn number(&self, key: &str) -> Result<Option<f64>, TextError> {
        self.typed(key, "a finite number", number)
    }

    /// A number that must be there.
    pub(crate) fn require_number(&self, key: &str) -> Result<f64, TextError> {
        self.number(key)?.ok_or_else(|| self.missing(key, "a finite number"))
    }

    /// A text of at least one character.
    pub(crate) fn text(&self, key: &str) -> Result<Option<String>, TextError> {
        self.typed(key, "a text that is not empty", |value| {
            value.as_str().filter(|text| !text.trim().is_empty()).map(str::to_owned)
        })
    }

    /// A list of texts.
    pub(crate) fn texts(&self, key: &str) -> Result<Option<Vec<String>>, TextError> {
        self.typed(key, "a list of texts such as [\"step\"]", |value| {
            let items = value.as_array()?.iter();
            items.map(|item| item.get_ref().as_str().map(str::to_owned)).collect()
        })
    }

    /// A list of numbers.
    pub(crate) fn numbers(&self, key: &str) -> Result<Option<Vec<f64>>, TextError> {
        self.typed(key, "a list of finite numbers such as [40.0, 50.0]", |value| {
            value.as_array()?.iter().map(|item| number(item.get_ref())).collect()
        })
    }

    /// A list of pairs of numbers.
    pub(crate) fn pairs(&self, key: &str) -> Result<Option<Vec<(f64, f64)>>, TextError> {
        self.typed(key, "a list of [time, value] such as [[0.0, 1.0], [100.0, 3.0]]", |value| {
            let items = value.as_array()?.iter();
            items
                .map(|item| match item.get_ref().as_array()?.iter().as_slice() {
                    [time, value] => Some((number(time.get_ref())?, number(value.get_ref())?)),
                    _ => None,
                })
                .collect()
        })
    }

    /// A list of three numbers each: where, until where, how much.
    pub(crate) fn triples(&self, key: &str) -> Result<Option<Vec<[f64; 3]>>, TextError> {
        self.typed(key, "a list of [start, end, change] such as [[50.0, 150.0, 2.0]]", |value| {
            let items = value.as_array()?.iter();
            items
                .map(|item| {
                    let numbers: Option<Vec<f64>> =
                        item.get_ref().as_array()?.iter().map(|part| number(part.get_ref())).collect();
                    numbers?.try_into().ok()
                })
                .collect()
        })
    }

    /// The names and numbers of a table whose keys are free.
    pub(crate) fn named_numbers(&self, key: &str) -> Result<Option<Vec<(String, f64)>>, TextError> {
        let Some(section) = self.section(key)? else { return Ok(None) };
        let numbers = section.table.iter().map(|(name, value)| match number(value.get_ref()) {
            Some(number) => Ok((name.get_ref().to_string(), number)),
            None => Err(section.fault(name.get_ref(), value, "a finite number")),
        });
        numbers.collect::<Result<_, _>>().map(Some)
    }

    /// A table within this one.
    pub(crate) fn section(&self, key: &str) -> Result<Option<Section<'d>>, TextError> {
        let Some((line, value)) = self.find(key) else { return Ok(None) };
        match value.get_ref() {
            DeValue::Table(table) => Ok(Some(Section::new(self.text, self.full(key), line, table))),
            _ => Err(self.fault(key, value, "a table")),
        }
    }

    /// A table that must be there.
    pub(crate) fn require_section(&self, key: &str) -> Result<Section<'d>, TextError> {
        self.section(key)?.ok_or_else(|| self.missing(key, "a table"))
    }

    /// The tables of an array of tables.
    pub(crate) fn sections(&self, key: &str) -> Result<Vec<Section<'d>>, TextError> {
        let Some((_, value)) = self.find(key) else { return Ok(Vec::new()) };
        let DeValue::Array(items) = value.get_ref() else {
            return Err(self.fault(key, value, "tables, each headed [[…]]"));
        };
        items
            .iter()
            .map(|item| match item.get_ref() {
                DeValue::Table(table) => {
                    Ok(Section::new(self.text, self.full(key), line_of(self.text, item.span().start), table))
                }
                _ => Err(self.fault(key, item, "tables, each headed [[…]]")),
            })
            .collect()
    }

    /// Refuses every key but these, naming the first stranger of the file.
    pub(crate) fn only(&self, keys: &[&str]) -> Result<(), TextError> {
        let strangers = self.table.keys().filter(|key| !keys.contains(&key.get_ref().as_ref()));
        let Some(stranger) = strangers.min_by_key(|key| key.span().start) else { return Ok(()) };
        let error = TextError::unknown(stranger.get_ref(), keys);
        let line = line_of(self.text, stranger.span().start);
        Err(TextError { line: Some(line), key: self.full(&error.key), ..error })
    }

    /// An error of this table that concerns `key`; its line is the key's, or the table's where it is absent.
    pub(crate) fn error(&self, key: &str, problem: Problem) -> TextError {
        let line = self.find(key).map_or(self.line, |(line, _)| line);
        TextError { line: Some(line), key: self.full(key), problem }
    }

    /// A value that is not allowed.
    pub(crate) fn refuse(
        &self,
        key: &str,
        value: &str,
        allowed: impl Into<std::borrow::Cow<'static, str>>,
    ) -> TextError {
        self.error(key, Problem::Value { value: value.to_owned(), allowed: allowed.into() })
    }

    /// The refusal of a constructor.
    pub(crate) fn model_error(
        &self,
        error: &ModelError,
        key: impl Fn(&'static str) -> &'static str,
    ) -> TextError {
        let plain = TextError::from_model(error, key);
        self.error(&plain.key, plain.problem)
    }

    /// A required key is absent.
    pub(crate) fn missing(&self, key: &str, allowed: &'static str) -> TextError {
        self.error(key, Problem::Missing { allowed })
    }

    fn typed<T>(
        &self,
        key: &str,
        allowed: &'static str,
        read: impl Fn(&DeValue<'d>) -> Option<T>,
    ) -> Result<Option<T>, TextError> {
        let Some((_, value)) = self.find(key) else { return Ok(None) };
        read(value.get_ref()).map(Some).ok_or_else(|| self.fault(key, value, allowed))
    }

    fn find(&self, key: &str) -> Option<(usize, &'d Spanned<DeValue<'d>>)> {
        // `output_filter.a1_s` is looked for as `output_filter`: a table within has its own section.
        let top = key.split('.').next().unwrap_or(key);
        let (name, value) = self.table.get_key_value(top)?;
        Some((line_of(self.text, name.span().start), value))
    }

    fn fault(&self, key: &str, value: &Spanned<DeValue<'_>>, allowed: &'static str) -> TextError {
        let span = value.span();
        let written = self.text.get(span.clone()).unwrap_or_default();
        TextError {
            line: Some(line_of(self.text, span.start)),
            ..TextError::value(self.full(key), written, allowed)
        }
    }

    fn full(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) }
    }
}

/// The line of a byte offset, counted from 1.
fn line_of(text: &str, offset: usize) -> usize {
    1 + text.as_bytes().iter().take(offset).filter(|&&byte| byte == b'\n').count()
}

/// A finite number, written as a float or as an integer.
fn number(value: &DeValue<'_>) -> Option<f64> {
    let digits = match value {
        DeValue::Float(float) => float.as_str().to_owned(),
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().to_owned(),
        _ => return None,
    };
    super::quantity::read_number("", &digits.replace('_', "")).ok()
}
