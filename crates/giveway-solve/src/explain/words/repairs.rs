//! Repairs, as sentences.

use giveway_model::Costs;

use super::list::{and, capital};
use crate::explain::answer::Edit;

/// A repair with what it leads to.
pub(crate) fn repair(edits: &[Edit], costs: &Costs) -> String {
    let phrases: Vec<String> = edits.iter().map(phrase).collect();
    format!(
        "{}: makespan {}, sum of costs {}.",
        capital(&and(&phrases)),
        costs.makespan,
        costs.sum_of_costs
    )
}

fn phrase(edit: &Edit) -> String {
    match edit {
        Edit::RemoveObstacle { cell } => format!("remove the obstacle at {cell}"),
        Edit::AddCharger { cell } => format!("put a charger at {cell}"),
        Edit::Battery {
            agent,
            capacity,
            initial,
        } => format!("give {agent} a battery of {capacity} with {initial} in it"),
        Edit::Deadline { within } => format!("allow until time {within}"),
        Edit::MakeNormal { cell } => format!("make {cell} normal ground"),
        Edit::DropWaypoint { agent, cell } => format!("let {agent} leave {cell} out"),
        Edit::Vanish => "let agents vanish at their goals".to_owned(),
        Edit::LeaveOut { agent } => format!("leave {agent} out"),
    }
}
