//! `holdup reproduce`: every printed number of a paper against the computed one.

use crate::args::ReproduceArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;

/// Reproduces the paper.
pub(crate) fn run(args: &ReproduceArgs, _: Console) -> Result<Answer, Fault> {
    Err(Fault::input(format!("PAPER is {}: not built yet", args.paper)))
}
