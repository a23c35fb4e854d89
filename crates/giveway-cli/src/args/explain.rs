//! The arguments of `giveway explain`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use giveway_model::{Cell, Objective};
use giveway_solve::explain::Layer;

use super::{Source, seconds, whole};

/// A question about a plan, or why there is none.
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
  rule \"RULE\", rule --rule FILE                           why is it not so that RULE holds?
  unsolvable                                              why is there no plan?
  plan                                                    is this plan valid, and the best?
  delays                                                  who costs whom: whom does each robot let pass?

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
  giveway explain warehouse.json rule \"each robot arrives by 12\"
  giveway explain warehouse.json --plan adopted.json --changes changes.json arrival A1
  giveway explain warehouse.json delays")]
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
    /// The layers of the answer, the quickest first: here (what the plan shows), near (small
    /// variations of it), whole (the verdict), reason, help; each of the last three with those of
    /// them before it [default: whole,reason,help]
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub(crate) layers: Vec<Layer>,
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
    /// arrival, length, makespan, sum-of-costs, penalty, charges, moves, waits, yield, rule,
    /// unsolvable, plan, delays
    #[arg(value_name = "QUESTION")]
    pub(crate) kind: String,
    /// The robots that it is about; of the question "rule" the rule in words
    #[arg(value_name = "AGENT")]
    pub(crate) who: Vec<String>,
    /// The cell
    #[arg(long, value_name = "X,Y")]
    pub(crate) at: Option<Cell>,
    /// A file with the rule that is asked about, in words or as JSON
    #[arg(long, value_name = "FILE")]
    pub(crate) rule: Option<PathBuf>,
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
