//! Rules on the rest of a plan: what agents have done before time 0.

use giveway_model::{Cost, StartState, condition::Times, constraint::InForce};

use super::{
    OwnRules,
    alone::{forbid, slow_arcs},
};
use crate::{
    AgentId,
    single::{Act, Area, Counter, Entry, Left, Penalty, Task},
    terrain::Terrain,
};

impl OwnRules<'_> {
    pub(super) fn state(&self, agent: AgentId) -> &StartState {
        let agent = self.instance.agents().get(agent);
        let name = agent.map_or("", |agent| agent.name.as_str());
        self.instance.start_state(name)
    }

    /// Makes an agent arrive at some of these times, for a rule of this number. One that arrived before time 0 may stay,
    /// where that was allowed; with no time left it must.
    pub(super) fn arrive(&self, rule: usize, agent: AgentId, times: Times, task: &mut Task) {
        let state = self.state(agent);
        let has_rested = task.cost_if_it_leaves_goal > 0;
        let may_stay = has_rested && !state.must_go_on.contains(&rule);
        let is_past = times.first() > times.last();
        if is_past {
            task.conditions.limit(Cost::Makespan, 0);
            if !may_stay {
                task.not_before = task.not_before.max(1);
            }
            return;
        }
        if times.first() > 0 || has_rested {
            task.conditions.counters.push(Counter::Entry(Entry {
                from: times.first(),
                stood: has_rested,
                may_stay,
            }));
        }
        if let Some(by) = times.to {
            task.conditions.limit(Cost::Makespan, by);
        }
    }

    /// What happened before time 0, as far as rules keep an agent from something for it.
    pub(super) fn impose_past(&self, agent: AgentId, task: &mut Task, terrain: &Terrain) {
        let state = self.state(agent);
        let rules = self.instance.constraints().len();
        for closed in state.closed_cells.iter().filter(|it| it.rule < rules) {
            if let Some(v) = terrain.vertex(closed.cell) {
                let to = (closed.until < u32::MAX).then_some(closed.until);
                let times = Times { from: None, to };
                forbid(task, Act::Stand(Area::One(v)), times);
            }
        }
        if state.penalty_if_it_goes_on > 0 && task.cost_if_it_leaves_goal > 0 {
            let penalty = Penalty::GoingOn(state.penalty_if_it_goes_on);
            task.penalties.push(penalty);
        }
    }
}

/// A zone that does not count an agent until it has left; then it may be closed at some times.
pub(super) fn left(
    rule: &InForce<'_>,
    area: Area,
    (closed, rests): (Option<Times>, bool),
    terrain: &Terrain,
) -> Counter {
    let arcs = slow_arcs(terrain, &area);
    Counter::Left(Left {
        rule: rule.index,
        area,
        arcs,
        closed,
        rests,
    })
}
