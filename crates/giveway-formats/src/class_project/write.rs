//! Writes an instance of the class project.

use std::fmt::Write as _;

use crate::Written;
use crate::write::Job;
use giveway_model::{Fault, tr_later};

/// Writes an instance.
///
/// # Errors
/// When there is a plan, or no instance.
pub(crate) fn write(job: &Job<'_>) -> Result<Written, Fault> {
    let expected = tr_later!("an instance, since files of the class project hold no plans");
    let instance = job.instance_alone(expected)?;
    let grid = instance.grid();
    // Writing to a string does not fail.
    let mut text = format!("{} {}\n", grid.height(), grid.width());
    for (cell, ground) in grid.cells() {
        text.push(if ground.is_vertex() { '.' } else { '@' });
        text.push(if cell.x + 1 == grid.width() {
            '\n'
        } else {
            ' '
        });
    }
    let _ = writeln!(text, "{}", instance.agents().len());
    for agent in instance.agents() {
        // An agent without a goal has got one before.
        let (start, goal) = (agent.start, agent.goal.unwrap_or(agent.start));
        let _ = writeln!(text, "{} {} {} {}", start.y, start.x, goal.y, goal.x);
    }
    Ok(job.written([(".txt", text)], &[]))
}
