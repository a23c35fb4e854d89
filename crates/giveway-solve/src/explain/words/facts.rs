//! Facts that can be left out, as clauses.

use giveway_model::Instance;

use crate::explain::group::Group;

/// A fact as a clause: `A1 must visit (2, 1)`.
pub(crate) fn fact(group: Group, instance: &Instance, within: Option<u32>) -> String {
    let agent = |a: usize| instance.agents().get(a);
    let name = |a: usize| agent(a).map_or("", |agent| agent.name.as_str());
    match group {
        Group::Task(a) => agent(a).map_or_else(String::new, |a| {
            format!("{} must go from {} to {}", a.name, a.start, a.goal)
        }),
        Group::Waypoint(a, cell) => format!("{} must visit {cell}", name(a)),
        Group::Battery(a) => {
            let battery = agent(a).and_then(|agent| agent.battery);
            battery.map_or_else(String::new, |battery| {
                let (initial, capacity) = (battery.initial, battery.capacity);
                format!(
                    "the battery of {} holds {capacity} and starts at {initial}",
                    name(a)
                )
            })
        }
        Group::Obstacle(cell) => format!("{cell} is an obstacle"),
        Group::Collision(a, b) => format!("{} and {} must not collide", name(a), name(b)),
        Group::Stay(a) => {
            let goal = agent(a).map(|agent| agent.goal.to_string());
            format!("{} stays at its goal {}", name(a), goal.unwrap_or_default())
        }
        Group::Slow => "moves in the slow zone take 2 steps".to_owned(),
        Group::Deadline => {
            let within = within.unwrap_or_default();
            format!("every robot must arrive by time {within}")
        }
    }
}
