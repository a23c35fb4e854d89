//! The verdict: the best plan with what a question asks for, beside the plan
//! that is asked about.

mod sooner;

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Condition, Cost, Costs, Plan};

use super::{
    Verdict,
    ask::{Found, Start, any, at_most, best_from, just_below},
    fitting::FittingQuestion,
};
use crate::{
    Status,
    budget::Budget,
    search::{EarlierOptima, Proved},
};
#[cfg(test)]
pub(crate) use sooner::by_closest;
use sooner::{by_known_plan, by_proof_of_plan, sooner};

/// How the best other plan compares.
pub(crate) struct Compared {
    pub(crate) verdict: Verdict,
    /// An other plan and its costs, the best where that is proved.
    pub(crate) other: Option<(Plan, Costs)>,
    /// The difference of each cost of the objective.
    pub(crate) deltas: BTreeMap<Cost, i64>,
    /// How far the verdict was proved; `None` where nothing was.
    pub(crate) reach: Option<Proved>,
    /// Where the verdict stands, but a cheaper other plan is still to be looked for.
    pub(crate) open: Option<StillOpen>,
    /// Where the other plan was looked for as a closest one: whether none is closer.
    pub(crate) closest: Option<bool>,
}

/// The best other plan is not known yet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StillOpen {
    /// The least of the first cost in any other plan, and how far that is proved; `None` where a
    /// plan with less than the known one may be.
    pub(crate) least: Option<(u32, Proved)>,
}

impl StillOpen {
    /// That optimum, for the search for the best other plan.
    pub(crate) fn optima(self) -> Option<EarlierOptima> {
        let (least, proved) = self.least?;
        EarlierOptima::of(vec![least], proved)
    }
}

/// Compares the plan with the best one that is as asked for. `known` is such a plan: it is told
/// where the search does not find a better one in its limits. On a large floor the verdict may be
/// there before the best other plan is known; [`compare_all_costs`] goes on then.
pub(crate) fn compare(
    case: &FittingQuestion,
    known: Option<(Plan, Costs)>,
    budget: &Rc<Budget>,
) -> Compared {
    if let Some(compared) = by_proof_of_plan(case, known.as_ref()) {
        return compared;
    }
    let mut known = known;
    if is_large(case, budget)
        && !asks_for_less_of_first_cost(case)
        && let Some(compared) = by_known_plan(case, known.as_ref())
            .or_else(|| sooner(case, &mut known, budget))
            .or_else(|| by_known_plan(case, known.as_ref()))
    {
        return compared;
    }
    compare_all_costs(case, known, None, budget)
}

/// The same by a search for the best other plan. `least` are optima of the first costs, where
/// they are known to be above those of the plan.
pub(crate) fn compare_all_costs(
    case: &FittingQuestion,
    known: Option<(Plan, Costs)>,
    least: Option<&EarlierOptima>,
    budget: &Rc<Budget>,
) -> Compared {
    let found = best_with(case, known.as_ref().map(|(plan, _)| plan), least, budget);
    let objective = case.objective();
    let before = case.costs.vector(objective);
    let mut other = found.plan.zip(found.costs);
    if !settled(found.status) {
        other = cheaper(case, known, other);
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
        open: None,
        closest: None,
    }
}

/// The cheaper of two plans; the first where both cost the same.
fn cheaper(
    case: &FittingQuestion,
    one: Option<(Plan, Costs)>,
    other: Option<(Plan, Costs)>,
) -> Option<(Plan, Costs)> {
    let vector = |it: &(Plan, Costs)| it.1.vector(case.objective());
    one.into_iter().chain(other).min_by_key(vector)
}

/// Whether the floor has so many agents that the proof for all costs takes long.
fn is_large(case: &FittingQuestion, budget: &Budget) -> bool {
    case.instance.agents().len() > budget.thresholds().few_agents
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
fn best_with(
    case: &FittingQuestion,
    near: Option<&Plan>,
    least: Option<&EarlierOptima>,
    budget: &Rc<Budget>,
) -> Found {
    let objective = case.objective();
    let mut all: Option<Found> = None;
    let is_large = is_large(case, budget);
    if is_large && asks_for_less_of_first_cost(case) {
        // Mostly there is no such plan: SAT refutes it before planners would give up.
        let mut refuted = None;
        case.each(objective, |ask| refuted = Some(any(ask, budget)));
        if let Some(found) = refuted.filter(|found| found.plan.is_none()) {
            return found;
        }
    }
    let costs = case.costs.vector(objective);
    let proved = case.optimal.filter(|_| is_large);
    let earlier = proved.and_then(|proved| EarlierOptima::of(costs, proved));
    let start = Start {
        plan: near.filter(|_| is_large),
        earlier: least.or(earlier.as_ref()),
    };
    case.each(objective, |ask| {
        let Some(so_far) = all.take() else {
            all = Some(best_from(ask, start, budget));
            return;
        };
        // Only what is better than the best so far is of interest.
        let vector = so_far.costs.map(|costs| costs.vector(objective));
        let better = match vector.map(just_below) {
            None => best_from(ask, start, budget),
            Some(None) => {
                all = Some(so_far);
                return; // nothing costs less than nothing
            }
            Some(Some(most)) => match at_most(ask, most, budget) {
                found if found.plan.is_some() => best_from(ask, start, budget),
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
