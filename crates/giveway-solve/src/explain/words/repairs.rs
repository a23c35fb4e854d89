//! Repairs, as sentences.

use giveway_model::Costs;
use giveway_model::words::{and, capital};

use crate::explain::answer::Edit;

/// A repair with what it leads to.
pub(crate) fn repair(edits: &[Edit], costs: &Costs) -> String {
    led_to(&edits_in_words(edits), costs) + "."
}

/// Edits with what they lead to: `remove the obstacle at (3, 1): makespan 4, sum of costs 7`.
pub(super) fn led_to(edits: &str, costs: &Costs) -> String {
    let (makespan, sum) = (costs.makespan, costs.sum_of_costs);
    format!("{edits}: makespan {makespan}, sum of costs {sum}")
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
    capital(&phrase(edits))
}

/// Edits in the middle of a sentence.
pub(super) fn phrase(edits: &[Edit]) -> String {
    let phrases: Vec<String> = edits.iter().map(one).collect();
    and(&phrases)
}

fn one(edit: &Edit) -> String {
    match edit {
        Edit::RemoveObstacle { cell } => format!("remove the obstacle at {cell}"),
        Edit::AddCharger { cell } => format!("put a charger at {cell}"),
        Edit::Battery {
            agent,
            capacity,
            initial,
        } => format!("give {agent} a battery that holds {capacity} and starts at {initial}"),
        Edit::Deadline { within } => format!("give all robots until time {within}"),
        Edit::MakeNormal { cell } => format!("take {cell} out of the slow zone"),
        Edit::DropWaypoint { agent, cell } => format!("let {agent} skip {cell}"),
        Edit::Vanish => "let robots leave the map at their goals".to_owned(),
        Edit::LeaveOut { agent } => format!("leave {agent} out"),
    }
}
