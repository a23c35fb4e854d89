//! Changes that a person may make, and the instance after them.

use std::collections::BTreeSet;

use giveway_model::{Battery, Cell, Instance, constraint::ConstraintKind};

use super::{answer::Edit, group::Variant, whole::WholePlan};
use crate::problem::Relaxed;

/// The instance after some edits, deadlines apart, which are no part of it.
///
/// ```
/// use giveway_model::{Cell, format::native};
/// use giveway_solve::explain::{Edit, edited_instance};
/// let instance = native::read_instance(r#"{ "giveway": 1, "map": [".#."],
///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] }] }"#).unwrap();
/// let edit = Edit::RemoveObstacle { cell: Cell::new(1, 0) };
/// assert_eq!(edited_instance(&instance, &[edit]).grid().rows(), ["..."]);
/// ```
pub fn edited_instance(instance: &Instance, edits: &[Edit]) -> Instance {
    edited(instance, edits, None, WholePlan::default()).instance
}

/// Gives a rule of the scene's own a kind that asks for less, where it has one.
fn weaken(
    instance: &mut Instance,
    index: u32,
    weaker: impl Fn(&ConstraintKind) -> Option<ConstraintKind>,
) {
    let index = index as usize;
    let rule = instance.constraints().get(index);
    if let Some(kind) = rule.and_then(|rule| weaker(&rule.kind)) {
        instance.weaken_rule(index, kind);
    }
}

/// The instance after some edits; of the rest of a running plan, what rules count of its past
/// is counted anew.
pub(crate) fn edited(
    instance: &Instance,
    edits: &[Edit],
    within: Option<u32>,
    whole: WholePlan,
) -> Variant {
    let last_times = edits.iter().filter_map(|edit| match edit {
        Edit::GiveUntil { index, to, .. } => Some((*index as usize, *to)),
        Edit::RemoveObstacle { .. }
        | Edit::AddCharger { .. }
        | Edit::Battery { .. }
        | Edit::BatteryFloor { .. }
        | Edit::Deadline { .. }
        | Edit::MakeNormal { .. }
        | Edit::DropWaypoint { .. }
        | Edit::Vanish
        | Edit::LeaveOut { .. }
        | Edit::SwitchOff { .. }
        | Edit::AllowMore { .. } => None,
    });
    let last_times: Vec<(usize, u32)> = last_times.collect();
    let counted_anew = if last_times.is_empty() {
        None
    } else {
        whole.with_last_times(instance, &last_times)
    };
    let is_counted_anew = counted_anew.is_some();
    let mut after = counted_anew.unwrap_or_else(|| instance.clone());
    let mut within = within;
    let mut free: BTreeSet<Cell> = BTreeSet::new();
    let mut chargers: BTreeSet<Cell> = BTreeSet::new();
    let mut normal: BTreeSet<Cell> = BTreeSet::new();
    let mut left_out: Vec<&str> = Vec::new();
    for edit in edits {
        let number = |name: &String| after.agents().iter().position(|a| a.name == *name);
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
                if let Some(agent) = number(agent) {
                    let (capacity, initial) = (*capacity, *initial);
                    after.replace_battery(agent, Battery { capacity, initial });
                }
            }
            Edit::BatteryFloor { floor } => after = after.with_battery_floor(*floor),
            Edit::Deadline { within: later } => within = Some(*later),
            Edit::DropWaypoint { agent, cell } => {
                if let Some(agent) = number(agent) {
                    after.drop_waypoint(agent, *cell);
                }
            }
            Edit::Vanish => after.let_agents_vanish(),
            // At the end, since rules that bind nobody any more go with it.
            Edit::LeaveOut { agent } => left_out.push(agent.as_str()),
            Edit::SwitchOff { index, .. } => after.switch_off(|other| other == *index as usize),
            Edit::AllowMore { index, most, .. } => {
                weaken(&mut after, *index, |kind| kind.with_most(*most));
            }
            Edit::GiveUntil { index, to, .. } if !is_counted_anew => {
                weaken(&mut after, *index, |kind| kind.with_last_time(*to));
            }
            Edit::GiveUntil { .. } => {}
        }
    }
    for agent in left_out {
        after.leave_out(agent);
    }
    after.remove_obstacles(|cell| free.contains(&cell));
    after.make_normal(|cell| normal.contains(&cell));
    after.add_chargers(|cell| chargers.contains(&cell));
    Variant {
        instance: after,
        relaxed: Relaxed::default(),
        within,
    }
}
