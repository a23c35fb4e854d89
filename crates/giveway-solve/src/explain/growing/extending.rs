//! Plans of some agents carried over to more agents.

use std::collections::BTreeSet;
use std::rc::Rc;

use giveway_model::{Instance, Plan, check::arrivals};

use crate::{
    budget::Budget,
    explain::{ask::names, causes::Refuted, group::fit, group_mus::Inquiry, lone_walk::replaced},
    local::{OtherAgents, Query, Reservations, plan_one},
    problem::Problem,
    walk::{Walk, of_path, to_plan},
};

use super::only;

/// States that are looked at for the walk of one agent beside the others.
const STATES: u32 = 40_000;
/// Known plans whose paths are tried.
const KNOWN: usize = 6;

/// Carries plans over to more agents: by paths of known plans, then by walks that keep clear of
/// those who have one (prioritised planning).
pub(crate) struct Extending<'a, 'h> {
    instance: &'a Instance,
    known: Vec<Plan>,
    planning: Option<Planning<'h>>,
    /// The agents, those that found no place most often first.
    order: Vec<usize>,
}

/// What walks need.
struct Planning<'h> {
    problem: Problem,
    names: Vec<String>,
    latest: u32,
    budget: Rc<Budget<'h>>,
}

impl<'a, 'h> Extending<'a, 'h> {
    /// `known` are plans of all agents, such as the one that is asked about; walks arrive by the
    /// latest time.
    pub(crate) fn new(
        instance: &'a Instance,
        known: Vec<Plan>,
        latest: u32,
        budget: &Rc<Budget<'h>>,
    ) -> Self {
        let planning = Problem::new(instance, budget).ok().map(|problem| Planning {
            problem,
            names: names(instance),
            latest,
            budget: Rc::clone(budget),
        });
        let mut order: Vec<usize> = (0..instance.agents().len()).collect();
        if let Some(plan) = known.first() {
            let latest = arrivals(instance, plan);
            giveway_model::sorting::sort_by_key(&mut order, |&agent| {
                std::cmp::Reverse(latest.get(agent).copied().flatten())
            });
        }
        Self {
            instance,
            known,
            planning,
            order,
        }
    }

    /// The plans that were known from the beginning.
    pub(crate) fn known_plans(&self) -> Vec<Plan> {
        self.known.clone()
    }

    /// A plan of some agents with as many more as find a place beside them.
    pub(super) fn extend(
        &mut self,
        refuted: &Refuted,
        agents: &BTreeSet<usize>,
        plan: Plan,
        inquiry: &dyn Inquiry,
    ) -> (BTreeSet<usize>, Plan) {
        let (mut agents, mut plan) = (agents.clone(), plan);
        let accepted = |agents: &BTreeSet<usize>, wider: &Plan| {
            let variant = only(refuted, agents);
            let fitted = fit(wider, &variant.instance);
            inquiry.accepts(&variant, &fitted).then_some(fitted)
        };
        let mut failed = Vec::new();
        for &agent in &self.order {
            if agents.contains(&agent) {
                continue;
            }
            let mut wider = agents.clone();
            wider.insert(agent);
            let known = self.known.iter().rev().take(KNOWN);
            let mut found = known
                .filter(|known| known.paths.contains_key(self.name(agent)))
                .find_map(|known| accepted(&wider, &replaced(&plan, self.name(agent), known)));
            if found.is_none() {
                let planned = self.planning.as_ref();
                let planned = planned.and_then(|it| it.beside(&agents, &plan, agent));
                found = planned.and_then(|wide| accepted(&wider, &wide));
            }
            match found {
                Some(wide) => (agents, plan) = (wider, wide),
                None => failed.push(agent),
            }
        }
        // Those without a place have the first choice next time.
        self.order.retain(|agent| !failed.contains(agent));
        self.order.splice(0..0, failed);
        self.known.push(plan.clone());
        (agents, plan)
    }

    fn name(&self, agent: usize) -> &str {
        let agent = self.instance.agents().get(agent);
        agent.map_or("", |agent| agent.name.as_str())
    }
}

impl Planning<'_> {
    /// The plan with a walk of one more agent that keeps clear of the others.
    fn beside(&self, agents: &BTreeSet<usize>, plan: &Plan, agent: usize) -> Option<Plan> {
        let problem = &self.problem;
        let mut others = Reservations::new(problem);
        for &other in agents {
            let (name, task) = (self.names.get(other)?, problem.tasks.get(other)?);
            others.add(other, &of_path(task, &problem.terrain, plan.path(name))?);
        }
        let query = Query {
            agent,
            latest: self.latest,
            conflict_penalty: None,
            expansion_limit: STATES,
        };
        let (walk, _) = plan_one(problem, &others, query, &*self.budget).ok()??;
        let mut walks: Vec<Walk> = vec![Walk::new(); self.names.len()];
        *walks.get_mut(agent)? = walk;
        let own = to_plan(problem, &self.names, &walks);
        Some(replaced(plan, self.names.get(agent)?, &own))
    }
}
