//! The search, asked about a changed instance.
//!
//! Every part of an explanation is made of questions like these: is there a
//! plan, and what is the best, with some facts left out, some edits made, some
//! costs capped? A plan that comes back was judged, rules left out apart.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{
    Condition, Cost, Costs, Instance, Objective, Plan,
    check::{self, Rule, Violation, arrivals, check},
    constraint::ConstraintKind,
};

use crate::{
    Status,
    budget::Budget,
    impose::{ImposeError, limit_costs},
    judged::Judged,
    problem::{Problem, ProblemError, Relaxed},
    search::{Aim, Bounded, Contact, EarlierOptima, Horizon, Proved, Verdict, find_from},
    walk::{Walk, to_plan, walks_of_plan},
};

/// A question to the search.
#[derive(Clone, Copy)]
pub(crate) struct Ask<'a> {
    /// The instance, after all edits.
    pub(crate) instance: &'a Instance,
    /// Rules between agents that do not count.
    pub(crate) relaxed: &'a Relaxed,
    /// Conditions beside the rules.
    pub(crate) conditions: &'a [Condition],
    /// The objective.
    pub(crate) objective: &'a Objective,
    /// The most that a plan may have of some costs.
    pub(crate) caps: &'a BTreeMap<Cost, u32>,
    /// The horizon; by default that of the problem's rules.
    pub(crate) within: Option<u32>,
    /// The least horizon, where none is set: what holds up to a horizon for the
    /// instance as it is should not be asked up to a lesser one.
    pub(crate) at_least_within: u32,
}

/// The result of a search for a variant.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    /// The proved status. Where any plan will do, a plan is `Feasible`.
    pub(crate) status: Status,
    /// The plan, judged.
    pub(crate) plan: Option<Plan>,
    /// Its costs.
    pub(crate) costs: Option<Costs>,
    /// How far the claim reaches; `None` where nothing was settled.
    pub(crate) reach: Option<Proved>,
    /// Agents that cannot all arrive, where there is no plan and some are known.
    pub(crate) clash: Vec<String>,
    /// The horizon of the search.
    pub(crate) horizon: u32,
}

/// What is known before a search.
#[derive(Clone, Copy, Default)]
pub(crate) struct Start<'a> {
    /// A plan that is as asked for.
    pub(crate) plan: Option<&'a Plan>,
    /// The optima of the same search with fewer conditions.
    pub(crate) earlier: Option<&'a EarlierOptima>,
}

/// The lexicographic optimum.
pub(crate) fn best(ask: &Ask, budget: &Rc<Budget>) -> Found {
    best_from(ask, Start::default(), budget)
}

/// The same, from what is known already.
pub(crate) fn best_from(ask: &Ask, start: Start, budget: &Rc<Budget>) -> Found {
    run(ask, &Aim::Best, start, budget)
}

/// Any plan, or the proof that there is none.
pub(crate) fn any(ask: &Ask, budget: &Rc<Budget>) -> Found {
    run(ask, &Aim::Any, Start::default(), budget)
}

/// A plan that costs no more than this in the order of the objective, or the
/// proof that there is none.
pub(crate) fn at_most(ask: &Ask, vector: Vec<u32>, budget: &Rc<Budget>) -> Found {
    run(ask, &Aim::AtMost(vector), Start::default(), budget)
}

/// The largest vector that is less in the order of an objective; components
/// that no longer matter are without a limit.
pub(super) fn just_below(mut vector: Vec<u32>) -> Option<Vec<u32>> {
    let last = vector.iter().rposition(|&value| value > 0)?;
    vector[last] -= 1;
    vector[last + 1..].fill(u32::MAX / 4);
    Some(vector)
}

fn run(ask: &Ask, aim: &Aim, start: Start, budget: &Rc<Budget>) -> Found {
    let nothing = Found {
        status: Status::Unknown,
        plan: None,
        costs: None,
        reach: None,
        clash: Vec::new(),
        horizon: ask.within.unwrap_or(ask.at_least_within),
    };
    let instance = ask.instance;
    let problem = match Problem::relaxed(instance, ask.relaxed.clone(), ask.conditions, budget) {
        Ok(problem) => problem,
        Err(ImposeError::Problem(ProblemError::Alone(agent, reason))) => {
            let agent = instance.agents().get(agent);
            return Found {
                status: Status::Impossible,
                reach: Some(Proved::no_plan(reason)),
                clash: agent.map(|a| a.name.clone()).into_iter().collect(),
                ..nothing
            };
        }
        Err(_) => return nothing,
    };
    let grid = instance.grid();
    let horizon = Horizon::of(&problem, grid, ask.within, ask.at_least_within);
    let mut limits = ask.caps.clone();
    for condition in ask.conditions {
        if let Err(unmeetable) = limit_costs(condition, &mut limits) {
            return Found {
                status: Status::Impossible,
                reach: Some(Proved::no_plan(unmeetable)),
                horizon: horizon.latest(),
                ..nothing
            };
        }
    }
    let bounded = Bounded { horizon, limits };
    let mut conditions = ask.conditions.iter();
    let plan = start
        .plan
        .filter(|plan| conditions.all(|it| it.holds(instance, plan) == Some(true)));
    let walks = plan.and_then(|plan| walks(instance, &problem, plan));
    let contact = Contact {
        start: walks.as_deref(),
        earlier: start.earlier,
        on_better: &|_, _| {},
    };
    let verdict = find_from(&problem, ask.objective, &bounded, aim, &contact, budget);
    judged(&problem, ask, aim, horizon.latest(), verdict)
}

/// A verdict with its plan judged.
fn judged(problem: &Problem, ask: &Ask, aim: &Aim, horizon: u32, verdict: Verdict) -> Found {
    let instance = ask.instance;
    let names = names(instance);
    let claim = (verdict.reach, verdict.stop);
    let judged = Judged::new(verdict.best, aim, claim, |(walks, costs)| {
        let plan = to_plan(problem, &names, &walks);
        let broken = violations(instance, &problem.relaxed, &plan);
        let mut conditions = ask.conditions.iter();
        let met = conditions.all(|it| it.holds(instance, &plan) == Some(true));
        let same = check::costs(instance, &plan) == Some(costs);
        (met && broken.is_empty() && same).then_some((plan, costs))
    });
    let clash = verdict.clash.iter().filter_map(|&a| names.get(a));
    let (plan, costs) = judged.plan.unzip();
    Found {
        status: judged.status,
        plan,
        costs,
        reach: judged.reach,
        clash: clash.cloned().collect(),
        horizon,
    }
}

/// The names of the agents, in their order.
pub(crate) fn names(instance: &Instance) -> Vec<String> {
    let agents = instance.agents().iter();
    agents.map(|agent| agent.name.clone()).collect()
}

/// The plan of an instance as walks, up to the arrivals.
pub(crate) fn walks(instance: &Instance, problem: &Problem, plan: &Plan) -> Option<Vec<Walk>> {
    let mut plan = plan.clone();
    plan.cut_trailing_goals(instance);
    walks_of_plan(problem, &names(instance), &plan)
}

/// The violations of a plan, but for those of rules left out.
pub(crate) fn violations(instance: &Instance, relaxed: &Relaxed, plan: &Plan) -> Vec<Violation> {
    let mut violations = check(instance, plan).violations;
    if *relaxed == Relaxed::default() {
        return violations;
    }
    let arrivals = arrivals(instance, plan);
    let index = |name: &String| instance.agents().iter().position(|a| a.name == *name);
    violations.retain(|violation| {
        let agents: Vec<usize> = violation.agents.iter().filter_map(index).collect();
        let is_gone = |agent: usize, steps: u32| {
            let arrival = arrivals.get(agent).copied().flatten();
            let last = arrival.map(|at| at.saturating_add(steps));
            relaxed.gone.contains(&agent) && last.is_some_and(|last| violation.time > last)
        };
        if let Some(rule) = rule_between(instance, violation) {
            let there = |steps| agents.iter().filter(|&&a| !is_gone(a, steps)).count();
            return match rule {
                Broken::Capacity(most) => there(0) > most as usize,
                // The last cell of one that is gone stays closed for so many steps.
                Broken::Gap(steps) => there(steps) == agents.len(),
                Broken::Apart => there(0) == agents.len(),
            };
        }
        let collides = matches!(violation.rule, Rule::Vertex | Rule::Swap | Rule::SlowSwap);
        let [a, b] = agents[..] else { return true };
        if !collides {
            return true;
        }
        !(relaxed.ignores(a, b) || is_gone(a, 0) || is_gone(b, 0))
    });
    violations
}

/// A rule between agents that counts those at rest, and is broken.
enum Broken {
    Capacity(u32),
    Gap(u32),
    Apart,
}

/// The rule between agents that a violation is one of.
fn rule_between(instance: &Instance, violation: &Violation) -> Option<Broken> {
    let index = violation.broken.as_ref()?.index;
    match &instance.constraints().get(index as usize)?.kind {
        // Out of a zone of capacity 0 each agent keeps by itself.
        ConstraintKind::Capacity { most, .. } => (*most > 0).then_some(Broken::Capacity(*most)),
        ConstraintKind::Gap { steps } => Some(Broken::Gap(*steps)),
        ConstraintKind::Apart { .. } => Some(Broken::Apart),
        ConstraintKind::Closed { .. }
        | ConstraintKind::OneWay { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Visit { .. }
        | ConstraintKind::Arrive { .. }
        | ConstraintKind::Late { .. }
        | ConstraintKind::Depart { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::NoWaiting { .. }
        | ConstraintKind::Turns { .. }
        | ConstraintKind::Avoid { .. } => None,
    }
}
