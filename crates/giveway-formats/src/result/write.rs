//! Writes a line for each time step, as Kei18/lacam does, with the map and the scenario
//! that it is for.

use std::fmt::Write as _;

use crate::whole_steps::WholeSteps;
use crate::write::Job;
use crate::{Format, Written};
use giveway_model::{Agent, Cell, Fault};

/// Writes a plan.
///
/// # Errors
/// When the instance or the plan is missing, or when a robot is between two cells
/// or has no path.
pub(crate) fn write(job: &Job<'_>) -> Result<Written, Fault> {
    let (instance, plan) = job.both(Format::Result)?;
    let steps = WholeSteps::new(instance, plan, Format::Result)?;
    let agents = instance.agents();
    // Writing to a string does not fail.
    let mut text = String::new();
    let _ = writeln!(text, "agents={}\nmap_file={}.map", agents.len(), job.stem);
    text.push_str("solver=giveway\nsolved=1\n");
    let _ = writeln!(text, "soc={}", steps.sum_of_costs());
    let _ = writeln!(text, "makespan={}", steps.makespan());
    text.push_str("starts=");
    line(&mut text, agents.iter().map(|agent| agent.start));
    text.push_str("goals=");
    line(&mut text, agents.iter().map(Agent::goal_or_start));
    text.push_str("solution=\n");
    for time in 0..=steps.makespan() {
        let _ = write!(text, "{time}:");
        line(
            &mut text,
            (0..agents.len()).filter_map(|agent| steps.at(agent, time)),
        );
    }
    job.with_map(instance, ("-result.txt", text))
}

fn line(text: &mut String, cells: impl Iterator<Item = Cell>) {
    for cell in cells {
        let (x, y) = cell.signed();
        let _ = write!(text, "({x},{y}),");
    }
    text.push('\n');
}
