//! Where answers go: standard output, whole files, standard error.

use std::io::{self, IsTerminal, Write};
use std::path::PathBuf;

use serde_json::Value;

use crate::fault::Fault;

/// How wide a table may be where standard output is no terminal.
const PLAIN_WIDTH: usize = 80;

/// Who reads the answer.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Console {
    /// A program reads JSON.
    pub(crate) json: bool,
    /// Width of the terminal, in characters.
    pub(crate) width: usize,
    /// Whether colours may be used.
    pub(crate) colour: bool,
}

impl Console {
    /// The console that this process writes to.
    pub(crate) fn of_process(json: bool) -> Self {
        let terminal = io::stdout().is_terminal();
        let width =
            terminal.then(terminal_size::terminal_size).flatten().map(|(width, _)| usize::from(width.0));
        let colour = terminal && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
        Self { json, width: width.unwrap_or(PLAIN_WIDTH).clamp(40, 200), colour }
    }
}

/// What a command answers.
#[derive(Debug, Default)]
pub(crate) struct Answer {
    /// For programs.
    pub(crate) json: Value,
    /// For people; empty where a program reads.
    pub(crate) text: String,
    /// What must be known beside the result.
    pub(crate) warnings: Vec<String>,
    /// Files to write, whole.
    pub(crate) files: Vec<(PathBuf, Vec<u8>)>,
}

/// Writes a text to standard output.
pub(crate) fn print(text: &str) -> Result<(), Fault> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => Fault::ClosedPipe,
        _ => Fault::input(format!("cannot write to standard output: {error}")),
    })
}

/// Writes one line to standard error; where that is closed, too, there is nobody to tell.
pub(crate) fn tell(kind: &str, message: &str) {
    let line = message.replace(['\n', '\r'], " ");
    let _ = writeln!(io::stderr().lock(), "{kind}: {line}");
}
