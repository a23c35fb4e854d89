//! The facts that rule something out, looked for by what is cheaper: where few agents are there,
//! by leaving facts out; on a larger floor by growing a smallest set of agents that force it.

use std::collections::BTreeSet;
use std::rc::Rc;

use giveway_model::{Cost, Instance, Question, check::own_costs, sorting::sort};

use super::{asked, contrasted, part_of};
use crate::{
    budget::Budget,
    explain::{
        ExplainAnswer, SubsetBound, Verdict,
        alone::{forcing_bound, subset_bounds},
        answer::Helps,
        ask::Found,
        causes::{Refuted, find_causes, find_prices, mark_causes, mark_near_causes},
        contrasted::ContrastSearch,
        fitting::FittingQuestion,
        group_mus::{CoreFound, Tried, group_mus, group_mus_of_agents},
        growing::{Extending, ForcingSet, MOST_AGENTS, smallest_set},
        repairs::TriedEdits,
        unsolvable::{self, AnyPlan},
    },
    search::Proved,
};

/// So many times the work of another part may go into the search for a small set of agents.
const GROWING: u64 = 4;
/// And into what is said of it.
const SHRINKING: u64 = 2;

/// A reason, as far as it was found.
pub(super) struct Reason {
    pub(super) core: Option<CoreFound>,
    /// What sets of agents alone need.
    pub(super) alone: Vec<SubsetBound>,
    /// Whether it was not tried yet which of its facts help.
    pub(super) is_unmarked: bool,
}

/// The reason of a costly or necessary verdict; `forcing` are agents that alone force it, where a
/// small set of them was found.
pub(super) fn reason_of_case(
    case: &FittingQuestion,
    answer: &ExplainAnswer,
    forcing: Option<ForcingSet>,
    budget: &Rc<Budget>,
) -> Reason {
    let nothing = Reason {
        core: None,
        alone: Vec::new(),
        is_unmarked: false,
    };
    let Some(reach) = case.shown else {
        return nothing;
    };
    let asked = asked(case);
    let refuted = || refuted(case, &asked, reach);
    if let Some(forcing) = forcing {
        let mut inquiry = contrasted(case, answer, budget);
        let core = group_mus_of_agents(&refuted(), forcing, &mut inquiry);
        budget.absorb(&inquiry.budget);
        return Reason {
            core: Some(core),
            is_unmarked: true,
            ..nothing
        };
    }
    if is_large(case.instance, budget) {
        return Reason {
            alone: needs(case, answer, None, budget),
            ..nothing
        };
    }
    let mut inquiry = contrasted(case, answer, budget);
    let none = Tried::None {
        reach,
        clash: Vec::new(),
    };
    let nothing = BTreeSet::new();
    let core = group_mus(
        case.instance,
        &asked,
        case.within,
        &nothing,
        none,
        &mut inquiry,
    );
    budget.absorb(&inquiry.budget);
    let core = core.map(|mut core| {
        let mut inquiry = contrasted(case, answer, budget);
        find_causes(&refuted(), &mut core, &mut inquiry);
        budget.absorb(&inquiry.budget);
        core
    });
    Reason {
        core,
        alone: Vec::new(),
        is_unmarked: false,
    }
}

/// Whether the floor has so many agents that facts are not left out one by one.
pub(super) fn is_large(instance: &Instance, budget: &Budget) -> bool {
    instance.agents().len() > budget.thresholds().few_agents
}

const fn refuted<'a>(case: &FittingQuestion<'a>, asked: &'a [usize], reach: Proved) -> Refuted<'a> {
    Refuted {
        instance: case.instance,
        asked,
        deadline: case.within,
        reach,
    }
}

/// What sets of agents alone need; `forcing` are agents that alone force the answer.
pub(super) fn needs(
    case: &FittingQuestion,
    answer: &ExplainAnswer,
    forcing: Option<&BTreeSet<usize>>,
    budget: &Rc<Budget>,
) -> Vec<SubsetBound> {
    let Some(reach) = case.shown else {
        return Vec::new();
    };
    let (asked, own) = (asked(case), part_of(budget, SHRINKING));
    let alone = subset_bounds(case, refuted(case, &asked, reach), answer, forcing, &own);
    budget.absorb(&own);
    alone
}

/// What agents alone need that force the answer, where the answer itself says it.
pub(super) fn forcing_needs(
    case: &FittingQuestion,
    answer: &ExplainAnswer,
    forcing: &ForcingSet,
    budget: &Rc<Budget>,
) -> Vec<SubsetBound> {
    let (Some(reach), Question::Makespan) = (case.shown, case.question) else {
        return Vec::new();
    };
    let (asked, own) = (asked(case), part_of(budget, 1));
    let refuted = refuted(case, &asked, reach);
    let bound = forcing_bound(case, refuted, answer, &forcing.agents, &own);
    budget.absorb(&own);
    bound.into_iter().collect()
}

/// Marks the facts of a reason without which a plan near to that of the question is as asked for.
pub(super) fn mark_near(
    case: &FittingQuestion,
    core: &mut CoreFound,
    answer: &ExplainAnswer,
    budget: &Rc<Budget>,
) {
    let Some(reach) = case.shown else { return };
    let asked = asked(case);
    let refuted = refuted(case, &asked, reach);
    let mut inquiry = contrasted(case, answer, budget);
    mark_near_causes(&refuted, core, case.plan, &mut inquiry);
    budget.absorb(&inquiry.budget);
}

/// Finds which facts of a reason help, and what the whole instance costs without these; `tried` are edits
/// that were tried before.
pub(super) fn mark(
    case: &FittingQuestion,
    core: &mut CoreFound,
    (answer, tried): (&ExplainAnswer, &TriedEdits),
    budget: &Rc<Budget>,
) {
    let Some(reach) = case.shown else { return };
    for &fact in &core.groups {
        if let Some(repair) = tried.without(fact, case.instance) {
            let costs = case.whole.costs(repair.costs, &repair.plan);
            core.helps.insert(fact, Helps::Yes);
            core.prices.insert(fact, (costs, repair.proved));
        }
    }
    let asked = asked(case);
    let refuted = refuted(case, &asked, reach);
    let mut inquiry = contrasted(case, answer, budget);
    mark_causes(&refuted, core, &mut inquiry);
    let is_costly = answer.verdict == Verdict::Costly;
    find_prices(&refuted, core, &mut inquiry, is_costly, |found| {
        case.whole.costs(found.costs, &found.plan)
    });
    budget.absorb(&inquiry.budget);
}

/// A smallest set of agents that alone force the answer to a question about a plan, where many
/// agents are there.
pub(super) fn forcing_set(
    case: &FittingQuestion,
    answer: &ExplainAnswer,
    budget: &Rc<Budget>,
) -> Option<ForcingSet> {
    let asked = asked(case);
    if !is_large(case.instance, budget) || is_spread(case, answer, asked.len()) {
        return None;
    }
    let refuted = refuted(case, &asked, case.shown?);
    let other = answer.alternative.as_ref();
    let known = std::iter::once(case.plan).chain(other).cloned();
    let latest = case.costs.makespan;
    let mut inquiry = ContrastSearch {
        budget: part_of(budget, GROWING),
        near: None,
        ..contrasted(case, answer, budget)
    };
    let own = Rc::clone(&inquiry.budget);
    let mut extending = Extending::new(case.instance, known.collect(), latest, &own);
    let found = smallest_set(&refuted, &mut extending, &mut inquiry);
    budget.absorb(&own);
    found
}

/// Whether the other plan costs more in a sum, and without any of the agents that a small set
/// leaves out it costs less than the plan that is asked about: then no small set forces the answer.
fn is_spread(case: &FittingQuestion, answer: &ExplainAnswer, asked: usize) -> bool {
    let (Some(other), Verdict::Costly) = (&answer.alternative, answer.verdict) else {
        return false;
    };
    let more = |cost: &Cost| answer.deltas.get(cost).copied().unwrap_or(0);
    let costs = case.objective().costs().iter();
    let Some(&cost) = costs.into_iter().find(|&cost| more(cost) > 0) else {
        return false;
    };
    let agents = case.instance.agents().iter();
    let own = agents.filter_map(|agent| own_costs(case.instance, &agent.name, other));
    let mut own: Vec<u32> = own.map(|own| own.get(cost)).collect();
    sort(&mut own);
    let left_out = own.len().saturating_sub(asked + MOST_AGENTS);
    let spared: u32 = own.iter().take(left_out).sum();
    cost != Cost::Makespan && i64::from(spared) > more(&cost)
}

/// The reason why there is no plan, where `found` says so.
pub(super) fn reason_of_no_plan<'a, 'h>(
    refuted: &Refuted,
    found: &Found,
    any_plan: impl Fn(u64) -> AnyPlan<'a, 'h>,
    budget: &Rc<Budget>,
) -> Option<CoreFound> {
    let is_large = is_large(refuted.instance, budget);
    if is_large {
        let mut inquiry = any_plan(GROWING);
        let own = Rc::clone(&inquiry.budget);
        let horizon = found.horizon;
        let mut extending = Extending::new(refuted.instance, Vec::new(), horizon, &own);
        let forcing = smallest_set(refuted, &mut extending, &mut inquiry);
        budget.absorb(&own);
        if let Some(forcing) = forcing {
            let mut inquiry = any_plan(GROWING);
            let mut core = group_mus_of_agents(refuted, forcing, &mut inquiry);
            budget.absorb(&inquiry.budget);
            let mut inquiry = any_plan(GROWING);
            mark_causes(refuted, &mut core, &mut inquiry);
            budget.absorb(&inquiry.budget);
            return Some(core);
        }
    }
    let mut inquiry = any_plan(1);
    let (instance, within) = (refuted.instance, refuted.deadline);
    let core = unsolvable::core(instance, within, found, &mut inquiry);
    budget.absorb(&inquiry.budget);
    let mut core = core?;
    let mut inquiry = any_plan(1);
    find_causes(refuted, &mut core, &mut inquiry);
    budget.absorb(&inquiry.budget);
    // A list of everything is no reason.
    (!is_large || core.minimal).then_some(core)
}
