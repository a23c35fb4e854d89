//! The new plan behind the past, as one plan from time 0.

use giveway_model::{
    Cell, Plan,
    change::{Trajectory, Whereabouts},
};

use super::world::World;
use crate::{
    problem::Problem,
    single::Place,
    walk::{Walk, charges},
};

/// Puts walks from the time of the change on behind the past. Agents that do
/// the `same` as before charge as before, too.
pub(super) fn splice(world: &World<'_>, problem: &Problem, walks: &[Walk], same: &[bool]) -> Plan {
    let mut plan = past(world);
    for (agent, member) in world.members.iter().enumerate() {
        let (Some(walk), Some(task)) = (walks.get(agent), problem.tasks.get(agent)) else {
            continue;
        };
        let cell = |place: &Place| match *place {
            Place::At(v) => Some(problem.terrain.cell(v)),
            Place::Along(_) => None,
        };
        if let Some(arrived) = member.arrived {
            if walk.len() < 2 && member.rested > 0 {
                sleep_on(world, &member.name, &mut plan);
                continue;
            }
            let spans = plan.slept.entry(member.name.clone()).or_default();
            spans.push([arrived, world.at]);
        }
        let path = plan.paths.entry(member.name.clone()).or_default();
        path.extend(walk.iter().map(cell));
        let own = if same.get(agent) == Some(&true) {
            let old = world.plan.charges(&member.name);
            old.iter()
                .copied()
                .filter(|&time| time >= world.at)
                .collect()
        } else {
            let charges = charges(task, &problem.terrain, walk).unwrap_or_default();
            charges
                .iter()
                .map(|time| time + world.at)
                .collect::<Vec<u32>>()
        };
        let listed = plan.charges.entry(member.name.clone()).or_default();
        listed.extend(own);
    }
    plan.charges.retain(|_, charges| !charges.is_empty());
    for timeline in world.after.timelines() {
        let trajectory = Trajectory::of(world.after, timeline, &plan);
        let cut = trajectory.map(|trajectory| trajectory.path.to_vec());
        if let (Some(cut), None) = (cut, timeline.until) {
            plan.paths.insert(timeline.name().to_owned(), cut);
        }
    }
    plan
}

/// An agent that has arrived and goes on sleeping: its path ended with its
/// arrival.
fn sleep_on(world: &World<'_>, name: &str, plan: &mut Plan) {
    let mut timelines = world.before.timelines().iter();
    let timeline = timelines.find(|timeline| timeline.name() == name);
    let trajectory =
        timeline.and_then(|timeline| Trajectory::of(world.before, timeline, world.plan));
    if let Some(trajectory) = trajectory {
        plan.paths.insert(name.to_owned(), trajectory.path.to_vec());
    }
}

/// The plan up to the change: all of those that are gone, and of the others
/// what is before the change.
fn past(world: &World<'_>) -> Plan {
    let mut plan = Plan {
        from: world.plan.from.clone(),
        until: world.plan.until.clone(),
        slept: world.plan.slept.clone(),
        knows: Some(world.at),
        ..Plan::default()
    };
    for timeline in world.after.timelines() {
        let name = timeline.name();
        let goes_on = world.members.iter().any(|member| member.name == name);
        let removed = timeline.until == Some(world.at);
        if !goes_on && !removed {
            let trajectory = Trajectory::of(world.after, timeline, world.plan);
            let path = trajectory.map_or(world.plan.path(name), |trajectory| trajectory.path);
            plan.paths.insert(name.to_owned(), path.to_vec());
            plan.charges
                .insert(name.to_owned(), world.plan.charges(name).to_vec());
            continue;
        }
        if timeline.from > 0 {
            plan.from.insert(name.to_owned(), timeline.from);
        }
        let before = world.before.timelines().iter().find(|c| c.name() == name);
        let trajectory =
            before.and_then(|timeline| Trajectory::of(world.before, timeline, world.plan));
        let mut path: Vec<Option<Cell>> = Vec::new();
        if let Some(trajectory) = trajectory {
            path.extend(
                (timeline.from..world.at).map(|time| match trajectory.place(time) {
                    Whereabouts::At(cell) => Some(cell),
                    _ => None,
                }),
            );
            let mut charges = trajectory.charges.to_vec();
            charges.retain(|&time| time < world.at);
            plan.charges.insert(name.to_owned(), charges);
        }
        plan.paths.insert(name.to_owned(), path);
        if removed {
            plan.until.insert(name.to_owned(), world.at);
        }
    }
    plan
}
