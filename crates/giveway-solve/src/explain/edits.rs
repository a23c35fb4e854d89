//! Changes that a person may make, and the instance after them.

use std::collections::BTreeSet;

use giveway_model::{AtGoal, Battery, Ground, Instance, Scene};

use super::{
    answer::Edit,
    group::{Variant, redraw},
};
use crate::problem::Relaxed;

/// The scene after some edits, deadlines apart, which are no part of it.
///
/// ```
/// use giveway_model::{Cell, format::native};
/// use giveway_solve::explain::{Edit, edited_scene};
/// let instance = native::read_instance(r#"{ "giveway": 1, "map": [".#."],
///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] }] }"#).unwrap();
/// let edit = Edit::RemoveObstacle { cell: Cell::new(1, 0) };
/// assert_eq!(edited_scene(&instance, &[edit]).map, ["..."]);
/// ```
pub fn edited_scene(instance: &Instance, edits: &[Edit]) -> Scene {
    edited(instance, edits, None).scene
}

/// The instance after some edits.
pub(crate) fn edited(instance: &Instance, edits: &[Edit], within: Option<u32>) -> Variant {
    let mut scene = instance.to_scene();
    let mut within = within;
    let mut free = BTreeSet::new();
    let mut chargers = BTreeSet::new();
    let mut normal = BTreeSet::new();
    for edit in edits {
        match edit {
            Edit::RemoveObstacle { cell } => {
                free.insert(*cell);
            }
            Edit::AddCharger { cell } => {
                chargers.insert(*cell);
            }
            Edit::MakeNormal { cell } => {
                normal.insert(*cell);
            }
            Edit::Battery {
                agent,
                capacity,
                initial,
            } => {
                if let Some(agent) = scene.agents.iter_mut().find(|a| a.name == *agent) {
                    agent.battery = Some(Battery {
                        capacity: *capacity,
                        initial: *initial,
                    });
                }
            }
            Edit::Deadline { within: later } => within = Some(*later),
            Edit::DropWaypoint { agent, cell } => {
                if let Some(agent) = scene.agents.iter_mut().find(|a| a.name == *agent) {
                    agent.waypoints.retain(|w| w != cell);
                }
            }
            Edit::Vanish => scene.rules.at_goal = AtGoal::Vanish,
            Edit::LeaveOut { agent } => scene.agents.retain(|a| a.name != *agent),
        }
    }
    scene.map = redraw(instance.grid(), |cell, ground| {
        let freed = ground == Ground::Obstacle && free.contains(&cell);
        let ground = if freed { Ground::Free } else { ground };
        let slow = ground.is_slow() && !normal.contains(&cell);
        let charger = ground.is_charger() || (ground.is_vertex() && chargers.contains(&cell));
        match (ground, slow, charger) {
            (Ground::Obstacle, ..) => Ground::Obstacle,
            (_, false, false) => Ground::Free,
            (_, false, true) => Ground::Charger,
            (_, true, false) => Ground::Slow,
            (_, true, true) => Ground::SlowCharger,
        }
    });
    Variant {
        scene,
        relaxed: Relaxed::default(),
        within,
    }
}
