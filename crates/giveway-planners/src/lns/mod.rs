//! A plan made better: large neighbourhood search.
//!
//! Again and again a few agents are taken out of the plan and planned anew, in
//! random order, each around all others; the result is kept where it is no worse
//! (MAPF-LNS; Li, Chen, Harabor, Stuckey and Koenig 2021). Which agents, one of
//! several [`neighbourhood`]s says, each tried the more often the more it has
//! gained of late ([`adaptive`]).

mod adaptive;
mod neighbourhood;
mod replan;
mod tally;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;

use fastrand::Rng;
use giveway_model::Objective;

use crate::{
    AgentId,
    budget::{Budget, CountedBudget, Stop},
    local::{OtherAgents, Reservations, Timetable},
    problem::Problem,
    walk::{Walk, arrival},
};
use adaptive::Adaptive;
use neighbourhood::Neighbourhoods;
use replan::{Plan, Tie};

/// A search that can be continued; the same calls give the same plans.
pub struct Lns {
    rng: Rng,
    adaptive: Adaptive,
    /// Delayed agents that a neighbourhood began with of late.
    tabu: BTreeSet<AgentId>,
}

impl Default for Lns {
    /// A search at its beginning.
    fn default() -> Self {
        Self {
            rng: Rng::with_seed(7),
            adaptive: Adaptive::default(),
            tabu: BTreeSet::new(),
        }
    }
}

/// The limits of a search.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// The states of single agents to look at, about.
    pub states: u64,
    /// The latest arrival of any agent.
    pub horizon: u32,
    /// A value of the first cost that is as good as need be.
    pub enough: u32,
}

/// Plans each agent anew among all others, again and again, until nobody gains by it, or as
/// many states were looked at as there may be; true where the plan became better. Nobody
/// arrives later than at the plan's makespan.
///
/// The walks are a plan in any case, no worse than before.
pub fn descend(
    problem: &Problem,
    walks: &mut [Walk],
    objective: &Objective,
    states: u64,
    budget: &dyn Budget,
) -> bool {
    let counted = CountedBudget::new(budget, states);
    let horizon = walks.iter().map(|walk| arrival(walk)).max().unwrap_or(0);
    match Timetable::of(problem, walks) {
        Some(table) => Plan::new(table, walks, objective, horizon).descend(&counted),
        None => {
            Plan::new(Reservations::of(problem, walks), walks, objective, horizon).descend(&counted)
        }
    }
}

impl Lns {
    /// Tries neighbourhoods until the effort is spent, or nobody could arrive
    /// sooner; true where the plan became better.
    ///
    /// # Errors
    /// When the budget is spent; the walks are a plan then, too.
    pub fn improve(
        &mut self,
        problem: &Problem,
        walks: &mut [Walk],
        effort: Effort,
        objective: &Objective,
        budget: &dyn Budget,
    ) -> Result<bool, Stop> {
        let counted = CountedBudget::new(budget, u64::MAX);
        match Timetable::of(problem, walks) {
            Some(table) => self.rounds(table, walks, effort, objective, &counted),
            None => self.rounds(
                Reservations::of(problem, walks),
                walks,
                effort,
                objective,
                &counted,
            ),
        }
    }

    fn rounds<O: OtherAgents>(
        &mut self,
        others: O,
        walks: &mut [Walk],
        effort: Effort,
        objective: &Objective,
        counted: &CountedBudget,
    ) -> Result<bool, Stop> {
        let mut plan = Plan::new(others, walks, objective, effort.horizon);
        let first = plan.vector();
        while counted.states() < effort.states && plan.first_cost() > effort.enough {
            counted.check()?;
            let kind = self.adaptive.choose(&mut self.rng);
            let mut neighbourhoods = Neighbourhoods {
                plan: &plan,
                rng: &mut self.rng,
                tabu: &mut self.tabu,
            };
            let Some(group) = neighbourhoods.choose(kind) else {
                break;
            };
            counted.count(group.len() as u64);
            counted.spend(group.len() as u64)?;
            let gain = plan.replan(&group, Tie::New, counted)?;
            self.adaptive.learn(kind, gain);
        }
        Ok(plan.vector() < first)
    }
}
