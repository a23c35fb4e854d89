//! The command line, as `giveway help` tells it.

use std::path::PathBuf;
use std::str::FromStr;
use std::sync::LazyLock;

use clap::{Args as ClapArgs, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use giveway_model::{Cell, Objective};

mod change;

pub(crate) use change::Change;

const ABOUT: &str = "Plans for several robots on a grid, proved best";

const LONG_ABOUT: &str = "Plans for several robots on a grid, proved best.

Giveway finds, for every robot, a path to its goal past its waypoints, without \
collisions and within its battery, and proves that no plan is better: by the makespan, \
the sum of costs, the charges, the moves or the waits, in the order you ask for.";

const AFTER_HELP: &str = "An INSTANCE is
  a native file       JSON with the key \"giveway\"
  a .scen             a MovingAI scenario; its .map is the file in the same folder that the
                      scenario names, or given with --map
  -                   either of them from standard input; a scenario needs --map
The ending of the name says which one it is; without one, how the file begins.

Exit status
  0   the question was answered; \"impossible\" is an answer, and \"feasible\" too
  1   the input is wrong, a check found violations, or a certificate was rejected
  2   the command line is wrong
  3   the budget ran out without any answer (unknown)";

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
    /// Print no progress line and no notes on standard error
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
    /// Explain why a plan is as it is, or why there is none
    Explain(Explain),
    /// Find new plans after the world has changed
    Change(Change),
    /// Check an exported certificate again, without the solver
    Verify(Verify),
    /// Write instances and plans in another format
    Convert(Convert),
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
The answer is one of
  optimal      a plan, and a proof that none is better
  feasible     a plan, and the bounds proved when the time ran out
  impossible   no plan exists
  unknown      the time ran out with neither (exit status 3)
A claim holds no matter how many steps you allow, or it names the makespan up to which it holds.

Examples
  giveway solve warehouse.json
  giveway solve warehouse.json --objective charges,makespan --format json
  giveway solve empty-16-16-even-1.scen --agents 20 --time-limit 30
  giveway solve warehouse.json --pareto --objective makespan,charges")]
pub(crate) struct Solve {
    #[command(flatten)]
    pub(crate) source: Source,
    /// The costs to minimise, the most important first: makespan, sum-of-costs, charges,
    /// moves, waits, separated by commas [default: the instance's own, or
    /// makespan,sum-of-costs,charges]
    #[arg(long, value_name = "LIST")]
    pub(crate) objective: Option<Objective>,
    /// Find all plans that no other plan beats in one cost without being worse in another; the
    /// objective must have two or three costs
    #[arg(long)]
    pub(crate) pareto: bool,
    /// Look only for plans of at most this makespan; 0 is allowed [default: the longest time that a
    /// robot needs alone + 4 (width + height) + 10]
    #[arg(long, value_name = "N", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) within: Option<u32>,
    /// Stop the whole command after so many seconds; 0.5 is allowed
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub(crate) time_limit: Option<f64>,
    /// Write a certificate of what is proved into a new or empty folder: formulas, proofs, and
    /// a README; giveway verify checks it again
    #[arg(long, value_name = "DIR", conflicts_with = "pareto")]
    pub(crate) proof: Option<PathBuf>,
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
    /// The folder that --proof wrote
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,
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
    /// A plan, or a result of solve with a plan in it; or - for standard input
    #[arg(value_name = "PLAN")]
    pub(crate) plan: PathBuf,
    /// What changes while the plan runs: the plan is checked at each time in the world of that time
    #[arg(long, value_name = "FILE")]
    pub(crate) changes: Option<PathBuf>,
}

#[derive(Debug, ClapArgs)]
#[command(after_help = "\
A QUESTION is one of
  wait A [--at X,Y] [--from T] [--to T] [--at-least N]    why does A wait (so long)?
  charge A [--at X,Y] [--time T]                          why does A charge?
  no-charge A --at X,Y                                    why does A not charge there?
  visit A --at X,Y [--time T]                             why does A pass there?
  no-visit A|any --at X,Y                                 why does A, or anybody, not pass there?
  move A --from-cell X,Y --to-cell X,Y [--time T]         why does A go that way?
  no-move A --from-cell X,Y --to-cell X,Y [--time T]      why does A not go that way?
  slow A [--from-cell X,Y --to-cell X,Y]                  why does A take the slow way?
  order A --first X,Y --second X,Y                        why does A visit one before the other?
  arrival A                                               why does A not arrive sooner?
  length A [--fewer-than N]                               why is the path of A this long?
  makespan, sum-of-costs                                  why is it not less?
  charges [A], moves [A], waits [A]                       why are there not fewer (of A)?
  yield A B --at X,Y                                      why does A give way to B there?
  unsolvable                                              why is there no plan?
  plan                                                    is this plan valid, and the best?

The answer is one of
  needless     a plan without it costs the same
  improvable   a plan without it costs less: the plan asked about is not the best
  costly       every plan without it costs more
  necessary    there is no plan without it
  unknown      the time ran out (exit status 3)

Examples
  giveway explain scenario-1.json --plan plan-1.json wait A2 --at 3,1
  giveway explain warehouse.json charge A1 --at 6,2
  giveway explain scenario-6.json unsolvable
  giveway explain warehouse.json --plan adopted.json --changes changes.json arrival A1")]
pub(crate) struct Explain {
    #[command(flatten)]
    pub(crate) source: Source,
    #[command(flatten)]
    pub(crate) question: Typed,
    /// The plan that the question is about: a plan, or a result of solve with a plan in it; or -
    /// for standard input [default: the instance is solved first]
    #[arg(long, value_name = "PLAN")]
    pub(crate) plan: Option<PathBuf>,
    /// What changed while the plan ran: the question is about the plan from the last of these
    /// changes on; times count from the beginning of the whole plan
    #[arg(long, value_name = "FILE", requires = "plan", conflicts_with = "proof")]
    pub(crate) changes: Option<PathBuf>,
    /// Ask as of this time: later changes do not count, and the plan must be valid without them
    /// [default: all changes count]
    #[arg(long, value_name = "T", requires = "changes", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) at_time: Option<u32>,
    /// The costs in which plans compare, the most important first [default: the instance's own,
    /// or makespan,sum-of-costs,charges]
    #[arg(long, value_name = "LIST")]
    pub(crate) objective: Option<Objective>,
    /// Look only for plans of at most this makespan, or that of the plan asked about [default: the
    /// longest time that a robot needs alone + 4 (width + height) + 10]
    #[arg(long, value_name = "N", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) within: Option<u32>,
    /// Stop the whole command after so many seconds; 0.5 is allowed
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub(crate) time_limit: Option<f64>,
    /// Write a certificate of what is proved into a new or empty folder; giveway verify checks it
    /// again
    #[arg(long, value_name = "DIR")]
    pub(crate) proof: Option<PathBuf>,
}

/// A question as it is typed.
#[derive(Debug, ClapArgs)]
pub(crate) struct Typed {
    /// What is asked: wait, charge, no-charge, visit, no-visit, move, no-move, slow, order,
    /// arrival, length, makespan, sum-of-costs, charges, moves, waits, yield, unsolvable, plan
    #[arg(value_name = "QUESTION")]
    pub(crate) kind: String,
    /// The robots that it is about
    #[arg(value_name = "AGENT")]
    pub(crate) who: Vec<String>,
    /// The cell
    #[arg(long, value_name = "X,Y")]
    pub(crate) at: Option<Cell>,
    /// The first time of an interval
    #[arg(long, value_name = "T", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) from: Option<u32>,
    /// The last time of an interval
    #[arg(long, value_name = "T", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) to: Option<u32>,
    /// The time
    #[arg(long, value_name = "T", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) time: Option<u32>,
    /// How many wait steps in a row count as long
    #[arg(long, value_name = "N", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) at_least: Option<u32>,
    /// The moves that would be too many
    #[arg(long, value_name = "N", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) fewer_than: Option<u32>,
    /// The cell that the robot leaves
    #[arg(long, value_name = "X,Y")]
    pub(crate) from_cell: Option<Cell>,
    /// The cell that the robot goes to
    #[arg(long, value_name = "X,Y")]
    pub(crate) to_cell: Option<Cell>,
    /// The cell that is visited first
    #[arg(long, value_name = "X,Y")]
    pub(crate) first: Option<Cell>,
    /// The cell that is visited after that
    #[arg(long, value_name = "X,Y")]
    pub(crate) second: Option<Cell>,
}

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
