//! The command line, as `giveway help` tells it.

use std::path::PathBuf;
use std::str::FromStr;
use std::sync::LazyLock;

use clap::{Args as ClapArgs, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

mod address;
mod audit;
mod change;
mod compare;
mod convert;
mod explain;
mod freedom;
mod grade;
mod order;
mod picture;
mod price;
mod reading;
mod report;
mod ruling;
mod sizing;
mod solve;
mod sweep;

pub(crate) use address::Address;
pub(crate) use audit::Audit;
pub(crate) use change::Change;
pub(crate) use compare::Compare;
pub(crate) use convert::Convert;
pub(crate) use explain::Explain;
pub(crate) use freedom::Freedom;
pub(crate) use grade::Grade;
pub(crate) use order::Order;
pub(crate) use picture::Picture;
pub(crate) use price::Price;
pub(crate) use reading::Reading;
pub(crate) use report::Report;
pub(crate) use ruling::Ruling;
pub(crate) use sizing::Sizing;
pub(crate) use solve::Solve;
pub(crate) use sweep::{Sweep, Table};

const ABOUT: &str = "Plans for several robots on a grid, proved best";

const LONG_ABOUT: &str = "Plans for several robots on a grid, proved best.

Giveway finds, for every robot, a path to its goal past its waypoints, without \
collisions and within its battery, and proves that no plan is better: by the makespan, \
the sum of costs, the charges, the moves or the waits, in the order you ask for.";

const AFTER_HELP: &str = "An INSTANCE is
  a native file       JSON with the key \"giveway\"
  a .scen             a MovingAI scenario; its .map is the file in the same folder that the
                      scenario names, or given with --map
  other formats       paths.txt, result.txt and those of other planners, with their map beside
                      them or given with --map
  -                   any of them from standard input; a scenario needs --map
The ending of the name says which one it is; without one, how the file begins.

Exit status
  0   the question was answered; \"impossible\" is an answer, and \"feasible\" too
  1   the input is wrong, a check found violations, a certificate was rejected, or a hand-in says
      that a task is solved which is not
  2   the command line is wrong
  3   the budget ran out without any answer (unknown)
  130 Ctrl-C: the best plan so far is told; a second one ends the command at once";

/// The version as `--version` tells it: the same as on the page.
static RELEASE: LazyLock<String> = LazyLock::new(giveway_model::release);

/// The command `giveway`.
#[derive(Debug, Parser)]
#[command(name = "giveway", version = RELEASE.as_str(), about = ABOUT, long_about = LONG_ABOUT, after_help = AFTER_HELP)]
pub(crate) struct Args {
    #[command(subcommand)]
    pub(crate) command: Command,
    #[command(flatten)]
    pub(crate) common: Common,
}

/// What every command takes.
#[derive(Clone, Debug, ClapArgs)]
pub(crate) struct Common {
    /// How results are written: text is for people, json for programs
    #[arg(
        long,
        global = true,
        value_enum,
        default_value_t,
        value_name = "FORMAT"
    )]
    pub(crate) format: Format,
    /// The map of a scenario, if it is not in the same folder under its own name
    #[arg(long, global = true, value_name = "FILE")]
    pub(crate) map: Option<PathBuf>,
    /// Print no progress line and no notes on standard error; what was assumed of the input stays
    /// part of the result
    #[arg(long, short, global = true)]
    pub(crate) quiet: bool,
}

/// How results are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people: the map drawn, tables of times, cells and batteries
    #[default]
    Text,
    /// For programs: one object on standard output
    Json,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Find the best plan and prove that none is better
    Solve(Solve),
    /// List every rule that a plan breaks, and its costs
    Check(Check),
    /// Tell whether a plan of any planner is legal, and how far it is from the best
    Audit(Audit),
    /// Compare two plans of one instance
    Compare(Compare),
    /// Explain why a plan is as it is, or why there is none
    Explain(Explain),
    /// Tell what must be so in every best plan, and what is free to choose
    Freedom(Freedom),
    /// Tell in which order robots pass each cell, and who is pushed if one is late
    Order(Order),
    /// Tell what each rule of the scene's own costs
    Price(Price),
    /// Tell how many robots a floor bears
    Sizing(Sizing),
    /// Find new plans after the world has changed
    Change(Change),
    /// Check exported certificates again, without the solver
    Verify(Verify),
    /// Write instances and plans in another format
    Convert(Convert),
    /// Draw a plan: at a time, or moving
    Picture(Picture),
    /// Write a report of a plan: what is proved, the map, costs, each robot
    Report(Report),
    /// Judge the hand-ins of a class anew
    Grade(Grade),
    /// Do many tasks, such as a benchmark, or a part of them
    Sweep(Sweep),
    /// Make tables and plots of a sweep's results
    Table(Table),
    /// Write a completion script for a shell to standard output
    Completions {
        /// The shell
        shell: Shell,
    },
    /// Write a manual page (roff) to standard output
    Man {
        /// The command that the page is about [default: all of giveway]
        command: Option<String>,
    },
}

/// An instance, and how much of it.
#[derive(Debug, ClapArgs)]
pub(crate) struct Source {
    /// A native file, a .scen, or - for standard input
    #[arg(value_name = "INSTANCE")]
    pub(crate) instance: PathBuf,
    #[command(flatten)]
    pub(crate) first: First,
    #[command(flatten)]
    pub(crate) ruling: Ruling,
    /// One more rule for this call, in words or as JSON: "at most 1 robot in 'aisle 3'" (may be
    /// given several times)
    #[arg(long = "constraint", value_name = "RULE")]
    pub(crate) constraints: Vec<String>,
}

/// How many agents of an instance count.
#[derive(Clone, Copy, Debug, ClapArgs)]
pub(crate) struct First {
    /// Use only the first N robots, of a native file too [default: all of them]
    #[arg(long, value_name = "N", value_parser = whole::<usize>, allow_negative_numbers = true)]
    pub(crate) agents: Option<usize>,
}

#[derive(Debug, ClapArgs)]
#[command(after_help = "\
Every file is compared with its fingerprint, the plan is checked against the rules, every formula
is written again from the instance and compared byte for byte, every proof is checked, and every
search that stands in for a proof is repeated. None of this relies on the solver. The exit status
is 1 if anything differs.

Example
  giveway solve warehouse.json --proof certificate
  giveway verify certificate")]
pub(crate) struct Verify {
    /// The folder that --proof wrote, or the archive that the page saved
    #[arg(value_name = "CERTIFICATE")]
    pub(crate) certificate: PathBuf,
}

#[derive(Debug, ClapArgs)]
#[command(after_help = "\
The exit status is 1 if the plan breaks a rule.

Examples
  giveway check warehouse.json warehouse.plan.json
  giveway check warehouse.json adopted.plan.json --changes changes.json
  giveway solve warehouse.json --format json | giveway check warehouse.json -")]
pub(crate) struct Check {
    #[command(flatten)]
    pub(crate) source: Source,
    /// A plan in any format, or a result of solve with a plan in it; or - for standard input
    #[arg(value_name = "PLAN")]
    pub(crate) plan: PathBuf,
    /// What changes while the plan runs: the plan is checked at each time in the world of that time
    #[arg(long, value_name = "FILE")]
    pub(crate) changes: Option<PathBuf>,
}

/// A number of agents or time steps.
fn whole<T: FromStr>(word: &str) -> Result<T, String> {
    let large = word.len() > 1 && word.bytes().all(|byte| byte.is_ascii_digit());
    let expected = if large {
        "a smaller one"
    } else {
        "a whole number from 0"
    };
    word.parse()
        .map_err(|_| format!("found \"{word}\", expected {expected}"))
}

/// A time limit, in seconds.
fn seconds(word: &str) -> Result<f64, String> {
    word.parse::<f64>()
        .ok()
        .filter(|seconds| seconds.is_finite() && *seconds > 0.0)
        .ok_or_else(|| format!("found \"{word}\", expected a number of seconds above 0"))
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_command_line_is_well_formed() {
        Args::command().debug_assert();
    }

    #[test]
    fn time_limits_are_positive_and_finite() {
        assert_eq!(seconds("0.5"), Ok(0.5));
        for word in ["0", "-1", "inf", "NaN", "1e999", "soon", ""] {
            assert!(seconds(word).is_err(), "{word}");
        }
    }
}
