//! Writes a line for each robot, as CBSH2-RTC and EECBS do, with the map and the
//! scenario that it is for.

use std::fmt::Write as _;

use crate::format::foreign::whole_steps::{WholeSteps, both, with_map};
use crate::format::foreign::{Format, Written};
use crate::{Fault, Instance, Plan};

/// Writes a plan.
///
/// # Errors
/// When the instance or the plan is missing, or when a robot is between two cells
/// or has no path.
pub(in crate::format::foreign) fn write(
    stem: &str,
    instance: Option<&Instance>,
    plan: Option<&Plan>,
) -> Result<Written, Fault> {
    let (instance, plan) = both(Format::Paths, instance, plan)?;
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
    with_map(stem, "-paths.txt", text, (instance, plan), &[])
}
