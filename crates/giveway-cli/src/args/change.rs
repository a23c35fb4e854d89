//! The arguments of `giveway change`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use giveway_model::Objective;
use giveway_solve::change::Method;

use super::{Source, seconds, whole};

/// A plan, and what changes while it runs.
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
  delay-agent     agent, steps: it breaks down for so many steps
  stop-agent      agent: it breaks down for good, and is an obstacle where it is
  add-constraint  constraint, as in an instance   remove-constraint  name, or index
Changes of the same time happen together. The past stays as it was. Each later time goes on with
the plan that was used before.

A METHOD is one of
  revise      robots keep their paths and only get new times
  tunnel=W    robots stay within W steps of the rest of their paths
  replan      every robot plans freely
New robots plan freely with each method. Each method minimises the makespan, then the other costs
of the objective, then the number of robots whose plan changes. If a method has no plan, it says
why, and frees as few robots as possible. The first method that has a plan is used.

Examples
  giveway change warehouse.json warehouse.plan.json changes.json
  giveway change warehouse.json warehouse.plan.json changes.json --method revise,tunnel=1,replan")]
pub(crate) struct Change {
    #[command(flatten)]
    pub(crate) source: Source,
    /// The plan that runs, or a result with a plan in it; or - for standard input. It may
    /// have been made with some of the changes already
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
    /// Look only for plans of at most this makespan, counted from time 0 [default: at each change,
    /// the longest time that a robot needs alone from then on + 4 (width + height) + 10]
    #[arg(long, value_name = "N", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) within: Option<u32>,
    /// The first time whose changes are new to the plan; it was made with all earlier ones [default:
    /// what the plan says it knows; otherwise as few as make it valid]
    #[arg(long, value_name = "T", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) since: Option<u32>,
    /// Stop each method at each time after so many seconds; 0.5 is allowed
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub(crate) time_limit: Option<f64>,
}
