//! The arguments of `giveway change`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use giveway_model::Objective;
use giveway_solve::change::Method;

use super::{Source, seconds, whole};

/// A plan, and what changes around it.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
CHANGES is JSON: { \"giveway\": 1, \"changes\": [ { \"at\": 2, \"change\": \"add-obstacle\", \"cell\": [3, 1] } ] }
  add-agent       agent, as in an instance        remove-agent       agent
  add-obstacle    cell                            remove-obstacle    cell
  move-obstacle   from, to
  set-slow        cells                           set-normal         cells
  add-charger     cell                            remove-charger     cell
  set-goal        agent, cell                     set-battery        agent, level
  add-waypoint    agent, cell                     drop-waypoint      agent, cell
  delay-agent     agent, steps: it breaks down for so long
What is of one time happens together. The past stays as it was; each later time is looked at
with the plan adopted before.

A METHOD is one of
  revise      old agents keep their sequence of cells and may only be timed anew
  tunnel=W    old agents keep within W steps of the rest of their paths
  replan      everyone plans freely
Each minimises the makespan, then the objective's other costs, then the number of agents
that are disturbed. Where a method has no plan, it says why, and frees as few agents as can
be. The first method that has a plan is adopted.

Examples
  giveway change warehouse.json warehouse.plan.json changes.json
  giveway change warehouse.json warehouse.plan.json changes.json --method revise,tunnel=1,replan")]
pub(crate) struct Change {
    #[command(flatten)]
    pub(crate) source: Source,
    /// The plan that runs, or a result with a plan in it; or - for standard input. It may know
    /// the earlier of the changes
    #[arg(value_name = "PLAN")]
    pub(crate) plan: PathBuf,
    /// What changes, and when; or - for standard input
    #[arg(value_name = "CHANGES")]
    pub(crate) changes: PathBuf,
    /// The methods, separated by commas
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        default_value = "revise,replan"
    )]
    pub(crate) method: Vec<Method>,
    /// The costs after the makespan, the most important first [default: the instance's own, or
    /// makespan,sum-of-costs,charges]
    #[arg(long, value_name = "LIST")]
    pub(crate) objective: Option<Objective>,
    /// Only plans of at most this makespan, counted from time 0 [default: of each change, the
    /// largest optimum of an agent alone from then on + 4 (width + height) + 10]
    #[arg(long, value_name = "N", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) within: Option<u32>,
    /// The first time whose changes are new to the plan: all before were known when it was made
    /// [default: what the plan says it knows; else as few as make it valid]
    #[arg(long, value_name = "T", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) since: Option<u32>,
    /// Wall seconds for each method at each time; 0.5 is legal
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub(crate) time_limit: Option<f64>,
}
