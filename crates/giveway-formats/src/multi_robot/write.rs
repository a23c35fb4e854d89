//! Writes a scenario, a schedule, or both.

use std::fmt::Write as _;

use super::moving::{NOWHERE, rules};
use crate::loss::Part;
use crate::whole_steps::WholeSteps;
use crate::write::Job;
use crate::{Format, Written};
use giveway_model::constraint::ConstraintKind;
use giveway_model::sorting::set;
use giveway_model::{Assumption, Constraint, Fault, Instance, Zone};

/// Writes `STEM.yaml`, `STEM-schedule.yaml`, or both.
///
/// # Errors
/// When the instance is missing, or a path is missing or in transit.
pub(crate) fn write(job: &Job<'_>) -> Result<Written, Fault> {
    let Some(instance) = job.instance else {
        job.both(Format::MultiRobot)?;
        return Ok(Written::default());
    };
    let holds = [Part::Names, Part::Moving];
    let rest = without_closed(instance);
    let of_rest = Job {
        instance: rest.as_ref().or(job.instance),
        ..*job
    };
    let mut written = of_rest.written([(".yaml", scenario(instance))], &holds);
    if let Some(plan) = job.plan {
        let steps = WholeSteps::new(instance, plan, Format::MultiRobot)?;
        let name = format!("{}-schedule.yaml", job.stem);
        written.files.push((name, schedule(instance, &steps)));
    }
    Ok(written)
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
        let (start, goal) = (agent.start, agent.goal_or_start());
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
    obstacles(&mut text, instance);
    text
}

/// The instance without the rules that close the cells of obstacles that move: the obstacles
/// themselves are written. `None` where there is no such rule.
fn without_closed(instance: &Instance) -> Option<Instance> {
    let mut scene = instance.to_scene();
    let before = scene.constraints.len();
    for one in instance.assumptions() {
        let Assumption::MovingObstacle {
            name,
            path,
            closed: true,
        } = one
        else {
            continue;
        };
        let (zones, rules) = rules(name, path, instance.grid());
        let by_name = |name: &str| rules.iter().find(|rule| rule.name.as_deref() == Some(name));
        let is_held = |rule: &Constraint| rule.name.as_deref().and_then(by_name) == Some(rule);
        scene.constraints.retain(|rule| !is_held(rule));
        let named = scene.constraints.iter().filter_map(zone_of);
        let named = set(named.map(str::to_owned));
        let is_held = |zone: &Zone| zones.contains(zone) && !named.contains(&zone.name);
        scene.zones.retain(|zone| !is_held(zone));
    }
    (scene.constraints.len() < before)
        .then(|| Instance::new(scene).ok())
        .flatten()
}

/// The zone that a rule is about.
fn zone_of(rule: &Constraint) -> Option<&str> {
    match &rule.kind {
        ConstraintKind::Capacity { zone, .. }
        | ConstraintKind::Closed { zone, .. }
        | ConstraintKind::NoWaiting { zone, .. }
        | ConstraintKind::Avoid { zone, .. } => Some(zone),
        ConstraintKind::OneWay { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Apart { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Visit { .. }
        | ConstraintKind::Arrive { .. }
        | ConstraintKind::Late { .. }
        | ConstraintKind::Depart { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::Turns { .. } => None,
    }
}

/// The obstacles that move, each with its states.
fn obstacles(text: &mut String, instance: &Instance) {
    let moving = instance.assumptions().iter().filter_map(|one| match one {
        Assumption::MovingObstacle { name, path, .. } => Some((name, path)),
        Assumption::GoalsChosen
        | Assumption::RuleLeftOut { .. }
        | Assumption::UnknownKey { .. } => None,
    });
    for (i, (name, path)) in moving.enumerate() {
        if i == 0 {
            text.push_str("dynamic_obstacles:\n");
        }
        let _ = writeln!(text, "  {}:", quoted(name));
        // Before its first state it is nowhere.
        let begins = path.iter().position(|&cell| cell != NOWHERE).unwrap_or(0);
        for (time, cell) in path.iter().enumerate().skip(begins) {
            let (x, y) = cell.signed();
            let _ = writeln!(text, "    - {{t: {time}, x: {x}, y: {y}}}");
        }
    }
}

fn schedule(instance: &Instance, steps: &WholeSteps) -> String {
    let (cost, makespan) = (steps.sum_of_costs(), steps.makespan());
    let mut text = format!("statistics:\n  cost: {cost}\n  makespan: {makespan}\nschedule:");
    text += if steps.paths.is_empty() {
        " {}\n"
    } else {
        "\n"
    };
    for (agent, path) in instance.agents().iter().zip(&steps.paths) {
        let _ = writeln!(text, "  {}:", quoted(&agent.name));
        for (time, cell) in path.iter().enumerate() {
            let (x, y) = cell.signed();
            let _ = writeln!(text, "    - x: {x}\n      y: {y}\n      t: {time}");
        }
    }
    text
}
