//! The arguments of `giveway convert`.

use std::path::PathBuf;

use clap::{Args as ClapArgs, ValueEnum};

use super::First;

/// Files to write in another format.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
A scenario uses the map that is given with it and has the name in the scenario; otherwise the map
of --map; otherwise the map in the same folder. A map that no scenario uses becomes an instance
without robots. What the target format cannot hold is listed on standard error.

Examples
  giveway convert empty-8-8-even-1.scen --agents 4 --to giveway > small.json
  giveway convert warehouse.json --to movingai -o maps")]
pub(crate) struct Convert {
    /// Native instances or plans, scenarios, maps; or - for standard input
    #[arg(required = true, value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,
    /// The format to write
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub(crate) to: Target,
    /// The folder to write to; it is created if it is missing. Without it a single file goes to
    /// standard output
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) first: First,
}

/// What `convert` writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Target {
    /// The project's own JSON
    Giveway,
    /// A MovingAI .map and .scen
    #[value(name = "movingai")]
    MovingAi,
}
