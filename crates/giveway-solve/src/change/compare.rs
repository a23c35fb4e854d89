//! Compares the new plan with the old one, agent by agent.

use giveway_model::{Plan, change::Trajectory, compare::Difference, snapshot::Snapshot};

/// Agents by what the new plan makes of them.
#[derive(Default)]
pub(super) struct AgentsCompared {
    pub(super) kept: Vec<String>,
    pub(super) retimed: Vec<String>,
    pub(super) rerouted: Vec<String>,
    pub(super) added: Vec<String>,
}

/// Compares a new plan with the old one, from the change on.
pub(super) fn compare(snapshot: &Snapshot<'_>, plan: &Plan) -> AgentsCompared {
    let mut comparison = AgentsCompared::default();
    for timeline in snapshot.history.timelines() {
        if timeline.until.is_some() {
            continue;
        }
        let agents = snapshot.instance.agents().iter().zip(&snapshot.agents);
        let old = agents
            .clone()
            .find(|(agent, _)| agent.name == timeline.name());
        let new = Trajectory::of(snapshot.history, timeline, plan);
        let list = match (old, new) {
            (Some((_, old)), _) if !old.is_old => &mut comparison.added,
            (Some((_, old)), Some(new)) => {
                let (path, charges) = new.rest(snapshot.at);
                match Difference::between((&old.path, &old.charges), (&path, &charges)) {
                    Difference::Same => &mut comparison.kept,
                    Difference::Retimed => &mut comparison.retimed,
                    Difference::Rerouted => &mut comparison.rerouted,
                }
            }
            // It has vanished, and its path is past.
            (Some(_), None) | (None, _) => &mut comparison.kept,
        };
        list.push(timeline.name().to_owned());
    }
    comparison
}
