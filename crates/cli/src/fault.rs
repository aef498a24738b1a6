//! Why a command gives no result: always one line.

use std::fmt::Display;
use std::path::Path;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use holdup::model::text::nearest;

/// Why a command gives no result.
#[derive(Debug)]
pub(crate) enum Fault {
    /// Bad input: the line to show. Exit status 2.
    Input(String),
    /// Whoever reads standard output has gone: not a fault of anyone. Exit status 0.
    ClosedPipe,
}

impl Fault {
    /// Bad input.
    pub(crate) fn input(message: impl Display) -> Self {
        Self::Input(message.to_string())
    }

    /// Bad input in an option.
    pub(crate) fn option(option: &str, message: impl Display) -> Self {
        Self::Input(format!("{option}: {message}"))
    }

    /// A file that cannot be read or written.
    pub(crate) fn file(path: &Path, doing: &str, error: &std::io::Error) -> Self {
        Self::Input(format!("{}: cannot {doing}: {}", path.display(), reason(error)))
    }

    /// A fault in a text file.
    pub(crate) fn text(path: &Path, error: &holdup::model::TextError) -> Self {
        match error.line {
            Some(line) => {
                let bare = holdup::model::TextError { line: None, ..error.clone() };
                Self::Input(format!("{}:{line}: {bare}", path.display()))
            }
            None => Self::Input(format!("{}: {error}", path.display())),
        }
    }
}

/// What the operating system says, without its error number.
fn reason(error: &std::io::Error) -> String {
    let text = error.to_string();
    text.split(" (os error").next().unwrap_or(&text).to_lowercase()
}

/// What clap found wrong with the command line, on one line.
pub(crate) fn usage(error: &clap::Error, options: &[String]) -> String {
    let get = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.clone()),
        Some(ContextValue::Strings(texts)) => Some(texts.join(", ")),
        _ => None,
    };
    let argument = get(ContextKind::InvalidArg).unwrap_or_default();
    let name = argument.split(' ').next().unwrap_or_default().to_owned();
    let suggested = |kind| get(kind).map_or_else(String::new, |text| format!(": did you mean '{text}'?"));
    match error.kind() {
        ErrorKind::UnknownArgument if name.starts_with('-') => {
            let near = get(ContextKind::SuggestedArg).or_else(|| {
                let bare = name.trim_start_matches('-');
                nearest(bare, options.iter().map(String::as_str)).map(|found| format!("--{found}"))
            });
            let hint = near.map_or_else(
                || "; see --help for the options".to_owned(),
                |near| format!(": did you mean '{}'?", near.split(' ').next().unwrap_or(&near)),
            );
            format!("unknown option '{name}'{hint}")
        }
        ErrorKind::UnknownArgument => format!("'{argument}' is one argument too many; see --help"),
        ErrorKind::InvalidSubcommand => {
            let given = get(ContextKind::InvalidSubcommand).unwrap_or_default();
            let near = suggested(ContextKind::SuggestedSubcommand);
            let near = if near.is_empty() { "; see 'holdup --help'".to_owned() } else { near };
            format!("unknown command '{given}'{near}")
        }
        ErrorKind::MissingSubcommand | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            "no command is given: must be one of those that 'holdup --help' lists".to_owned()
        }
        ErrorKind::MissingRequiredArgument => format!("{argument} is missing; see --help"),
        ErrorKind::ArgumentConflict => {
            let other = get(ContextKind::PriorArg).unwrap_or_default();
            if other == argument || other.is_empty() {
                format!("{name} is given twice: must be given once")
            } else {
                format!("{name} and {} exclude each other", other.split(' ').next().unwrap_or_default())
            }
        }
        ErrorKind::InvalidValue if get(ContextKind::InvalidValue).is_none_or(|value| value.is_empty()) => {
            format!("{name} needs a value: {argument}")
        }
        ErrorKind::InvalidValue => {
            let value = get(ContextKind::InvalidValue).unwrap_or_default();
            let valid = get(ContextKind::ValidValue).unwrap_or_default();
            let near = suggested(ContextKind::SuggestedValue);
            format!("{name} is '{value}'{near}: must be one of {valid}")
        }
        _ => {
            let text = error.to_string();
            let first = text.lines().next().unwrap_or("the command line is not understood");
            first.trim_start_matches("error: ").to_owned()
        }
    }
}
