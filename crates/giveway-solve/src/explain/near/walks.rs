//! Other walks of the agent that is to do otherwise: beside all others as they are; before one
//! of them, which is planned anew; and against all, repaired and improved.

use std::rc::Rc;

use giveway_model::{Condition, Plan, sorting::set};

use super::{Offer, TellNear, Variations, retimed::retimed};
use crate::{
    budget::{Budget, Stop},
    explain::{
        ask::{names, walks},
        layers::VariationKind,
        lone_walk::{lone_walk, replaced},
    },
    lns::{Effort, Lns},
    local::{OtherAgents, Query, Reservations, plan_one, repair},
    problem::{Problem, Relaxed},
    walk::{Walk, to_plan},
};

/// States that are looked at for one walk.
const STATES: u32 = 60_000;
/// States to improve a plan of several agents, about.
const IMPROVED: u64 = 60_000;
/// Agents that are let wait, one at a time.
const MOST_SWAPPED: usize = 4;

/// Offers such plans.
///
/// # Errors
/// When the budget is spent.
pub(super) fn vary(
    found: &mut Variations,
    condition: &Condition,
    budget: &Rc<Budget>,
    tell: TellNear,
) -> Result<(), Stop> {
    let case = found.case;
    let names = names(case.instance);
    let Ok(problem) = Problem::relaxed(case.instance, Relaxed::default(), Some(condition), budget)
    else {
        return Ok(());
    };
    let Some(walks) = walks(case.instance, &problem, case.plan) else {
        return Ok(());
    };
    let latest = problem.default_horizon(case.instance.grid());
    let latest = latest.max(case.costs.makespan);
    let mut varying = Varying {
        found,
        condition,
        problem: &problem,
        names: &names,
        walks,
        latest: case.within.unwrap_or(latest),
        budget,
    };
    let agent = condition.agent();
    if let Some(agent) = agent.and_then(|agent| names.iter().position(|it| it == agent)) {
        varying.beside_all(agent)?;
        varying.found.tell(tell);
        varying.before_each(agent, tell)?;
    }
    varying.improved()?;
    varying.found.tell(tell);
    Ok(())
}

struct Varying<'v, 'a, 'h> {
    found: &'v mut Variations<'a>,
    condition: &'v Condition,
    problem: &'v Problem,
    names: &'v [String],
    /// The plan that is asked about.
    walks: Vec<Walk>,
    latest: u32,
    budget: &'v Rc<Budget<'h>>,
}

impl Varying<'_, '_, '_> {
    /// The best walk of the agent, all others as they are.
    fn beside_all(&mut self, agent: usize) -> Result<(), Stop> {
        let others = self.others(&[agent]);
        if let Some(walk) = self.plan(&others, agent)? {
            let plan = self.plan_with(&[(agent, walk)]);
            self.offer(VariationKind::OtherWay, agent, None, plan);
        }
        Ok(())
    }

    /// The agent goes before each of those that it would meet, which then takes the best walk
    /// that is left.
    fn before_each(&mut self, agent: usize, tell: TellNear) -> Result<(), Stop> {
        let lone = lone_walk(self.problem, &self.walks, (agent, self.latest), self.budget)?;
        let Some(lone) = lone else { return Ok(()) };
        if self.names.len() > self.budget.thresholds().few_agents {
            self.others_later(agent, &lone);
            self.found.tell(tell);
        }
        let met = self.others(&[agent]).met_by(agent, &lone);
        for &other in met.iter().take(MOST_SWAPPED) {
            let mut others = self.others(&[agent, other]);
            let Some(first) = self.plan(&others, agent)? else {
                continue;
            };
            others.add(agent, &first);
            if let Some(second) = self.plan(&others, other)? {
                let plan = self.plan_with(&[(agent, first), (other, second)]);
                self.offer(VariationKind::Swapped, agent, Some(other), plan);
                self.found.tell(tell);
            }
        }
        // All of them at once: who collides is planned anew until nobody does.
        let mut all = self.walks.clone();
        if let Some(own) = all.get_mut(agent) {
            *own = lone;
        }
        if let Some(repaired) = repair(self.problem, all, self.latest, &**self.budget)? {
            let plan = self.plan_of(&repaired);
            self.offer(VariationKind::Others, agent, None, plan);
            self.found.tell(tell);
        }
        Ok(())
    }

    /// The agent takes its own way, and all others keep theirs and let it pass.
    fn others_later(&mut self, agent: usize, lone: &Walk) {
        let plan = self.plan_with(&[(agent, lone.clone())]);
        let Some(name) = self.names.get(agent) else {
            return;
        };
        if let Some(plan) = retimed(&plan, name, self.latest) {
            self.offer(VariationKind::OtherWay, agent, None, plan);
        }
    }

    /// The cheapest variation, improved with all agents.
    fn improved(&mut self) -> Result<(), Stop> {
        let Some((plan, _)) = &self.found.best else {
            return Ok(());
        };
        let case = self.found.case;
        let Some(mut walks) = walks(case.instance, self.problem, plan) else {
            return Ok(());
        };
        let effort = Effort {
            states: IMPROVED,
            horizon: self.latest,
            enough: 0,
        };
        let objective = case.objective();
        let ended =
            Lns::default().improve(self.problem, &mut walks, effort, objective, &**self.budget);
        let plan = self.plan_of(&walks);
        let agent = self.condition.agent();
        let agent = agent.and_then(|agent| self.names.iter().position(|it| it == agent));
        self.offer(VariationKind::Others, agent.unwrap_or(0), None, plan);
        ended.map(|_| ())
    }

    /// All agents but some, as they are.
    fn others(&self, but: &[usize]) -> Reservations<'_> {
        let mut others = Reservations::new(self.problem);
        for (other, walk) in self.walks.iter().enumerate() {
            if !but.contains(&other) {
                others.add(other, walk);
            }
        }
        others
    }

    fn plan(&self, others: &Reservations, agent: usize) -> Result<Option<Walk>, Stop> {
        let query = Query {
            agent,
            latest: self.latest,
            conflict_penalty: None,
            expansion_limit: STATES,
        };
        let found = plan_one(self.problem, others, query, &**self.budget)?;
        Ok(found.map(|(walk, _)| walk))
    }

    /// The plan that is asked about with other walks of some agents.
    fn plan_with(&self, changed: &[(usize, Walk)]) -> Plan {
        let mut walks = self.walks.clone();
        for (agent, walk) in changed {
            if let Some(own) = walks.get_mut(*agent) {
                own.clone_from(walk);
            }
        }
        self.plan_of(&walks)
    }

    /// Walks as a plan; of agents whose walk is the same the plan that is asked about keeps
    /// the charges.
    fn plan_of(&self, walks: &[Walk]) -> Plan {
        let other = to_plan(self.problem, self.names, walks);
        let pairs = self.walks.iter().zip(walks).enumerate();
        let changed = set(pairs.filter(|(_, (a, b))| a != b).map(|(agent, _)| agent));
        let mut plan = self.found.case.plan.clone();
        for agent in changed {
            if let Some(name) = self.names.get(agent) {
                plan = replaced(&plan, name, &other);
            }
        }
        plan
    }

    fn offer(&mut self, kind: VariationKind, agent: usize, other: Option<usize>, plan: Plan) {
        let name = |agent: usize| self.names.get(agent).map_or("", String::as_str);
        let offer = Offer {
            kind,
            agent: name(agent),
            other: other.map(name),
            plan,
        };
        self.found.offer(self.condition, offer);
    }
}
