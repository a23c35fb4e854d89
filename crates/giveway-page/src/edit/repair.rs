//! A repair of an answer as edits.

use giveway_model::{Agent, AtGoal, Battery};
use giveway_solve::explain;

use super::{Edit, Paint, Weaker};

/// The edits of a repair; agents are told by their names there. One whose name no
/// agent has is left out.
pub(crate) fn repair(edits: &[explain::Edit], agents: &[Agent]) -> Vec<Edit> {
    let index = |name: &str| agents.iter().position(|agent| agent.name == name);
    let one = |edit: &explain::Edit| {
        Some(match edit {
            explain::Edit::RemoveObstacle { cell } => Edit::Paint(Paint::Obstacle, *cell, false),
            explain::Edit::AddCharger { cell } => Edit::Paint(Paint::Charger, *cell, true),
            explain::Edit::MakeNormal { cell } => Edit::Paint(Paint::Slow, *cell, false),
            explain::Edit::Battery {
                agent,
                capacity,
                initial,
            } => {
                let battery = Battery {
                    capacity: *capacity,
                    initial: *initial,
                };
                Edit::SetBattery(index(agent)?, Some(battery))
            }
            explain::Edit::BatteryFloor { floor } => Edit::BatteryFloor(*floor),
            explain::Edit::Deadline { within } => Edit::Within(Some(*within)),
            explain::Edit::DropWaypoint { agent, cell } => Edit::DropWaypoint(index(agent)?, *cell),
            explain::Edit::Vanish => Edit::AtGoal(AtGoal::Vanish),
            explain::Edit::LeaveOut { agent } => Edit::RemoveAgent(index(agent)?),
            explain::Edit::SwitchOff { index, .. } => {
                Edit::WeakenRule(*index as usize, Weaker::Off)
            }
            explain::Edit::AllowMore { index, most, .. } => {
                Edit::WeakenRule(*index as usize, Weaker::Most(*most))
            }
            explain::Edit::GiveUntil { index, to, .. } => {
                Edit::WeakenRule(*index as usize, Weaker::Until(*to))
            }
        })
    };
    // Whoever is left out goes last, so that the others keep their places.
    let (mut others, mut out): (Vec<_>, Vec<_>) = edits
        .iter()
        .filter_map(one)
        .partition(|edit| !matches!(edit, Edit::RemoveAgent(_)));
    out.sort_by_key(|edit| match edit {
        Edit::RemoveAgent(agent) => std::cmp::Reverse(*agent),
        _ => std::cmp::Reverse(0),
    });
    others.append(&mut out);
    others
}
