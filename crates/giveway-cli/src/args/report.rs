//! The arguments of `giveway report`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use giveway_model::Objective;

use super::{Address, Source, seconds};

/// A plan to be reported, with what is proved of it.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
A report is one page of HTML that needs nothing else, to be read on a screen or printed: the map,
what is proved, costs, changes, who is last and why, each robot, batteries, the busiest cells. It is
the report that the page prints, with the same figures. Where the instance has units, metres and seconds stand beside steps.

Without a PLAN the best one is looked for. A plan that is given is compared with the best, for
as long as --time-limit says; one that breaks a rule is reported with the number of violations,
and the exit status is 1. With --changes the plan is judged in the world of each time, and nothing
is proved of how good it is.

Tables are for spreadsheets: UTF-8, commas between cells, and no name in them is taken for a
formula.

Examples
  giveway report warehouse.json -o report.html --date 2026-11-30
  giveway report warehouse.json warehouse.plan.json -o report.html --csv plan.csv --robots robots.csv
  giveway report depot.json adopted.plan.json --changes changes.json > report.html")]
pub(crate) struct Report {
    #[command(flatten)]
    pub(crate) source: Source,
    /// A plan in any format, or a result of solve with a plan in it; or - for standard input
    /// [default: the best one that is found]
    #[arg(value_name = "PLAN")]
    pub(crate) plan: Option<PathBuf>,
    /// What changes while the plan runs
    #[arg(long, value_name = "FILE", requires = "plan")]
    pub(crate) changes: Option<PathBuf>,
    /// The costs by which plans are compared, the most important first [default: the instance's]
    #[arg(long, value_name = "LIST")]
    pub(crate) objective: Option<Objective>,
    /// Search for the best plan and for bounds for so many seconds
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true, default_value = "30")]
    pub(crate) time_limit: f64,
    /// The file to write the report to, .html. Without it, it goes to standard output
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Print a link to the page at this address, which shows the plan there, where the link has at
    /// most 2000 characters [default: where the page is published, if it is]
    #[arg(long, value_name = "URL")]
    pub(crate) address: Option<Address>,
    /// Print this date beside the title, as it is written here [default: none]
    #[arg(long, value_name = "TEXT")]
    pub(crate) date: Option<String>,
    /// Write a table, too: where each robot is at each time, and the level of its battery
    #[arg(long, value_name = "FILE")]
    pub(crate) csv: Option<PathBuf>,
    /// Write a table, too: a line for each robot
    #[arg(long, value_name = "FILE")]
    pub(crate) robots: Option<PathBuf>,
}
