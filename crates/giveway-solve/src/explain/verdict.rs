//! The verdict: the best plan with what a question asks for, beside the plan
//! that is asked about.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{
    Condition, Cost, Costs, Instance, Objective, Plan, Question, check::cost_of, sorting::map,
};

use super::{
    Verdict,
    ask::{Ask, Found, any, at_most, best},
    whole::WholePlan,
};
use crate::{
    Status,
    budget::Budget,
    impose::{Unmeetable, ways},
    problem::Relaxed,
    search::Proved,
};

/// With more agents planners look long for a plan that does not exist.
const FEW_AGENTS: usize = 8;

/// A question that fits a valid plan, and what is to be known of both.
pub(crate) struct FittingQuestion<'a> {
    /// The instance, with the objective in which costs compare.
    pub(crate) instance: &'a Instance,
    pub(crate) question: &'a Question,
    /// The plan that is asked about.
    pub(crate) plan: &'a Plan,
    /// Its costs.
    pub(crate) costs: Costs,
    /// How far it is proved that no plan is better, where it is.
    pub(crate) optimal: Option<Proved>,
    /// How far the verdict is proved, once it is.
    pub(crate) shown: Option<Proved>,
    /// The alternatives of the contrast, one of which must hold in the other plan; an error where no agent
    /// could do it.
    pub(crate) conditions: Result<Vec<Condition>, Unmeetable>,
    /// The horizon, where a person set one.
    pub(crate) within: Option<u32>,
    /// The plan of which the instance is the rest.
    pub(crate) whole: WholePlan<'a>,
}

impl<'a> FittingQuestion<'a> {
    pub(crate) fn new(
        instance: &'a Instance,
        question: &'a Question,
        plan: &'a Plan,
        costs: Costs,
        within: Option<u32>,
        whole: WholePlan<'a>,
    ) -> Self {
        let before = |agent: Option<&str>, cost| cost_of(instance, plan, agent, cost);
        let condition = question.condition(before);
        Self {
            instance,
            question,
            plan,
            costs,
            optimal: None,
            shown: None,
            conditions: condition.map_or(Ok(Vec::new()), |it| ways(it, instance)),
            whole,
            // The horizon always includes the plan at hand.
            within: within.map(|within| within.max(costs.makespan)),
        }
    }

    pub(crate) fn objective(&self) -> &Objective {
        self.instance.objective()
    }

    /// The alternatives of the contrast, one of which must hold in the other plan.
    pub(crate) fn conditions(&self) -> impl Iterator<Item = &Condition> {
        self.conditions.iter().flatten()
    }

    /// The difference of a plan with these costs, for each cost of the objective.
    pub(crate) fn deltas(&self, costs: &Costs) -> BTreeMap<Cost, i64> {
        let more = |cost: Cost| i64::from(costs.get(cost)) - i64::from(self.costs.get(cost));
        let objective = self.objective().costs().iter();
        map(objective.map(|&cost| (cost, more(cost))))
    }

    /// Calls the search with each of the conditions in turn.
    fn each(&self, mut with: impl FnMut(&Ask)) {
        for condition in self.conditions() {
            with(&Ask {
                instance: self.instance,
                relaxed: &Relaxed::default(),
                conditions: std::slice::from_ref(condition),
                objective: self.objective(),
                caps: &BTreeMap::new(),
                within: self.within,
                at_least_within: self.costs.makespan,
            });
        }
    }
}

/// How the best other plan compares.
pub(crate) struct Compared {
    pub(crate) verdict: Verdict,
    /// An other plan and its costs, the best where that is proved.
    pub(crate) other: Option<(Plan, Costs)>,
    /// The difference of each cost of the objective.
    pub(crate) deltas: BTreeMap<Cost, i64>,
    /// How far the verdict was proved; `None` where nothing was.
    pub(crate) reach: Option<Proved>,
}

/// Compares the plan with the best one that is as asked for. `known` is such a plan: it is told
/// where the search does not find a better one in its limits.
pub(crate) fn compare(
    case: &FittingQuestion,
    known: Option<(Plan, Costs)>,
    budget: &Rc<Budget>,
) -> Compared {
    if let Some(compared) = by_proof_of_plan(case, known.as_ref()) {
        return compared;
    }
    let found = best_with(case, budget);
    let objective = case.objective();
    let before = case.costs.vector(objective);
    let mut other = found.plan.zip(found.costs);
    if let Some((_, known_costs)) = &known {
        let vector = known_costs.vector(objective);
        let is_better = |(_, costs): &(Plan, Costs)| vector < costs.vector(objective);
        if !settled(found.status) && other.as_ref().is_none_or(is_better) {
            other = known;
        }
    }
    let after = other.as_ref().map(|(_, costs)| costs.vector(objective));
    let proved = found.reach.filter(|_| settled(found.status));
    let verdict = match &after {
        None if proved.is_some() => Verdict::Necessary,
        Some(after) if *after < before => Verdict::Improvable,
        // Nothing is better than the best, with or without what is asked for.
        Some(after) if *after == before && (proved.or(case.optimal)).is_some() => Verdict::Needless,
        Some(_) if proved.is_some() => Verdict::Costly,
        _ => Verdict::Unknown,
    };
    let deltas = other.as_ref();
    let deltas = deltas.map_or_else(BTreeMap::new, |(_, costs)| case.deltas(costs));
    // No proof is needed where a plan at hand costs no more.
    let at_hand = case.optimal.filter(|_| verdict == Verdict::Needless);
    let reach = match (proved, at_hand) {
        (Some(proved), Some(at_hand)) => Some(proved.or(at_hand)),
        (one, other) => one.or(other),
    };
    Compared {
        verdict,
        other,
        deltas,
        reach,
    }
}

/// What follows from the proof that no plan is better than the one asked about: there is none
/// with less of the first cost, and a known one that costs the same is as good as the best.
fn by_proof_of_plan(case: &FittingQuestion, known: Option<&(Plan, Costs)>) -> Option<Compared> {
    let proved = case.optimal?;
    let objective = case.objective();
    if proved.is_complete() && asks_for_less_of_first_cost(case) {
        return Some(Compared {
            verdict: Verdict::Necessary,
            other: None,
            deltas: BTreeMap::new(),
            reach: Some(proved),
        });
    }
    let costs_same =
        |(_, costs): &&(Plan, Costs)| costs.vector(objective) == case.costs.vector(objective);
    let same = known.filter(costs_same)?;
    Some(Compared {
        verdict: Verdict::Needless,
        deltas: case.deltas(&same.1),
        other: Some(same.clone()),
        reach: Some(proved),
    })
}

/// Whether each alternative of the contrast has less of the objective's first cost than the plan.
fn asks_for_less_of_first_cost(case: &FittingQuestion) -> bool {
    let first = case.objective().costs().first().copied();
    let is_less = |condition: &Condition| match condition {
        Condition::Below {
            agent: None,
            cost,
            limit,
        } => Some(*cost) == first && *limit <= case.costs.get(*cost),
        Condition::Below { agent: Some(_), .. }
        | Condition::Never { .. }
        | Condition::Visit { .. }
        | Condition::Move { .. }
        | Condition::Charge { .. }
        | Condition::Before { .. }
        | Condition::Keeps(_) => false,
    };
    case.conditions().next().is_some() && case.conditions().all(is_less)
}

/// The best plan with any of the conditions.
fn best_with(case: &FittingQuestion, budget: &Rc<Budget>) -> Found {
    let objective = case.objective();
    let mut all: Option<Found> = None;
    let is_large = case.instance.agents().len() > FEW_AGENTS;
    if is_large && asks_for_less_of_first_cost(case) {
        // Mostly there is no such plan: SAT refutes it before planners would give up.
        let mut refuted = None;
        case.each(|ask| refuted = Some(any(ask, budget)));
        if let Some(found) = refuted.filter(|found| found.plan.is_none()) {
            return found;
        }
    }
    case.each(|ask| {
        let Some(so_far) = all.take() else {
            all = Some(best(ask, budget));
            return;
        };
        // Only what is better than the best so far is of interest.
        let vector = so_far.costs.map(|costs| costs.vector(objective));
        let better = match vector.map(just_below) {
            None => best(ask, budget),
            Some(None) => {
                all = Some(so_far);
                return; // nothing costs less than nothing
            }
            Some(Some(most)) => match at_most(ask, most, budget) {
                found if found.plan.is_some() => best(ask, budget),
                found => found,
            },
        };
        all = Some(join(so_far, better));
    });
    // Where there is nobody who could, nobody can.
    let nobody = case.conditions.as_ref().err();
    all.unwrap_or(Found {
        status: if nobody.is_some() {
            Status::Impossible
        } else {
            Status::Unknown
        },
        plan: None,
        costs: None,
        reach: nobody.map(|&nobody| Proved::no_plan(nobody)),
        clash: Vec::new(),
        horizon: case.costs.makespan,
    })
}

/// Joins two searches, each for the best plan of one alternative. The second one looked for something better
/// than the first.
fn join(first: Found, second: Found) -> Found {
    let proved = settled(first.status) && settled(second.status);
    let both = first.reach.zip(second.reach);
    let reach = both.filter(|_| proved).map(|(a, b)| a.and(b));
    let best = if second.plan.is_some() { second } else { first };
    let status = match (best.plan.is_some(), proved) {
        (true, true) => Status::Optimal,
        (true, false) => Status::Feasible,
        (false, true) => Status::Impossible,
        (false, false) => Status::Unknown,
    };
    Found {
        status,
        reach,
        ..best
    }
}

/// Whether it was settled which plan is best, or that there is none.
const fn settled(status: Status) -> bool {
    matches!(status, Status::Optimal | Status::Impossible)
}

/// The largest vector that is less in the order of an objective; components
/// that no longer matter are without a limit.
fn just_below(mut vector: Vec<u32>) -> Option<Vec<u32>> {
    let last = vector.iter().rposition(|&value| value > 0)?;
    vector[last] -= 1;
    vector[last + 1..].fill(u32::MAX / 4);
    Some(vector)
}
