//! The other plan that is closest to the one asked about.

use std::rc::Rc;

use giveway_model::{Cell, Condition, Costs, Instance, Plan, check::check};

use super::{
    ask::{names, walks},
    fitting::FittingQuestion,
};
use crate::{
    Limits,
    budget::Budget,
    impose::{ImposeError, limit_costs},
    problem::{Problem, ProblemError, Relaxed},
    search::{
        Bounded, ClosestEnd, ClosestInput, Extent, GivenWalk, Horizon, Proved,
        closest as search_closest,
    },
    walk::to_plan,
};
use giveway_model::sorting::{map, sort};

/// Clauses that it may derive, and seconds that it may take.
const DERIVED: u64 = 20_000;
const SECONDS: f64 = 3.0;
/// Clauses and conflicts where it is not known whether any plan costs so little. What is not refuted
/// by then is sooner known from the best plans.
const DERIVED_FOR_ANY: u64 = 36_000;
const CONFLICTS_FOR_ANY: u64 = 11_000;

/// Whether a plan that is as asked for costs no more than another.
pub(crate) enum AsCheap {
    /// One does: the closest to the plan asked about that was found, and whether none is closer.
    Plan(Plan, bool),
    /// None has so little of each cost.
    None(Proved),
    /// It was not found out.
    Unknown,
}

/// Of the plans that are as asked for and cost as much as given, looks for that which is closest to
/// the plan asked about.
pub(crate) fn as_cheap_as(case: &FittingQuestion, costs: Costs, budget: &Rc<Budget>) -> AsCheap {
    let part = Rc::new(
        budget
            .part(Limits {
                conflicts: Some(CONFLICTS_FOR_ANY),
                ..Limits::default()
            })
            .with_derived(DERIVED_FOR_ANY),
    );
    let (nearest, all) = nearest(case, costs, None, &part);
    budget.absorb(&part);
    match (nearest, all) {
        (Some((_, plan)), all) => AsCheap::Plan(plan, all.is_closest),
        (
            None,
            All {
                refuted: Some(proved),
                ..
            },
        ) => AsCheap::None(proved),
        (None, _) => AsCheap::Unknown,
    }
}

/// Of the plans that cost as much as the best other one, that which is closest
/// to the plan asked about, and whether that is proved.
pub(crate) fn closest(
    case: &FittingQuestion,
    best: (&Plan, Costs),
    budget: &Rc<Budget>,
) -> (Plan, bool) {
    let part = Rc::new(
        budget
            .part(Limits {
                seconds: Some(SECONDS),
                ..Limits::default()
            })
            .with_derived(DERIVED),
    );
    let known = (distance(case, best.0), best.0.clone());
    let (nearest, all) = nearest(case, best.1, Some(known), &part);
    budget.absorb(&part);
    let plan = nearest.map_or_else(|| best.0.clone(), |(_, plan)| plan);
    (plan, all.is_closest)
}

/// A plan with its distance from the plan asked about.
type Near = ((usize, usize), Plan);

/// What is known of all alternatives of a contrast.
struct All {
    /// No plan of these costs is closer.
    is_closest: bool,
    /// How far it is proved that no plan has so little of each cost, if it is.
    refuted: Option<Proved>,
}

/// The closest plan of all alternatives of the contrast and of a known one.
fn nearest(
    case: &FittingQuestion,
    costs: Costs,
    known: Option<Near>,
    budget: &Rc<Budget>,
) -> (Option<Near>, All) {
    let mut is_closest = true;
    let mut refuted: Vec<Option<Proved>> = Vec::new();
    let mut nearest = known;
    for condition in case.conditions() {
        match with(case, condition, costs, budget) {
            BranchOutcome::Plan(plan, is_proved) => {
                is_closest &= is_proved;
                refuted.push(None);
                let distance = distance(case, &plan);
                if nearest.as_ref().is_none_or(|(least, _)| distance < *least) {
                    nearest = Some((distance, plan));
                }
            }
            BranchOutcome::None(proved) => refuted.push(proved),
            BranchOutcome::Unknown => {
                is_closest = false;
                refuted.push(None);
            }
        }
    }
    let refuted = refuted.into_iter().reduce(|all, one| Some(all?.and(one?)));
    let refuted = refuted.flatten();
    (
        nearest,
        All {
            is_closest,
            refuted,
        },
    )
}

/// The result for one of the alternatives that a condition allows.
enum BranchOutcome {
    /// A plan, and whether none is closer.
    Plan(Plan, bool),
    /// None costs so little; how far that is proved by a search, if it is.
    None(Option<Proved>),
    Unknown,
}

fn with(
    case: &FittingQuestion,
    condition: &Condition,
    costs: Costs,
    budget: &Rc<Budget>,
) -> BranchOutcome {
    let instance = case.instance;
    let problem = Problem::relaxed(instance, Relaxed::default(), Some(condition), budget);
    let problem = match problem {
        Ok(problem) => problem,
        Err(ImposeError::Problem(ProblemError::Alone(..))) => return BranchOutcome::None(None),
        Err(_) => return BranchOutcome::Unknown,
    };
    let grid = instance.grid();
    // Where a horizon is far away, closer plans beyond the default are not worth the search; then
    // that none is closer is not claimed. That a plan which ends after so many steps as there are
    // joint states has a shorter counterpart of no higher costs says nothing of how close it is.
    let near = problem
        .default_horizon(grid)
        .max(case.costs.makespan)
        .max(costs.makespan);
    let horizon = Horizon::at(case.within.unwrap_or(near).min(near));
    let objective = case.objective().costs().iter();
    let mut limits = map(objective.map(|&cost| (cost, costs.get(cost))));
    if limit_costs(condition, &mut limits).is_err() {
        return BranchOutcome::None(None);
    }
    let Some(before) = before(&problem, instance, case.plan) else {
        return BranchOutcome::Unknown;
    };
    let bounded = Bounded { horizon, limits };
    if (0..problem.agents()).any(|a| problem.optima[a] > problem.not_after(a).min(horizon.latest()))
    {
        return BranchOutcome::None(None);
    }
    let of_best = costs.vector(case.objective()) == case.costs.vector(case.objective());
    let latest = case.latest.as_ref().filter(|_| of_best);
    if let Some(proved) = latest.and_then(|latest| latest.refute(&problem)) {
        return BranchOutcome::None(Some(proved));
    }
    let given = ClosestInput {
        before: &before,
        bounded: &bounded,
        latest,
    };
    match search_closest(&problem, given, Extent::Entries, budget) {
        Ok(ClosestEnd::NoPlan(proved)) => BranchOutcome::None(proved),
        Err(_) => BranchOutcome::Unknown,
        Ok(ClosestEnd::Plan(close)) => {
            let names = names(instance);
            let mut plan = to_plan(&problem, &names, &close.walks);
            for (name, same) in names.iter().zip(close.same) {
                let charges = case.plan.charges(name);
                if same && !charges.is_empty() {
                    plan.charges.insert(name.clone(), charges.to_vec());
                }
            }
            let report = check(instance, &plan);
            let as_good = report
                .costs
                .is_some_and(|own| own.vector(case.objective()) == costs.vector(case.objective()));
            if report.is_valid() && as_good && condition.holds(instance, &plan) == Some(true) {
                let shown = case.shown.or(case.optimal);
                let far = |proved: Proved| shown.is_some_and(|shown| proved.covers(shown));
                BranchOutcome::Plan(plan, close.proved.is_some_and(far))
            } else {
                BranchOutcome::Unknown
            }
        }
    }
}

/// A valid plan as walks with their charges.
fn before(problem: &Problem, instance: &Instance, plan: &Plan) -> Option<Vec<GivenWalk>> {
    let walks = walks(instance, problem, plan)?.into_iter();
    let each = walks.zip(instance.agents()).map(|(walk, agent)| {
        let mut charges = plan.charges(&agent.name).to_vec();
        sort(&mut charges);
        GivenWalk { walk, charges }
    });
    Some(each.collect())
}

/// How far a plan is from the one asked about: agents that do something else,
/// then entries that differ, arrived agents padded.
fn distance(case: &FittingQuestion, other: &Plan) -> (usize, usize) {
    let (mut agents, mut entries) = (0, 0);
    for agent in case.instance.agents() {
        let (a, b) = (case.plan.path(&agent.name), other.path(&agent.name));
        let at = |path: &[Option<Cell>], time: usize| {
            let end = || agent.goal.or_else(|| path.last().copied().flatten());
            path.get(time).copied().unwrap_or_else(end)
        };
        let times = 0..a.len().max(b.len());
        let differ = times.filter(|&time| at(a, time) != at(b, time)).count();
        let recharged = case.plan.charges(&agent.name) != other.charges(&agent.name);
        agents += usize::from(differ > 0 || recharged);
        entries += differ;
    }
    (agents, entries)
}
