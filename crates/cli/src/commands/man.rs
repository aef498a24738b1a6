//! `holdup man`: the manual page.

use clap::CommandFactory;
use serde_json::json;

use crate::args::Cli;
use crate::console::Answer;
use crate::fault::Fault;

/// Writes the page: the program, then each command.
pub(crate) fn run() -> Result<Answer, Fault> {
    let mut page = Vec::new();
    let unwritten = |error: std::io::Error| Fault::input(format!("manual page: {error}"));
    let mut command = Cli::command();
    command.build();
    clap_mangen::Man::new(command.clone()).render(&mut page).map_err(unwritten)?;
    for sub in command.get_subcommands().filter(|sub| sub.get_name() != "help") {
        let title = format!(".SH \"COMMAND {}\"\n", sub.get_name().to_uppercase());
        page.extend_from_slice(title.as_bytes());
        let man = clap_mangen::Man::new(sub.clone());
        man.render_synopsis_section(&mut page).map_err(unwritten)?;
        man.render_description_section(&mut page).map_err(unwritten)?;
        man.render_options_section(&mut page).map_err(unwritten)?;
    }
    let text = String::from_utf8(page).map_err(Fault::input)?;
    Ok(Answer { json: json!({"page": text}), text, ..Answer::default() })
}
