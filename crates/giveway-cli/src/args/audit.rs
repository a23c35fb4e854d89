//! The arguments of `giveway audit`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use giveway_model::Objective;

use super::{Address, First, Reading, Ruling, seconds, whole};

/// A plan to audit, with the files that it needs.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
The files are a plan and what it is for: a native instance, or a map and a scenario. They are told
apart by what they hold. A map that is missing is looked for beside the plan, by its name. Without
a scenario the robots start and end where their paths do.

The answer is one of
  the best          the plan is legal, and no plan is better: proved
  at most 1.2 %     it is legal, and no further above the best; a better plan is shown if one is
                    found
  illegal           every rule that it breaks, and what a legal plan costs (exit status 1)
  legal             the time ran out before anything was known of how good it is (exit status 3)

With --jsonl every plan among the files is audited with the maps, scenarios and instances among
them, and answered in one line; a file that cannot be read gets a line with its error, and the exit
status is 1 in the end.

Examples
  giveway audit paths.txt random-32-32-20.map random-32-32-20-random-1.scen
  giveway audit result.txt --map maze.map --objective makespan --time-limit 60
  giveway audit plan.json warehouse.json --report report.html
  giveway audit plans/*.txt random-32-32-20.map --jsonl > audits.jsonl")]
pub(crate) struct Audit {
    /// A plan, and its map, scenario or instance; or - for standard input
    #[arg(required = true, value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,
    /// The costs by which plans are compared, the most important first [default: the instance's
    /// own; of a plan for a map sum-of-costs,makespan]
    #[arg(long, value_name = "LIST")]
    pub(crate) objective: Option<Objective>,
    #[command(flatten)]
    pub(crate) first: First,
    /// Compare only with plans of at most this makespan [default: the longest time that a robot
    /// needs alone + 4 (width + height) + 10]
    #[arg(long, value_name = "N", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) within: Option<u32>,
    /// Search for better plans and bounds for so many seconds, for each plan
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true, default_value = "10")]
    pub(crate) time_limit: f64,
    #[command(flatten)]
    pub(crate) reading: Reading,
    #[command(flatten)]
    pub(crate) ruling: Ruling,
    /// Write a report, too: a page (.html), a text (.md) or the JSON object (.json)
    #[arg(long, value_name = "FILE", conflicts_with = "jsonl")]
    pub(crate) report: Option<PathBuf>,
    /// Link the report to the page at this address, which shows the plan there [default: where the
    /// page is published, if it is]
    #[arg(long, value_name = "URL", requires = "report")]
    pub(crate) address: Option<Address>,
    /// Audit every plan among the files, and answer in one line of JSON each
    #[arg(long)]
    pub(crate) jsonl: bool,
}
