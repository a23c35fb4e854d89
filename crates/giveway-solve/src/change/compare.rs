//! What became of each old agent.

use giveway_model::{
    Cell, Plan,
    change::{History, Trajectory},
    compare::Difference,
};

use super::world::World;

/// Agents by what the new plan makes of them.
#[derive(Default)]
pub(super) struct Comparison {
    pub(super) kept: Vec<String>,
    pub(super) retimed: Vec<String>,
    pub(super) rerouted: Vec<String>,
    pub(super) added: Vec<String>,
}

/// Compares a new plan with the old one, from the change on.
pub(super) fn compare(world: &World<'_>, plan: &Plan) -> Comparison {
    let mut comparison = Comparison::default();
    for (index, timeline) in world.after.timelines().iter().enumerate() {
        let name = timeline.name().to_owned();
        if timeline.until.is_some() {
            continue;
        }
        if world.before.timelines().len() <= index {
            comparison.added.push(name);
            continue;
        }
        let (old, new) = (
            rest(world.before, index, world.plan, world.at),
            rest(world.after, index, plan, world.at),
        );
        let list = match Difference::between((&old.0, &old.1), (&new.0, &new.1)) {
            Difference::Same => &mut comparison.kept,
            Difference::Retimed => &mut comparison.retimed,
            Difference::Rerouted => &mut comparison.rerouted,
        };
        list.push(name);
    }
    comparison
}

/// The entries and the charges of an agent from a time on.
fn rest(history: &History, index: usize, plan: &Plan, at: u32) -> (Vec<Option<Cell>>, Vec<u32>) {
    let timeline = history.timelines().get(index);
    let Some(trajectory) = timeline.and_then(|timeline| Trajectory::of(history, timeline, plan))
    else {
        return Default::default();
    };
    let entries = (at..=trajectory.end().max(at))
        .map(|time| trajectory.at(time))
        .collect();
    let charges = trajectory
        .charges
        .iter()
        .copied()
        .filter(|&time| time >= at);
    (entries, charges.collect())
}
