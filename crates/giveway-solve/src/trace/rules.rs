//! Which rules of a scene's own an event of a trace rests on.
//!
//! The claim of an event is asked anew when the search is over: a plan that contradicts it is
//! looked for without rules, and where there is one, rule after rule is left out as long as
//! there is none. The rules that are left prove the claim together with the problem's own
//! rules; without any of the scene's there is a plan that contradicts it.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use giveway_model::{Condition, Constraint, Cost, Instance, Objective, sorting::set};

use super::{
    AgentLeast, Bottleneck, Cannot, Core, Scope, SearchEvent, SearchTrace, TraceEvent, words,
};
use crate::{
    Limits,
    budget::Budget,
    explain::{
        ask::{Ask, any},
        budgets::one_search,
    },
    problem::Relaxed,
};

/// The most events of a trace that are looked at.
const MOST_EVENTS: usize = 24;
/// The most rules in force, and the most agents of a claim.
const MOST_RULES: usize = 24;
const MOST_AGENTS: usize = 40;
/// Clauses that all searches may derive and write, and joint steps that they may take.
const DERIVED: u64 = 60_000;
const CLAUSES: u64 = 4_000_000;
const JOINT_STEPS: u64 = 1_500_000;

/// Names the rules that the events of a trace rest on, as far as they are found soon.
pub(crate) fn name_rules(
    instance: &Instance,
    objective: &Objective,
    trace: &mut SearchTrace,
    budget: &Budget,
) {
    let rules = instance.constraints_in_force().count();
    if rules == 0 || rules > MOST_RULES {
        return;
    }
    let part = budget.part(Limits::default()).unrecorded();
    let naming = Naming {
        instance,
        objective,
        budget: part.with_derived(DERIVED).with_work(CLAUSES, JOINT_STEPS),
    };
    let mut left = MOST_EVENTS;
    for event in &mut trace.events {
        if let SearchEvent::Counted { at, .. } = &event.event {
            if let Bottleneck::Zone { rule, .. } = at {
                name(
                    event,
                    instance
                        .constraints()
                        .get(*rule)
                        .into_iter()
                        .cloned()
                        .collect(),
                );
            }
            continue;
        }
        let claims = naming.claims(&event.event);
        if claims.is_empty() {
            continue;
        }
        if left == 0 || naming.budget.check().is_err() {
            return;
        }
        left -= 1;
        let cores = claims.iter().filter_map(|claim| naming.core(claim));
        let core: BTreeSet<usize> = set(cores.flatten());
        let rules = instance.constraints().iter().enumerate();
        let rules = rules.filter(|(index, _)| core.contains(index));
        name(event, rules.map(|(_, rule)| rule.clone()).collect());
    }
}

/// Names the rules that an event rests on.
fn name(event: &mut TraceEvent, rules: Vec<Constraint>) {
    event.rules = rules;
    if let Some(rests) = words::rests_on(&event.rules) {
        event.text = format!("{} {rests}", event.text);
    }
}

/// What no plan of some agents has, if an event is right.
struct Claim {
    /// The instance of these agents.
    instance: Instance,
    conditions: Vec<Condition>,
    caps: BTreeMap<Cost, u32>,
    within: Option<u32>,
}

struct Naming<'a, 'h> {
    instance: &'a Instance,
    objective: &'a Objective,
    budget: Budget<'h>,
}

impl Naming<'_, '_> {
    /// The claims of an event; none of one that claims nothing, or of too many agents.
    fn claims(&self, event: &SearchEvent) -> Vec<Claim> {
        let claims = match event {
            SearchEvent::Alone {
                cost,
                agents,
                at_least,
            } => self.alone(*cost, agents, *at_least),
            SearchEvent::Core(core) => self.together(core).into_iter().collect(),
            SearchEvent::Closed {
                cost, scope, to, ..
            } => {
                let below = to.checked_sub(1).map(|most| (*cost, most));
                let claim = below.map(|below| self.claim(scope, &[], Some(below)));
                claim.into_iter().collect()
            }
            SearchEvent::Exhausted { bounds } => {
                let first = self.objective.costs().first();
                let below = first.and_then(|&first| {
                    let least = bounds.get(&first)?;
                    Some((first, least.checked_sub(1)?))
                });
                let claim = below.map(|below| self.claim(&Scope::default(), &[], Some(below)));
                claim.into_iter().collect()
            }
            SearchEvent::Impossible(Cannot { agents, within }) => {
                let mut claim = self.of_agents(agents);
                claim.within = *within;
                vec![claim]
            }
            SearchEvent::Plan { .. }
            | SearchEvent::Phase { .. }
            | SearchEvent::Round { .. }
            | SearchEvent::Entered { .. }
            // (It names its rule.)
            | SearchEvent::Counted { .. }
            | SearchEvent::Restarted { .. }
            | SearchEvent::Met { .. }
            | SearchEvent::Stopped(_) => Vec::new(),
        };
        let is_small = |claim: &Claim| claim.instance.agents().len() <= MOST_AGENTS;
        claims.into_iter().filter(is_small).collect()
    }

    /// A claim about some agents, or about all where none is named.
    fn of_agents(&self, names: &[String]) -> Claim {
        let mut instance = self.instance.clone();
        instance.retain_agents(|agent| names.is_empty() || names.contains(&agent.name));
        Claim {
            instance,
            conditions: Vec::new(),
            caps: BTreeMap::new(),
            within: None,
        }
    }

    /// A claim about plans of all agents with some costs, or of some agents by themselves
    /// where it is made of them.
    fn claim(&self, scope: &Scope, named: &[String], below: Option<(Cost, u32)>) -> Claim {
        let is_of_all = scope.others || !scope.given.is_empty() || scope.at_most.is_some();
        let mut claim = self.of_agents(if is_of_all { &[] } else { named });
        claim.caps.extend(&scope.given);
        claim.within = scope.within;
        if let Some((cost, most)) = below {
            let cap = claim.caps.entry(cost).or_insert(most);
            *cap = most.min(*cap);
        }
        claim
    }

    /// That no agent that decides the bound needs less alone.
    fn alone(&self, cost: Cost, agents: &[AgentLeast], at_least: u32) -> Vec<Claim> {
        let decides = |agent: &&AgentLeast| cost != Cost::Makespan || agent.least == at_least;
        let most = if cost == Cost::Makespan {
            1
        } else {
            usize::MAX
        };
        let agents = agents.iter().filter(decides).take(most);
        let agents: Vec<&AgentLeast> = agents.collect();
        if agents.len() > MOST_AGENTS {
            return Vec::new();
        }
        let claim = |agent: &&AgentLeast| {
            let mut claim = self.of_agents(std::slice::from_ref(&agent.agent));
            claim.conditions = vec![below(&agent.agent, cost, agent.least)];
            claim
        };
        agents.iter().map(claim).collect()
    }

    /// The claim of a core, as its sentence makes it.
    fn together(&self, core: &Core) -> Option<Claim> {
        let mut scope = core.scope.clone();
        let most = scope.at_most.take();
        let mut claim = match &core.together {
            Some(together) if !core.sums.is_empty() => {
                let names = together.agents.iter().map(|agent| agent.agent.clone());
                let names: Vec<String> = names.collect();
                if scope.others || !scope.given.is_empty() {
                    return None; // a sum of some agents is no cost of the plan
                }
                let least: u32 = together.agents.iter().map(|agent| agent.least).sum();
                let most = least.saturating_add(together.more).checked_sub(1)?;
                self.claim(&scope, &names, Some((core.cost, most)))
            }
            _ => {
                let names = core.limits.iter().map(|limit| limit.agent.clone());
                let names: Vec<String> = names.collect();
                let mut claim = self.claim(&scope, &names, None);
                let limits = core.limits.iter();
                let limits = limits.map(|limit| {
                    let above = limit.at_most.saturating_add(1);
                    below(&limit.agent, core.cost, above)
                });
                claim.conditions = limits.collect();
                claim
            }
        };
        let is_of_all = claim.instance.agents().len() == self.instance.agents().len();
        match most {
            // The costs of all are no costs of some.
            Some(_) if !is_of_all => return None,
            Some(most) => {
                let cap = claim.caps.entry(core.cost).or_insert(most);
                *cap = most.min(*cap);
            }
            None => {}
        }
        Some(claim)
    }

    /// The rules that a claim rests on; `None` where it holds without rules, or that is not
    /// found out.
    fn core(&self, claim: &Claim) -> Option<BTreeSet<usize>> {
        let in_force = claim.instance.constraints_in_force();
        let mut core: BTreeSet<usize> = set(in_force.map(|rule| rule.index));
        if core.is_empty()
            || !self.is_contradicted(claim, &BTreeSet::new())?
            || self.is_contradicted(claim, &core)?
        {
            return None;
        }
        for rule in core.clone() {
            core.remove(&rule);
            if self.is_contradicted(claim, &core) != Some(false) {
                core.insert(rule);
            }
        }
        Some(core)
    }

    /// Whether there is a plan against a claim with these rules only.
    fn is_contradicted(&self, claim: &Claim, rules: &BTreeSet<usize>) -> Option<bool> {
        let mut instance = claim.instance.clone();
        instance.switch_off(|rule| !rules.contains(&rule));
        let budget: Rc<Budget> = one_search(&self.budget);
        let ask = Ask {
            instance: &instance,
            relaxed: &Relaxed::default(),
            conditions: &claim.conditions,
            objective: self.objective,
            caps: &claim.caps,
            within: claim.within,
            at_least_within: 0,
        };
        let found = any(&ask, &budget);
        self.budget.absorb(&budget);
        match (found.plan, found.reach) {
            (Some(_), _) => Some(true),
            (None, Some(_)) => Some(false),
            (None, None) => None,
        }
    }
}

/// That an agent has less than so much of a cost; of the sum of costs, that is its arrival.
fn below(agent: &str, cost: Cost, limit: u32) -> Condition {
    let cost = match cost {
        Cost::Makespan | Cost::SumOfCosts => Cost::Makespan,
        cost @ (Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty) => cost,
    };
    Condition::Below {
        agent: Some(agent.to_owned()),
        cost,
        limit,
    }
}
