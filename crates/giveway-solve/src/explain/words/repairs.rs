//! Repairs, as sentences.

use giveway_model::Costs;

use super::list::{and, capital};
use crate::explain::answer::Edit;

/// A repair with what it leads to.
pub(crate) fn repair(edits: &[Edit], costs: &Costs) -> String {
    format!(
        "{}: makespan {}, sum of costs {}.",
        edits_in_words(edits),
        costs.makespan,
        costs.sum_of_costs
    )
}

/// Edits as a sentence without its full stop: `Remove the obstacle at (3, 1)`.
///
/// ```
/// use giveway_model::Cell;
/// use giveway_solve::explain::{Edit, edits_in_words};
/// let edit = Edit::RemoveObstacle { cell: Cell::new(3, 1) };
/// assert_eq!(edits_in_words(&[edit]), "Remove the obstacle at (3, 1)");
/// ```
pub fn edits_in_words(edits: &[Edit]) -> String {
    let phrases: Vec<String> = edits.iter().map(phrase).collect();
    capital(&and(&phrases))
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
        Edit::Vanish => "let robots leave the map at their goals".to_owned(),
        Edit::LeaveOut { agent } => format!("leave {agent} out"),
    }
}
