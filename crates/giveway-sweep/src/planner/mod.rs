//! Planners of others, as commands: run within limits, and judged by what they write.
//!
//! ```text
//!   spec ──▶ command ──▶ run (guard, usage, errors) ──▶ output ──▶ verdict
//! ```
//!
//! A planner gets a map and a scenario that are written from the instance that judges its
//! plan. It runs in a process group of its own, which is killed when a limit is reached.
//! Where the system is no Unix, it is refused.

mod command;
#[cfg(unix)]
mod errors;
#[cfg(unix)]
mod given;
#[cfg(unix)]
mod guard;
#[cfg(unix)]
mod output;
#[cfg(unix)]
mod run;
mod spec;
#[cfg(unix)]
#[cfg(test)]
mod tests;
#[cfg(unix)]
mod usage;
#[cfg(unix)]
mod verdict;

use giveway_solve::Host;

use crate::{Loaded, Row, Task};
pub use spec::PlannerSpec;
pub(crate) use spec::wrong_name;

/// Runs the command of a task on its instance, and judges what it writes. The clocks of the
/// host begin with it.
#[cfg(unix)]
pub(crate) fn row(task: &Task, spec: &PlannerSpec, loaded: &Loaded, host: &dyn Host) -> Row {
    verdict::row(task, spec, loaded, host)
}

/// Refuses to run a command: there are no process groups here.
#[cfg(not(unix))]
pub(crate) fn row(task: &Task, _: &PlannerSpec, _: &Loaded, _: &dyn Host) -> Row {
    Row::error(
        task,
        "Planners of others run on Linux, macOS and other Unix systems only.".to_owned(),
    )
}
