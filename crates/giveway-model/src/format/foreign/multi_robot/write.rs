//! Writes a scenario, a schedule, or both.

use std::fmt::Write as _;

use crate::format::foreign::whole_steps::{WholeSteps, both};
use crate::format::foreign::{Format, Written};
use crate::format::loss::{Part, losses};
use crate::{Fault, Instance, Plan};

/// Writes `STEM.yaml`, `STEM-schedule.yaml`, or both.
///
/// # Errors
/// When the instance is missing, or a path is missing or in transit.
pub(in crate::format::foreign) fn write(
    stem: &str,
    instance: Option<&Instance>,
    plan: Option<&Plan>,
) -> Result<Written, Fault> {
    let Some(instance) = instance else {
        both(Format::MultiRobot, instance, plan)?;
        return Ok(Written::default());
    };
    let mut files = vec![(format!("{stem}.yaml"), scenario(instance))];
    if let Some(plan) = plan {
        let steps = WholeSteps::new(instance, plan, Format::MultiRobot)?;
        files.push((format!("{stem}-schedule.yaml"), schedule(&steps)));
    }
    let lost = losses(&[Part::Names], Some(instance), plan);
    Ok(Written {
        files,
        losses: lost.iter().map(ToString::to_string).collect(),
    })
}

/// A text that every YAML reader takes for a text: in quotes unless it is a word
/// with a number, which is no word of YAML.
fn quoted(name: &str) -> String {
    let is_word = name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.ends_with(|c: char| c.is_ascii_digit())
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    if is_word {
        return name.to_owned();
    }
    let mut text = String::from("\"");
    for c in name.chars() {
        match c {
            '"' | '\\' => text.extend(['\\', c]),
            c if c.is_control() => {
                // Writing to a string does not fail.
                let _ = write!(text, "\\u{:04X}", u32::from(c));
            }
            c => text.push(c),
        }
    }
    text.push('"');
    text
}

fn scenario(instance: &Instance) -> String {
    let grid = instance.grid();
    let mut text = format!(
        "map:\n  dimensions: [{}, {}]\n  obstacles:",
        grid.width(),
        grid.height()
    );
    let all_obstacles = || grid.cells().filter(|(_, ground)| !ground.is_vertex());
    if all_obstacles().next().is_none() {
        text += " []";
    }
    text.push('\n');
    for (cell, _) in all_obstacles() {
        let _ = writeln!(text, "    - [{}, {}]", cell.x, cell.y);
    }
    text += if instance.agents().is_empty() {
        "agents: []\n"
    } else {
        "agents:\n"
    };
    for agent in instance.agents() {
        let (start, goal) = (agent.start, agent.goal);
        let _ = writeln!(
            text,
            "  - name: {}\n    start: [{}, {}]\n    goal: [{}, {}]",
            quoted(&agent.name),
            start.x,
            start.y,
            goal.x,
            goal.y
        );
    }
    text
}

fn schedule(steps: &WholeSteps) -> String {
    let (cost, makespan) = (steps.sum_of_costs(), steps.makespan());
    let mut text = format!("statistics:\n  cost: {cost}\n  makespan: {makespan}\nschedule:");
    text += if steps.paths.is_empty() {
        " {}\n"
    } else {
        "\n"
    };
    for (agent, path) in steps.paths.iter().enumerate() {
        let _ = writeln!(text, "  agent{agent}:");
        for (time, cell) in path.iter().enumerate() {
            let (x, y) = cell.signed();
            let _ = writeln!(text, "    - x: {x}\n      y: {y}\n      t: {time}");
        }
    }
    text
}
