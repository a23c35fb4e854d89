//! Writes a line for each time step, as Kei18/lacam does, with the map and the scenario
//! that it is for.

use std::fmt::Write as _;

use crate::format::foreign::whole_steps::{WholeSteps, both, with_map};
use crate::format::foreign::{Format, Written};
use crate::{Cell, Fault, Instance, Plan};

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
    let (instance, plan) = both(Format::Result, instance, plan)?;
    let steps = WholeSteps::new(instance, plan, Format::Result)?;
    let agents = instance.agents();
    // Writing to a string does not fail.
    let mut text = String::new();
    let _ = writeln!(text, "agents={}\nmap_file={stem}.map", agents.len());
    text.push_str("solver=giveway\nsolved=1\n");
    let _ = writeln!(text, "soc={}", steps.sum_of_costs());
    let _ = writeln!(text, "makespan={}", steps.makespan());
    text.push_str("starts=");
    line(&mut text, agents.iter().map(|agent| agent.start));
    text.push_str("goals=");
    line(&mut text, agents.iter().map(|agent| agent.goal));
    text.push_str("solution=\n");
    for time in 0..=steps.makespan() {
        let _ = write!(text, "{time}:");
        line(
            &mut text,
            (0..agents.len()).filter_map(|agent| steps.at(agent, time)),
        );
    }
    with_map(stem, "-result.txt", text, (instance, plan), &[])
}

fn line(text: &mut String, cells: impl Iterator<Item = Cell>) {
    for cell in cells {
        let (x, y) = cell.signed();
        let _ = write!(text, "({x},{y}),");
    }
    text.push('\n');
}
