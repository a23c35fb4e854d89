//! All agents at once: joint states, exhausted.
//!
//! Practical for two or three agents on small maps. It proves what a horizon
//! cannot: that there is no plan at all, or which plan is best whatever the
//! makespan. Where costs are limited, what is used of them is part of a state.

mod agent;
mod event;
mod memory;
mod search;
mod starts;
mod states;
mod tally;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use giveway_model::{Cost, Objective};

use self::{
    agent::Single,
    event::Event,
    tally::{TalliedCosts, Tally},
};
use crate::{
    budget::{Budget, Stop},
    encode::collisions::AgentId,
    problem::Problem,
    single::Place,
    walk::Walk,
};

/// Joint steps to look at before giving up.
const MOST_STEPS: usize = 1_500_000;
/// Agents whose joint states are always worth the try.
const MOST_AGENTS: usize = 3;
/// Joint states, by the states of each agent alone, up to which those of more agents are
/// worth it: few of them can be reached, as no two agents are in one cell.
const MANY_STATES: usize = 4_000_000;

/// Whether there are so few joint states that they are best exhausted at once.
pub(crate) fn is_small(problem: &Problem, budget: &Budget) -> bool {
    product_of_states(problem, 0..problem.agents()) <= budget.thresholds().few_joint_states
}

/// Whether there are so few joint states that they are exhausted where clauses take long: under
/// rules, which count much on the way that is never reached, up to ten times as many, of the states
/// that agents do reach.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn is_rather_small(problem: &Problem, budget: &Budget) -> Result<bool, Stop> {
    let few = budget.thresholds().few_joint_states;
    if !problem.is_constrained {
        return Ok(product_of_states(problem, 0..problem.agents()) <= few);
    }
    let most = few.saturating_mul(10);
    if product_of_states(problem, 0..problem.agents()) <= most {
        return Ok(true);
    }
    let mut product = 1_usize;
    for agent in 0..problem.agents() {
        let reached = states::reached_alone(problem, agent, most / product, budget)?;
        product = product.saturating_mul(reached.max(1));
        if product > most {
            return Ok(false);
        }
    }
    Ok(true)
}

/// The product of the numbers of states that agents have alone: no fewer than their joint
/// states.
fn product_of_states(problem: &Problem, agents: impl Iterator<Item = AgentId>) -> usize {
    let states = agents.map(|agent| {
        let task = &problem.tasks[agent];
        let cells = problem.terrain.size();
        cells
            .saturating_mul(task.masks())
            .saturating_mul(task.conditions.counts())
            .saturating_mul(task.levels())
    });
    states.fold(1, usize::saturating_mul)
}

/// Whether it is worth the try to exhaust the joint states of some agents.
fn may_be_exhausted(problem: &Problem, agents: &[AgentId]) -> bool {
    let few = agents.len() <= MOST_AGENTS
        || product_of_states(problem, agents.iter().copied()) <= MANY_STATES;
    let counted = |&agent: &AgentId| event::can_count(&problem.tasks[agent]);
    few && !agents.is_empty() && agents.iter().all(counted)
}

/// How exhausting the joint states ended.
enum Ended {
    /// The best plan at any horizon: its costs, in the order of the objective, and its states
    /// over time.
    Best(Vec<u32>, Vec<Vec<Single>>),
    /// There is no plan at any horizon: no state is left to look at.
    None,
    /// There were too many states.
    TooMany,
}

/// The result of exhausting the joint states of some agents, at any horizon.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Exhaustion<T, P = AllStates> {
    /// The best plan, or its cost.
    Best(T, P),
    /// There is no plan.
    None(P),
    /// There were too many states.
    TooMany,
}

/// The proof of it: all joint states were looked at that could be reached for
/// less, however late. Only the search of joint states makes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct AllStates(());

/// The best plan of all agents, at any horizon.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct BestPlan {
    /// Its costs, in the order of the objective.
    pub(crate) vector: Vec<u32>,
    pub(crate) walks: Vec<Walk>,
}

/// Whether some agents have a plan among themselves.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn any(
    problem: &Problem,
    agents: &[AgentId],
    budget: &Budget,
) -> Result<Exhaustion<()>, Stop> {
    let outcome = run(problem, agents, &[], &NO_LIMITS, budget)?;
    Ok(outcome.map(|_, _| (), AllStates(())))
}

/// The least value of a cost of some agents among themselves.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn least(
    problem: &Problem,
    agents: &[AgentId],
    cost: Cost,
    budget: &Budget,
) -> Result<Exhaustion<u32>, Stop> {
    let outcome = run(problem, agents, &[cost], &NO_LIMITS, budget)?;
    Ok(outcome.map(|vector, _| vector[0], AllStates(())))
}

/// The plan of all agents with the least makespan.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn soonest(problem: &Problem, budget: &Budget) -> Result<Exhaustion<BestPlan>, Stop> {
    let shown = AllStates(());
    best_of(problem, &[Cost::Makespan], &NO_LIMITS, shown, budget)
}

/// The best plan of all agents of those that keep within limits of their costs. Where
/// none is looked for that ends after a `latest` time, nothing is shown of later ones.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn best(
    problem: &Problem,
    objective: &Objective,
    (limits, latest): (&BTreeMap<Cost, u32>, Option<u32>),
    budget: &Budget,
) -> Result<Exhaustion<BestPlan, Option<AllStates>>, Stop> {
    let mut limits = limits.clone();
    limits.extend(latest.map(|latest| (Cost::Makespan, latest)));
    let shown = latest.is_none().then_some(AllStates(()));
    best_of(problem, objective.costs(), &limits, shown, budget)
}

fn best_of<P>(
    problem: &Problem,
    costs: &[Cost],
    limits: &BTreeMap<Cost, u32>,
    shown: P,
    budget: &Budget,
) -> Result<Exhaustion<BestPlan, P>, Stop> {
    let all: Vec<AgentId> = (0..problem.agents()).collect();
    let outcome = run(problem, &all, costs, limits, budget)?;
    let plan = |vector: Vec<u32>, way: &[Vec<Single>]| BestPlan {
        vector,
        walks: all.iter().map(|&agent| walk(problem, agent, way)).collect(),
    };
    Ok(outcome.map(plan, shown))
}

/// Where nothing is limited.
const NO_LIMITS: BTreeMap<Cost, u32> = BTreeMap::new();

fn run(
    problem: &Problem,
    agents: &[AgentId],
    costs: &[Cost],
    limits: &BTreeMap<Cost, u32>,
    budget: &Budget,
) -> Result<Ended, Stop> {
    if !may_be_exhausted(problem, agents) {
        return Ok(Ended::TooMany);
    }
    let search = Joint {
        problem,
        agents,
        counted: TalliedCosts::new(costs, limits),
    };
    let most = MOST_STEPS.min(usize::try_from(budget.joint_left()).unwrap_or(MOST_STEPS));
    let mut steps = 0;
    let outcome = search.run(most, &mut steps, budget);
    budget.count_joint(steps as u64);
    outcome
}

impl Ended {
    fn map<T, P>(
        self,
        best: impl FnOnce(Vec<u32>, &[Vec<Single>]) -> T,
        shown: P,
    ) -> Exhaustion<T, P> {
        match self {
            Self::Best(vector, way) => Exhaustion::Best(best(vector, &way), shown),
            Self::None => Exhaustion::None(shown),
            Self::TooMany => Exhaustion::TooMany,
        }
    }
}

/// The walk of one of all agents, up to its arrival.
///
/// Where no cost counts time, nothing tells an agent that stands at its goal from one that
/// has arrived there: it has arrived as soon as it stays.
fn walk(problem: &Problem, agent: AgentId, way: &[Vec<Single>]) -> Walk {
    let task = &problem.tasks[agent];
    let mut walk = Walk::new();
    for states in way {
        match states.get(agent) {
            Some(Single::Going { place, .. }) => walk.push(*place),
            Some(Single::Leaving(v) | Single::Arrived(Some(v))) => {
                walk.push(Place::At(*v));
                break;
            }
            Some(Single::Arrived(None)) | None => break,
        }
    }
    while walk.len() > task.not_before as usize + 1 && task.ends_with_rest(&walk) {
        walk.pop();
    }
    walk
}

/// The joint states of some agents, and the costs that count.
struct Joint<'a> {
    problem: &'a Problem,
    agents: &'a [AgentId],
    counted: TalliedCosts,
}

impl Joint<'_> {
    /// The share of an agent's step in the costs.
    fn costs(&self, event: Event) -> Tally {
        self.counted.tally(|cost| event.costs(cost))
    }
}
