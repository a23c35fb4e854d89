//! The arguments of `giveway solve`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use giveway_model::Objective;
use giveway_solve::plan::Planner;

use super::{Source, seconds, whole};

/// An instance to solve, and how.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
The answer is one of
  optimal      a plan, and a proof that none is better
  feasible     a plan, and the bounds proved when a limit ended the search
  impossible   no plan exists
  unknown      a limit ended the search with neither (exit status 3)
A claim holds no matter how many steps you allow, or it names the makespan up to which it holds.

The same question gets the same answer, here and in the browser, where a proof or --work-limit ends
the search. Where time, memory or Ctrl-C ends it, how far it came decides. JSON says which: \"ended\" is
proof, work, time, memory or cancelled. A limit of work counts states that planners and local search
look at, and the SAT solver's steps, weighed in states; \"stats\" has the work of each answer.

Examples
  giveway solve warehouse.json
  giveway solve warehouse.json --objective charges,makespan --format json
  giveway solve empty-16-16-even-1.scen --agents 20 --time-limit 30
  giveway solve random-32-32-20-random-1.scen --agents 250 --work-limit 3000000
  giveway solve warehouse.json --trace steps.json
  giveway solve warehouse.json --pareto --objective makespan,charges
  giveway solve warehouse.json --planner cbs --objective sum-of-costs --trace tree.json

Planners of the textbook (--planner)
  prioritised  one robot after the other, each around those before it; --order gives the order
  cbs          conflict-based search: no plan has a smaller makespan, or sum of costs
  pibt         all robots a step at a time; hundreds of them
  lacam        a search over such steps, better and better
  lns          a few robots planned anew at a time, better and better
Only cbs proves anything; what a planner cannot do it says (exit status 3).")]
pub(crate) struct Solve {
    #[command(flatten)]
    pub(crate) source: Source,
    /// The costs to minimise, the most important first: makespan, sum-of-costs, charges,
    /// moves, waits, penalty, separated by commas [default: the instance's own, or
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
    /// Stop the search after so many units of work (see below). The same question
    /// with the same limit then has the same answer each time, in the browser too
    #[arg(long, value_name = "N", value_parser = whole::<u64>, allow_negative_numbers = true)]
    pub(crate) work_limit: Option<u64>,
    /// Find a plan with a planner of the textbook instead: prioritised, cbs, pibt, lacam, lns
    #[arg(long, value_name = "NAME", conflicts_with_all = ["pareto", "proof"])]
    pub(crate) planner: Option<Planner>,
    /// The order in which prioritised planning plans, by name, separated by commas; robots that are
    /// not named come last [default: it looks for one]
    #[arg(long, value_name = "LIST", value_delimiter = ',', requires = "planner")]
    pub(crate) order: Option<Vec<String>>,
    /// Write into a file, as JSON, how the plan was found and proved, step by step; with --planner,
    /// how the planner went
    #[arg(long, value_name = "FILE", conflicts_with = "pareto")]
    pub(crate) trace: Option<PathBuf>,
    /// Write a certificate of what is proved into a new or empty folder: formulas, proofs, and
    /// a README; giveway verify checks it again
    #[arg(long, value_name = "DIR", conflicts_with = "pareto")]
    pub(crate) proof: Option<PathBuf>,
}
