//! The `holdup` command: designs, proves and simulates control loops of integrating processes with dead time.

mod args;
mod commands;
mod console;
mod fault;
mod input;
mod require;
mod table;

use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser};
use holdup::record::PARQUET_THREAD;
use holdup::study::output::write_atomically;

use args::Cli;
use console::{Answer, Console, print, tell};
use fault::Fault;
use require::Requirement;

/// A result that does not meet a `--require`.
const UNMET: u8 = 1;
/// Bad input.
const BAD_INPUT: u8 = 2;

fn main() -> ExitCode {
    keep_silent_about_damaged_files();
    let done = match Cli::try_parse() {
        Ok(cli) => run(&cli),
        Err(error) => no_command(&error),
    };
    match done {
        Ok(code) => code,
        Err(Fault::ClosedPipe) => ExitCode::SUCCESS,
        Err(Fault::Input(line)) => {
            tell("error", &line);
            ExitCode::from(BAD_INPUT)
        }
    }
}

/// The decoder of Parquet files panics on some damaged ones, which the library turns into an error: the one line of that
/// error is all there is to say.
fn keep_silent_about_damaged_files() {
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        if std::thread::current().name() != Some(PARQUET_THREAD) {
            usual(panic);
        }
    }));
}

/// Help and version are answers; the rest is bad input.
fn no_command(error: &clap::Error) -> Result<ExitCode, Fault> {
    if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
        return print(&error.to_string()).map(|()| ExitCode::SUCCESS);
    }
    let command = Cli::command();
    let long = |command: &clap::Command| {
        command
            .get_arguments()
            .filter_map(|argument| argument.get_long().map(str::to_owned))
            .collect::<Vec<_>>()
    };
    let given: Vec<String> = std::env::args_os().filter_map(|word| word.into_string().ok()).collect();
    let chosen = command.get_subcommands().find(|sub| given.iter().any(|word| word == sub.get_name()));
    let options = [long(&command), chosen.map(long).unwrap_or_default()].concat();
    Err(Fault::Input(fault::usage(error, &options)))
}

/// Runs a command; its demands are checked before anything is written, so that a misspelt one leaves nothing.
fn run(cli: &Cli) -> Result<ExitCode, Fault> {
    let demands = cli.answer.require.iter().map(|text| Requirement::read(text));
    let demands = demands.collect::<Result<Vec<_>, _>>()?;
    let console = Console::of_process(cli.answer.json);
    let answer = commands::run(&cli.command, console)?;
    let checked = demands.iter().map(|demand| demand.check(&answer.json)).collect::<Result<Vec<_>, _>>()?;
    let Answer { json, text, warnings, files } = answer;
    for (path, bytes) in files {
        write_atomically(&path, &bytes).map_err(|error| Fault::file(&path, "write", &error))?;
    }
    for warning in &warnings {
        tell("warning", warning);
    }
    let unmet: Vec<String> = checked.into_iter().flatten().collect();
    for sentence in &unmet {
        tell("unmet", sentence);
    }
    let code = if unmet.is_empty() { ExitCode::SUCCESS } else { ExitCode::from(UNMET) };
    let shown = if console.json {
        let text =
            serde_json::to_string_pretty(&json).map_err(|error| Fault::input(format!("JSON: {error}")))?;
        print(&(text + "\n"))
    } else {
        print(&text)
    };
    match shown {
        Ok(()) | Err(Fault::ClosedPipe) => Ok(code),
        Err(fault) => Err(fault),
    }
}
