//! All agents at once: joint states, exhausted.
//!
//! Practical for two or three agents on small maps. It proves what a horizon
//! cannot: that there is no plan at all, or which plan is best whatever the
//! makespan. Where costs are limited, what is used of them is part of a state.

mod agent;
mod event;
mod search;

use std::collections::BTreeMap;

use giveway_model::{Cost, Objective};

use self::{agent::Single, event::Event};
use crate::{
    budget::{Budget, Stop},
    encode::collisions::AgentId,
    problem::Problem,
    single::Place,
    walk::Walk,
};

/// Joint steps to look at before giving up.
const MOST_STEPS: usize = 1_500_000;
/// Agents beyond which only the smallest maps are small enough.
const MOST_AGENTS: usize = 3;

/// Joint states up to which they are exhausted before anything else is tried.
const FEW_STATES: usize = 200_000;

/// Whether there are so few joint states that they are best exhausted at once.
pub(crate) fn is_small(problem: &Problem) -> bool {
    has_few_states(problem, 0..problem.agents())
}

/// Whether some agents have so few joint states among themselves.
fn has_few_states(problem: &Problem, agents: impl Iterator<Item = AgentId>) -> bool {
    let states = agents.map(|agent| {
        let task = &problem.tasks[agent];
        let cells = problem.terrain.size();
        cells
            .saturating_mul(task.masks())
            .saturating_mul(task.levels())
    });
    states.fold(1, usize::saturating_mul) <= FEW_STATES
}

/// Whether it is worth the try to exhaust the joint states of some agents.
fn may_be_exhausted(problem: &Problem, agents: &[AgentId]) -> bool {
    let few = agents.len() <= MOST_AGENTS || has_few_states(problem, agents.iter().copied());
    few && !agents.is_empty()
}

/// What is paid so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
struct Paid {
    /// Costs in the order of an objective, the rest 0.
    costs: [u32; 5],
    /// Costs that are limited, the rest 0.
    used: [u32; 5],
}

impl Paid {
    fn and(mut self, more: Self) -> Self {
        let more_of_all = more.costs.into_iter().chain(more.used);
        for (paid, more) in self.costs.iter_mut().chain(&mut self.used).zip(more_of_all) {
            *paid = paid.saturating_add(more);
        }
        self
    }
}

/// The values of up to five costs, the rest 0.
fn each(costs: impl Iterator<Item = Cost>, of: impl Fn(Cost) -> u32) -> [u32; 5] {
    let mut values = [0; 5];
    for (value, cost) in values.iter_mut().zip(costs) {
        *value = of(cost);
    }
    values
}

/// What exhausting the states has shown.
enum Ended {
    /// The best plan at any horizon: what it costs, and its states over time.
    Best(Paid, Vec<Vec<Single>>),
    /// There is no plan at any horizon: no state is left to look at.
    None,
    /// There were too many states.
    TooMany,
}

/// What is known of some agents among themselves, at any horizon.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Exhausted<T> {
    /// The best plan, or its cost.
    Best(T, AllStates),
    /// There is no plan.
    None(AllStates),
    /// There were too many states.
    TooMany,
}

/// The proof of it: all joint states were looked at that could be reached for
/// less. Only the search of joint states makes it.
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
) -> Result<Exhausted<()>, Stop> {
    let outcome = run(problem, agents, &[], &NO_LIMITS, budget)?;
    Ok(outcome.map(|_, _| ()))
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
) -> Result<Exhausted<u32>, Stop> {
    let outcome = run(problem, agents, &[cost], &NO_LIMITS, budget)?;
    Ok(outcome.map(|paid, _| paid.costs[0]))
}

/// The plan of all agents with the least makespan.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn soonest(problem: &Problem, budget: &Budget) -> Result<Exhausted<BestPlan>, Stop> {
    best_of(problem, &[Cost::Makespan], &NO_LIMITS, budget)
}

/// The best plan of all agents of those that keep within limits of their costs.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn best(
    problem: &Problem,
    objective: &Objective,
    limits: &BTreeMap<Cost, u32>,
    budget: &Budget,
) -> Result<Exhausted<BestPlan>, Stop> {
    best_of(problem, objective.costs(), limits, budget)
}

fn best_of(
    problem: &Problem,
    costs: &[Cost],
    limits: &BTreeMap<Cost, u32>,
    budget: &Budget,
) -> Result<Exhausted<BestPlan>, Stop> {
    let all: Vec<AgentId> = (0..problem.agents()).collect();
    let outcome = run(problem, &all, costs, limits, budget)?;
    Ok(outcome.map(|paid, way| BestPlan {
        vector: paid.costs[..costs.len()].to_vec(),
        walks: all.iter().map(|&agent| walk(problem, agent, way)).collect(),
    }))
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
        costs,
        limits: limits.iter().map(|(&cost, &most)| (cost, most)).collect(),
    };
    let most = MOST_STEPS.min(usize::try_from(budget.joint_left()).unwrap_or(MOST_STEPS));
    let mut steps = 0;
    let outcome = search.run(most, &mut steps, budget);
    budget.count_joint(steps as u64);
    outcome
}

impl Ended {
    fn map<T>(self, best: impl FnOnce(Paid, &[Vec<Single>]) -> T) -> Exhausted<T> {
        match self {
            Self::Best(paid, way) => Exhausted::Best(best(paid, &way), AllStates(())),
            Self::None => Exhausted::None(AllStates(())),
            Self::TooMany => Exhausted::TooMany,
        }
    }
}

/// The walk of one of all agents, up to its arrival.
///
/// Where no cost counts time, nothing tells an agent that stands at its goal from one that
/// has arrived there: it has arrived as soon as it stays.
fn walk(problem: &Problem, agent: AgentId, way: &[Vec<Single>]) -> Walk {
    let task = &problem.tasks[agent];
    let goal = Place::At(task.goal);
    let mut walk = Walk::new();
    for states in way {
        let Some(Single::Going { place, .. }) = states.get(agent) else {
            walk.push(goal);
            break;
        };
        walk.push(*place);
    }
    while walk.len() > task.not_before as usize + 1 && walk.ends_with(&[goal, goal]) {
        walk.pop();
    }
    walk
}

/// The joint states of some agents, and the costs that count.
struct Joint<'a> {
    problem: &'a Problem,
    agents: &'a [AgentId],
    costs: &'a [Cost],
    /// The most that all of them together may pay of some costs.
    limits: Vec<(Cost, u32)>,
}

impl Joint<'_> {
    /// What an agent's step adds to the costs.
    fn costs(&self, event: Event) -> Paid {
        self.paid(|cost| event.costs(cost))
    }

    fn paid(&self, of: impl Fn(Cost) -> u32) -> Paid {
        let of_limits = self.limits.iter().map(|&(cost, _)| cost);
        Paid {
            costs: each(self.costs.iter().copied(), &of),
            used: each(of_limits, &of),
        }
    }

    /// Whether no more is used of a cost than its limit allows.
    fn keeps_limits(&self, used: [u32; 5]) -> bool {
        let mut limits = self.limits.iter().zip(used);
        limits.all(|(&(_, most), used)| used <= most)
    }
}
