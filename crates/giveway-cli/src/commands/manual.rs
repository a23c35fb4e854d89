//! `giveway completions` and `giveway man`: both come from the command line's
//! own description, and so never differ from it.

use clap::CommandFactory;
use clap_complete::Shell;

use crate::{args::Args, exit::Exit, failure::Failure, output::stream};

/// Writes the completion script of a shell.
pub(crate) fn completions(shell: Shell) -> Result<Exit, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Args::command(), "giveway", &mut script);
    stream::file(&script)?;
    Ok(Exit::Answered)
}

/// Writes the manual page of a command, or of all of giveway.
pub(crate) fn man(command: Option<&str>) -> Result<Exit, Failure> {
    let mut all = Args::command();
    all.build();
    let page = match command {
        None => all,
        Some(name) => all.find_subcommand(name).cloned().ok_or_else(|| {
            Failure::Usage(format!("found \"{name}\", expected a command of giveway"))
        })?,
    };
    let mut text = Vec::new();
    clap_mangen::Man::new(page)
        .source(format!("giveway {}", giveway_model::release()))
        .render(&mut text)
        .map_err(|error| Failure::output("standard output", error))?;
    stream::file(&text)?;
    Ok(Exit::Answered)
}
