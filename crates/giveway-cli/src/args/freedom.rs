//! The arguments of `giveway freedom`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use giveway_model::Objective;
use giveway_solve::freedom::FreedomPart;

use super::{Source, seconds, whole};

/// What is asked of all best plans.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
A best plan has the least costs, compared in the order of the objective. Without --backbone,
--count, --slack, --critical and --farthest all of these are told. What the time did not suffice
for is said to be open.

Examples
  giveway freedom warehouse.json
  giveway freedom warehouse.json --plan warehouse.plan.json --critical --time-limit 30
  giveway freedom warehouse.json --count 5000 --format json")]
pub(crate) struct Freedom {
    #[command(flatten)]
    pub(crate) source: Source,
    /// The plan that is looked at: a plan, or a result of solve with a plan in it; or - for
    /// standard input. It is proved best first [default: the instance is solved first]
    #[arg(long, value_name = "PLAN")]
    pub(crate) plan: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) parts: Parts,
    /// The costs to minimise, the most important first [default: the instance's own, or
    /// makespan,sum-of-costs,charges]
    #[arg(long, value_name = "LIST")]
    pub(crate) objective: Option<Objective>,
    /// Look only at plans of at most this makespan; 0 is allowed [default: the longest time that a
    /// robot needs alone + 4 (width + height) + 10]
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

/// The parts of the answer.
#[derive(Clone, Copy, Debug, ClapArgs)]
#[allow(
    clippy::struct_excessive_bools,
    reason = "each is an option by itself, in any combination"
)]
pub(crate) struct Parts {
    /// Tell which steps are the same in every best plan, and which only this one has
    #[arg(long)]
    backbone: bool,
    /// Count the best plans, up to this number [default: 1000]
    #[arg(long, value_name = "N", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) count: Option<u32>,
    /// Tell how late each robot could be
    #[arg(long)]
    slack: bool,
    /// Tell what closing each free cell would cost
    #[arg(long)]
    critical: bool,
    /// Show another best plan, as different from this one as can be
    #[arg(long)]
    farthest: bool,
}

impl Parts {
    /// Those that are named; none where all are meant.
    pub(crate) fn named(self) -> Vec<FreedomPart> {
        let named = [
            (self.backbone, FreedomPart::Backbone),
            (self.slack, FreedomPart::Slack),
            (self.count.is_some(), FreedomPart::Plans),
            (self.critical, FreedomPart::Critical),
            (self.farthest, FreedomPart::Farthest),
        ];
        let named = named.into_iter().filter(|(is_named, _)| *is_named);
        named.map(|(_, part)| part).collect()
    }
}
