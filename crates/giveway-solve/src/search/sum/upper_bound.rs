//! A good plan out of a model that was only asked for to end a round.
//!
//! The agents that no core of the round names have walks of the levels assumed;
//! those that cores set free are planned around them, and the result is
//! improved. Its cost lies near the bound, where plans improved from the first
//! one on come late.

use std::collections::BTreeSet;

use giveway_model::Cost;

use super::{SumStage, agent_of};
use crate::{
    budget::Stop,
    encode::collisions::AgentId,
    local::{OtherAgents, Query, Reservations, plan_one},
    search::{incumbent::free_of_collisions, stage::Search},
    trace::FoundBy,
};

/// States to look at for one agent.
const EXPANSION_LIMIT: u32 = 20_000;
/// States of single agents that are looked at each time, about.
const STATES: u64 = 10_000;
/// Times that a plan is improved, as long as it becomes better.
const MOST_IMPROVEMENTS: usize = 20;

impl SumStage<'_> {
    /// Makes a plan of the last model, if agents find a way around the others.
    pub(super) fn improve_upper_bound(&self, search: &mut Search) -> Result<(), Stop> {
        let budget = &search.budget;
        let early = budget.derived() < budget.thresholds().upper_bound_after;
        if early || self.known || self.cost != Cost::SumOfCosts {
            return Ok(());
        }
        search.team.read();
        let problem = search.problem;
        let mut walks = search.team.walks.clone();
        let mut others = Reservations::of(problem, &walks);
        let mut free: BTreeSet<AgentId> = self.oll.waiting.iter().filter_map(agent_of).collect();
        for &agent in &free {
            others.remove(agent, &walks[agent]);
        }
        for (agent, walk) in walks.iter().enumerate() {
            if !search.team.is_inside(agent) && !others.met_by(agent, walk).is_empty() {
                others.remove(agent, walk);
                free.insert(agent);
            }
        }
        for agent in free {
            let query = Query {
                agent,
                latest: search.cap(agent),
                conflict_penalty: None,
                expansion_limit: EXPANSION_LIMIT,
            };
            let Some((walk, _)) = plan_one(problem, &others, query, &search.budget)? else {
                return Ok(());
            };
            walks[agent] = walk;
            others.add(agent, &walks[agent]);
        }
        if !free_of_collisions(problem, &walks) {
            return Ok(()); // (a plan has to be one, whatever the model says)
        }
        for _ in 0..MOST_IMPROVEMENTS {
            let given = (&mut walks, FoundBy::PartlySolver);
            if !search.improve(given, self.cost, self.bound.at_least(), STATES)? {
                break;
            }
            walks = search
                .incumbent
                .walks()
                .map_or_else(Vec::new, <[_]>::to_vec);
        }
        Ok(())
    }
}
