//! The arguments of `giveway compare`.

use std::path::PathBuf;

use clap::Args as ClapArgs;

use super::{First, Reading, Ruling};

/// Two plans of one instance, to be compared.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
The files are two plans and what they are for: a native instance, or a map and a scenario. The
first plan is the one on the left. A robot is
  same       the same cells at the same times
  retimed    the same cells in the same order, at other times
  rerouted   other cells

Examples
  giveway compare warehouse.json before.plan.json after.plan.json
  giveway compare paths.txt result.txt room.map room-random-1.scen --format json")]
pub(crate) struct Compare {
    /// Two plans, and their map, scenario or instance; or - for standard input
    #[arg(required = true, value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) first: First,
    #[command(flatten)]
    pub(crate) reading: Reading,
    #[command(flatten)]
    pub(crate) ruling: Ruling,
}
