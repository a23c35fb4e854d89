//! The arguments of `giveway price`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use giveway_model::Objective;

use super::{Source, seconds, whole};

/// What the rules of a scene's own cost.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
For each rule of the scene's own that is in force: the best plan without it beside the best plan
with all of them. A price is one of
  free         the best plan without it costs the same
  costs        it costs less: the difference of each cost
  decides      there is a plan without it, and none with it
  none         there is no plan, with it or without it
  unknown      the time ran out
Where the rules together leave no plan, those that exclude each other are told, and the fewest
whose switching off leaves one.

Examples
  giveway price floor.json
  giveway price floor.json --loosen 0
  giveway price floor.json --objective penalty,makespan --format json
  giveway price warehouse.json --constraint \"each cell stays free for 1 step behind any robot\"")]
pub(crate) struct Price {
    #[command(flatten)]
    pub(crate) source: Source,
    /// The costs to minimise, the most important first [default: the instance's own, or
    /// makespan,sum-of-costs,charges]; the penalty comes last where it is in force and not named
    #[arg(long, value_name = "LIST")]
    pub(crate) objective: Option<Objective>,
    /// A plan that is known already: the search begins with it; or - for standard input
    #[arg(long, value_name = "PLAN")]
    pub(crate) plan: Option<PathBuf>,
    /// Look only at plans of at most this makespan; 0 is allowed [default: the longest time that a
    /// robot needs alone + 4 (width + height) + 10]
    #[arg(long, value_name = "N", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) within: Option<u32>,
    /// Price this rule alone, by its number in the file from 0, and find the least by which it has to
    /// be loosened so that the costs change, or there is a plan
    #[arg(long, value_name = "RULE", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) loosen: Option<u32>,
    /// Stop the whole command after so many seconds; 0.5 is allowed
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub(crate) time_limit: Option<f64>,
}
