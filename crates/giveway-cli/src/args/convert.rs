//! The arguments of `giveway convert`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use giveway_formats::Format;

use super::{First, Reading, Ruling};

/// Files to write in another format.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
A scenario uses the map that is given with it and has the name in the scenario; otherwise the map
of --map; otherwise the map in the same folder. A map that no scenario uses becomes an instance
without robots. What the target format cannot hold is listed on standard error. Formats that
write the robots of a plan in a fixed order need the instance of the plan among the files.

Examples
  giveway convert empty-8-8-even-1.scen --agents 4 --to giveway > small.json
  giveway convert warehouse.json --to movingai -o maps
  giveway convert plan.json room.scen --to paths.txt > paths.txt")]
pub(crate) struct Convert {
    /// Instances, plans, scenarios, maps, in any format; or - for standard input
    #[arg(required = true, value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,
    /// The format to write
    #[arg(long, value_parser = formats(), value_name = "FORMAT")]
    pub(crate) to: Format,
    /// The folder to write to; it is created if it is missing. Without it a single file goes to
    /// standard output
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) first: First,
    #[command(flatten)]
    pub(crate) reading: Reading,
    #[command(flatten)]
    pub(crate) ruling: Ruling,
}

/// The format of a name; clap offers the names.
fn formats() -> impl TypedValueParser<Value = Format> {
    let named = |name: String| Format::ALL.into_iter().find(|format| format.name() == name);
    PossibleValuesParser::new(Format::ALL.map(Format::name))
        .map(move |name| named(name).unwrap_or(Format::Giveway))
}
