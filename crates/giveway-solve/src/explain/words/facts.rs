//! Facts that can be left out, as clauses.

use giveway_model::{Breakdown, Constraint, Instance, tr};

use crate::explain::group::Group;

/// A fact as a clause: `A1 must visit (2, 1)`.
pub(crate) fn fact(group: Group, instance: &Instance, within: Option<u32>) -> String {
    let agent = |a: usize| instance.agents().get(a);
    let name = |a: usize| agent(a).map_or("", |agent| agent.name.as_str());
    match group {
        Group::Task(a) => agent(a).map_or_else(String::new, |a| match a.goal {
            Some(goal) => tr!(
                "{agent} must go from {start} to {goal}",
                agent = a.name,
                start = a.start,
                goal
            ),
            None => tr!(
                "{agent} starts at {start} and may rest at any cell",
                agent = a.name,
                start = a.start
            ),
        }),
        Group::Waypoint(a, cell) => tr!("{name} must visit {cell}", name = name(a), cell),
        Group::Battery(a) => {
            let battery = agent(a).and_then(|agent| agent.battery);
            battery.map_or_else(String::new, |battery| {
                let (initial, capacity) = (battery.initial, battery.capacity);
                tr!(
                    "the battery of {name} holds {capacity} and starts at {initial}",
                    name = name(a),
                    capacity,
                    initial
                )
            })
        }
        Group::Obstacle(cell) => tr!("{cell} is an obstacle", cell),
        Group::Collision(a, b) => tr!("{a} and {b} must not collide", a = name(a), b = name(b)),
        Group::Stay(a) => match agent(a).and_then(|agent| agent.goal) {
            Some(goal) => tr!("{name} stays at its goal {goal}", name = name(a), goal),
            None => tr!("{name} stays where it rests", name = name(a)),
        },
        Group::Slow => tr!("moves in the slow zone take 2 steps").to_owned(),
        Group::Deadline => {
            let within = within.unwrap_or_default();
            tr!("every robot must arrive by time {within}", within)
        }
        Group::Floor => {
            let floor = instance.rules().battery_floor;
            tr!("no battery may fall below {floor}", floor)
        }
        Group::Constraint(index) => {
            let rule = group.constraint(instance);
            let rule = rule.map_or_else(String::new, Constraint::fact);
            match instance.rule_added_at(index) {
                Some(time) => tr!("{rule}, added at time {time}", rule, time),
                None => rule,
            }
        }
        Group::Breakdown(a, _) => group
            .breakdown(instance)
            .map_or_else(String::new, |it| broken_down(name(a), it)),
    }
}

/// A breakdown as a clause: `A1 is broken down from time 3 to 43`.
pub(super) fn broken_down(agent: &str, breakdown: &Breakdown) -> String {
    tr!(
        "{agent} is broken down from time {from} to {to}",
        agent,
        from = breakdown.from,
        to = breakdown.to
    )
}
