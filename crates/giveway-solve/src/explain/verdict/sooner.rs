//! Verdicts without the search for the best other plan: by the proof of the plan that is asked
//! about, by the first cost alone, and by a closest plan that costs the same.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Costs, Objective, Plan, check::costs};

use super::super::fitting::FittingQuestion;
use super::{Compared, StillOpen, asks_for_less_of_first_cost, cheaper, settled};
use crate::{
    Limits, Status,
    budget::Budget,
    explain::{
        Verdict,
        ask::{Start, any, best_from},
        closest::{AsCheap, as_cheap_as},
    },
    search::{EarlierOptima, Proved},
};

/// What follows from the proof that no plan is better than the one asked about: there is none
/// with less of the first cost, and a known one that costs the same is as good as the best.
pub(super) fn by_proof_of_plan(
    case: &FittingQuestion,
    known: Option<&(Plan, Costs)>,
) -> Option<Compared> {
    let proved = case.optimal?;
    let objective = case.objective();
    if proved.is_complete() && asks_for_less_of_first_cost(case) {
        return Some(necessary(proved));
    }
    let costs_same =
        |(_, costs): &&(Plan, Costs)| costs.vector(objective) == case.costs.vector(objective);
    let same = known.filter(costs_same)?;
    Some(Compared {
        verdict: Verdict::Needless,
        deltas: case.deltas(&same.1),
        other: Some(same.clone()),
        reach: Some(proved),
        open: None,
        closest: None,
    })
}

/// What a known plan shows where it is not proved that no plan is better than the one asked about:
/// one that costs the same or less, whether or not there are still better ones.
pub(super) fn by_known_plan(
    case: &FittingQuestion,
    known: Option<&(Plan, Costs)>,
) -> Option<Compared> {
    let (objective, (plan, costs)) = (case.objective(), known?);
    let (before, after) = (case.costs.vector(objective), costs.vector(objective));
    if case.optimal.is_some() || after > before {
        return None;
    }
    let is_better = after < before;
    Some(Compared {
        verdict: if is_better {
            Verdict::Improvable
        } else {
            Verdict::Needless
        },
        deltas: case.deltas(costs),
        other: Some((plan.clone(), *costs)),
        reach: None,
        open: is_better.then_some(StillOpen { least: None }),
        closest: None,
    })
}

/// Clauses that may be derived for the first cost before a closest plan is looked for, where a
/// plan with little more of that cost is known, and where none is.
const DERIVED: (u64, u64) = (4_000, 200);
/// So much more is little.
const LITTLE: u32 = 2;

/// The verdict without the optima of all costs, if that is enough; `known` becomes the cheapest
/// plan that is found.
pub(super) fn sooner(
    case: &FittingQuestion,
    known: &mut Option<(Plan, Costs)>,
    budget: &Rc<Budget>,
) -> Option<Compared> {
    let first = *case.objective().costs().first()?;
    let most = case.costs.get(first).saturating_add(LITTLE);
    let is_near = known
        .as_ref()
        .is_some_and(|(_, costs)| costs.get(first) <= most);
    let derived = if is_near { DERIVED.0 } else { DERIVED.1 };
    let part = Rc::new(budget.part(Limits::default()).with_derived(derived));
    let of_first = by_first_cost(case, known, &part);
    budget.absorb(&part);
    match of_first {
        FirstCost::Above(compared) => return Some(*compared),
        FirstCost::Same => return by_closest(case, known.as_ref(), budget),
        FirstCost::Unknown => {}
    }
    if let Some(compared) = by_closest(case, known.as_ref(), budget) {
        return Some(compared);
    }
    match by_first_cost(case, known, budget) {
        FirstCost::Above(compared) => Some(*compared),
        FirstCost::Same | FirstCost::Unknown => None,
    }
}

/// What the optimum of the first cost alone shows.
enum FirstCost {
    /// It has to grow, so the other plan costs more.
    Above(Box<Compared>),
    /// It need not grow.
    Same,
    /// It was not looked for, or not found.
    Unknown,
}

/// Looks for the optimum of the first cost: those of the costs after it take much longer.
fn by_first_cost(
    case: &FittingQuestion,
    known: &mut Option<(Plan, Costs)>,
    budget: &Rc<Budget>,
) -> FirstCost {
    let Some((&first, [_, ..])) = case.objective().costs().split_first() else {
        return FirstCost::Unknown;
    };
    let (1, Ok(objective)) = (case.conditions().count(), Objective::new(vec![first])) else {
        return FirstCost::Unknown;
    };
    let before = case.costs.get(first);
    let proved = case.optimal;
    let earlier = proved.and_then(|proved| EarlierOptima::of(vec![before], proved));
    let mut found = None;
    case.each(&objective, |ask| {
        let start = Start {
            plan: known.as_ref().map(|(plan, _)| plan),
            earlier: earlier.as_ref(),
        };
        found = Some(best_from(ask, start, budget));
    });
    let Some(found) = found else {
        return FirstCost::Unknown;
    };
    let least = found.costs.filter(|_| settled(found.status));
    *known = cheaper(case, known.take(), found.plan.zip(found.costs));
    let (Some(least), Some(reach)) = (least, found.reach) else {
        return FirstCost::Unknown;
    };
    if least.get(first) <= before {
        return FirstCost::Same;
    }
    let other = known.clone();
    let deltas = other.as_ref().map(|(_, costs)| case.deltas(costs));
    FirstCost::Above(Box::new(Compared {
        verdict: Verdict::Costly,
        deltas: deltas.unwrap_or_default(),
        other,
        reach: Some(reach),
        open: Some(StillOpen {
            least: Some((least.get(first), reach)),
        }),
        closest: None,
    }))
}

/// The verdict by the plans that cost the same as the plan, where that is proved to be a best one.
/// One that is closest to it shows that it need not be so: few agents have to change for it, so it
/// is found sooner than any best plan. Where there is none, each plan that is as asked for costs
/// more: the `known` one, or else any.
pub(crate) fn by_closest(
    case: &FittingQuestion,
    known: Option<&(Plan, Costs)>,
    budget: &Rc<Budget>,
) -> Option<Compared> {
    let best = case.optimal?;
    match as_cheap_as(case, case.costs, budget) {
        AsCheap::Plan(plan, is_closest) => {
            let costs = costs(case.instance, &plan)?;
            Some(Compared {
                verdict: Verdict::Needless,
                deltas: case.deltas(&costs),
                other: Some((plan, costs)),
                reach: Some(best),
                open: None,
                closest: Some(is_closest),
            })
        }
        AsCheap::None(proved) => {
            let (plan, costs) = match known {
                Some(known) => known.clone(),
                None => match any_other(case, budget)? {
                    Other::Plan(plan, costs) => (plan, costs),
                    Other::None(reach) => return Some(necessary(reach)),
                },
            };
            Some(Compared {
                verdict: Verdict::Costly,
                deltas: case.deltas(&costs),
                other: Some((plan, costs)),
                reach: Some(proved.and(best)),
                open: Some(StillOpen { least: None }),
                closest: None,
            })
        }
        AsCheap::Unknown => None,
    }
}

/// Whether there is any plan that is as asked for.
enum Other {
    Plan(Plan, Costs),
    /// There is none, as far as that is proved.
    None(Proved),
}

/// Looks for any plan that is as asked for, where that is one thing.
fn any_other(case: &FittingQuestion, budget: &Rc<Budget>) -> Option<Other> {
    if case.conditions().count() != 1 {
        return None;
    }
    let mut found = None;
    case.each(case.objective(), |ask| found = Some(any(ask, budget)));
    let found = found?;
    match (found.plan.zip(found.costs), found.reach) {
        (Some((plan, costs)), _) => Some(Other::Plan(plan, costs)),
        (None, Some(reach)) if found.status == Status::Impossible => Some(Other::None(reach)),
        (None, _) => None,
    }
}

/// There is no plan that is as asked for.
fn necessary(reach: Proved) -> Compared {
    Compared {
        verdict: Verdict::Necessary,
        other: None,
        deltas: BTreeMap::new(),
        reach: Some(reach),
        open: None,
        closest: None,
    }
}
