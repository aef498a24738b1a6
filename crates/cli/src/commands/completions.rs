//! `holdup completions`: the completion script of a shell.

use clap::CommandFactory;
use serde_json::json;

use crate::args::{Cli, CompletionsArgs};
use crate::console::Answer;
use crate::fault::Fault;

/// Writes the script.
pub(crate) fn run(args: &CompletionsArgs) -> Result<Answer, Fault> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "holdup", &mut script);
    let text = String::from_utf8(script).map_err(Fault::input)?;
    Ok(Answer { json: json!({"shell": args.shell.to_string(), "script": text}), text, ..Answer::default() })
}
