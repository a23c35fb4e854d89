//! Writes a line for each robot, as CBSH2-RTC and EECBS do, with the map and the
//! scenario that it is for.

use std::fmt::Write as _;

use crate::whole_steps::WholeSteps;
use crate::write::Job;
use crate::{Format, Written};
use giveway_model::Fault;

/// Writes a plan.
///
/// # Errors
/// When the instance or the plan is missing, or when a robot is between two cells
/// or has no path.
pub(crate) fn write(job: &Job<'_>) -> Result<Written, Fault> {
    let (instance, plan) = job.both(Format::Paths)?;
    let steps = WholeSteps::new(instance, plan, Format::Paths)?;
    steps.some(Format::Paths)?;
    let mut text = String::new();
    for (i, path) in steps.paths.iter().enumerate() {
        // Writing to a string does not fail.
        let _ = write!(text, "Agent {i}: ");
        for cell in path {
            let (x, y) = cell.signed();
            let _ = write!(text, "({y},{x})->");
        }
        text.push('\n');
    }
    job.with_map(instance, ("-paths.txt", text))
}
