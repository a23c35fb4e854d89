//! Where an agent loses time against its best way alone.
//!
//! At each time of a walk the agent could leave the others out of account and go on by the best
//! way that its state still allows: f = the time so far plus the exact rest alone, as in A*. Along
//! a walk f never falls, and where it rises, the steps are lost.

use crate::{
    AgentId,
    budget::{Budget, Stop},
    problem::Problem,
    single::{Place, State, earliest_from},
    walk::arrival,
};

/// The earliest arrival of an agent alone from its state at each time of a walk of its own,
/// from 0 to its arrival, where it charges at some times; `None` where the walk is none of its
/// task.
///
/// # Errors
/// When the budget is spent.
pub fn earliest_arrivals(
    problem: &Problem,
    agent: AgentId,
    walk: &[Place],
    charges: &[u32],
    budget: &dyn Budget,
) -> Result<Option<Vec<u32>>, Stop> {
    let Some(states) = states(problem, agent, walk, charges) else {
        return Ok(None);
    };
    let mut found = EarliestArrivals {
        problem,
        agent,
        f_values: vec![0; states.len()],
        states,
    };
    let last = arrival(walk);
    let Some(first) = found.earliest_at(0, budget)? else {
        return Ok(None);
    };
    found.set(0, first);
    found.set(last, last);
    found.between((0, first), (last, last), budget)?;
    Ok(Some(found.f_values))
}

/// The states of an agent along a walk; `None` where a step of it is none of its task.
fn states(
    problem: &Problem,
    agent: AgentId,
    walk: &[Place],
    charges: &[u32],
) -> Option<Vec<State>> {
    let task = problem.tasks.get(agent)?;
    let mut state = task.first()?;
    if walk.first() != Some(&state.place) {
        return None;
    }
    let mut states = vec![state];
    for (place, now) in walk.iter().skip(1).zip(0..) {
        let mut next = None;
        task.onward(
            &problem.terrain,
            state,
            now,
            charges.contains(&now),
            |step| {
                if step.to.place == *place {
                    next = Some(step.to);
                }
            },
        );
        state = next?;
        states.push(state);
    }
    Some(states)
}

/// The f-values of a walk.
struct EarliestArrivals<'p> {
    problem: &'p Problem,
    agent: AgentId,
    states: Vec<State>,
    f_values: Vec<u32>,
}

impl EarliestArrivals<'_> {
    fn earliest_at(&self, time: u32, budget: &dyn Budget) -> Result<Option<u32>, Stop> {
        let (problem, agent) = (self.problem, self.agent);
        let Some(&state) = self.states.get(time as usize) else {
            return Ok(None);
        };
        let task = &problem.tasks[agent];
        let cost_to_go = &problem.cost_to_go[agent];
        earliest_from(task, &problem.terrain, cost_to_go, (state, time), budget)
    }

    fn set(&mut self, time: u32, f_value: u32) {
        if let Some(place) = self.f_values.get_mut(time as usize) {
            *place = f_value;
        }
    }

    /// Fills in what lies between two times: f never falls, so between equal values it is the
    /// same, and few searches are needed.
    fn between(
        &mut self,
        (begin, least): (u32, u32),
        (end, most): (u32, u32),
        budget: &dyn Budget,
    ) -> Result<(), Stop> {
        if least == most {
            (begin..end).for_each(|time| self.set(time, least));
            return Ok(());
        }
        let middle = begin.midpoint(end);
        if middle == begin {
            return Ok(());
        }
        // From each state of a walk its own rest leads on.
        let found = self.earliest_at(middle, budget)?.unwrap_or(most);
        self.set(middle, found);
        self.between((begin, least), (middle, found), budget)?;
        self.between((middle, found), (end, most), budget)
    }
}
