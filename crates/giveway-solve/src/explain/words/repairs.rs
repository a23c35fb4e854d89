//! Repairs, as sentences.

use giveway_model::tr;
use giveway_model::words::{and, capital};

use crate::explain::answer::{Edit, Repair};

/// A repair with what it leads to, whether less is proved not to help, and whether no plan is
/// better then. `arriving` is the agent whose arrival is asked about.
pub(crate) fn repair(repair: &Repair, arriving: Option<&str>) -> String {
    let told = led_to(&edits_in_words(&repair.edits), repair, arriving);
    if repair.least {
        told + "."
    } else {
        tr!("{repair}. Perhaps less would do.", repair = told)
    }
}

/// Edits with what they lead to: `remove the obstacle at (3, 1): makespan 4, sum of costs 7`; where
/// a better plan may exist, that is said.
pub(super) fn led_to(edits: &str, repair: &Repair, arriving: Option<&str>) -> String {
    let (makespan, sum) = (repair.costs.makespan, repair.costs.sum_of_costs);
    let led_to = match (arriving, repair.arrival) {
        (Some(name), Some(arrival)) => tr!(
            "{edits}: {name} arrives at {arrival}, makespan {makespan}, sum of costs {sum}",
            edits,
            name,
            arrival,
            makespan,
            sum
        ),
        _ => tr!(
            "{edits}: makespan {makespan}, sum of costs {sum}",
            edits,
            makespan,
            sum
        ),
    };
    if repair.proved {
        led_to
    } else {
        tr!("{led_to}, or less", led_to)
    }
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
        Edit::RemoveObstacle { cell } => tr!("remove the obstacle at {cell}", cell),
        Edit::AddCharger { cell } => tr!("put a charger at {cell}", cell),
        Edit::Battery {
            agent,
            capacity,
            initial,
        } => tr!(
            "give {agent} a battery that holds {capacity} and starts at {initial}",
            agent,
            capacity,
            initial
        ),
        Edit::BatteryFloor { floor } => tr!("lower the battery floor to {floor}", floor),
        Edit::Deadline { within } => tr!("give all robots until time {within}", within),
        Edit::MakeNormal { cell } => tr!("take {cell} out of the slow zone", cell),
        Edit::DropWaypoint { agent, cell } => tr!("let {agent} skip {cell}", agent, cell),
        Edit::Vanish => tr!("let robots leave the map at their goals").to_owned(),
        Edit::LeaveOut { agent } => tr!("leave {agent} out", agent),
        Edit::SwitchOff { rule, .. } => tr!("switch off {rule}", rule),
        Edit::AllowMore { rule, most, .. } => {
            tr!("raise the limit of {rule} to {most}", rule, most)
        }
        Edit::GiveUntil { rule, to, .. } => tr!("extend {rule} to time {to}", rule, to),
    }
}
