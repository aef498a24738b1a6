//! What each command does: one file each.

mod analyse;
mod analyse_actuator;
mod analyse_sampled;
mod compare;
mod completions;
mod convert;
mod export;
mod identify;
mod man;
pub(crate) mod optimise;
mod ranking;
mod record_input;
mod region;
mod relay;
mod reproduce;
mod retune;
pub(crate) mod robust;
mod rule_page;
mod rules;
mod simulate;
mod simulate_sampled;
mod survey;
mod tune;
mod view;

use crate::args::Command;
use crate::console::{Answer, Console};
use crate::fault::Fault;

/// Runs a command.
pub(crate) fn run(command: &Command, console: Console) -> Result<Answer, Fault> {
    match command {
        Command::Rules(args) => rules::run(args, console),
        Command::Tune(args) => tune::run(args, console),
        Command::Analyse(args) => analyse::run(args, console),
        Command::Region(args) => region::run(args, console),
        Command::Survey(args) => survey::run(args, console),
        Command::Simulate(args) => simulate::run(args, console),
        Command::Compare(args) => compare::run(args, console),
        Command::Optimise(args) => optimise::run(args, console),
        Command::Robust(args) => robust::run(args, console),
        Command::Reproduce(args) => reproduce::run(args, console),
        Command::Convert(args) => convert::run(args, console),
        Command::Export(args) => export::run(args, console),
        Command::Relay(args) => relay::run(args, console),
        Command::Identify(args) => identify::run(args, console),
        Command::Completions(args) => completions::run(args),
        Command::Man => man::run(),
    }
}
