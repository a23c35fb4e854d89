//! The facts that rule something out, looked for by what is cheaper: where few agents are there,
//! by leaving facts out; on a larger floor by growing a smallest set of agents that force it.

use std::collections::BTreeSet;
use std::rc::Rc;

use super::{asked, contrasted, part_of};
use crate::{
    budget::Budget,
    explain::{
        ExplainAnswer, SubsetBound,
        alone::subset_bounds,
        ask::Found,
        causes::{Refuted, find_causes, find_prices, mark_causes},
        contrasted::ContrastSearch,
        group_mus::{CoreFound, Tried, group_mus, group_mus_of_agents},
        growing::{Extending, ForcingSet, smallest_set},
        unsolvable::{self, AnyPlan},
        verdict::FittingQuestion,
    },
};

/// With more agents, leaving facts out of all that there are takes too long.
const FEW_AGENTS: usize = 8;
/// So many times the work of another part may go into the search for a small set of agents.
const GROWING: u64 = 4;

/// A reason, as far as it was found.
pub(super) struct Reason {
    pub(super) core: Option<CoreFound>,
    /// What sets of agents alone need.
    pub(super) alone: Vec<SubsetBound>,
}

/// The reason of a costly or necessary verdict.
pub(super) fn reason_of_case(
    case: &FittingQuestion,
    answer: &ExplainAnswer,
    budget: &Rc<Budget>,
) -> Reason {
    let nothing = Reason {
        core: None,
        alone: Vec::new(),
    };
    let Some(reach) = case.shown else {
        return nothing;
    };
    let asked = asked(case);
    let refuted = || Refuted {
        instance: case.instance,
        asked: &asked,
        deadline: case.within,
        reach,
    };
    let is_large = case.instance.agents().len() > FEW_AGENTS;
    let forcing = is_large
        .then(|| forcing_set(case, &refuted(), answer, budget))
        .flatten();
    let needs = |forcing: Option<&BTreeSet<usize>>| {
        let own = part_of(budget, GROWING);
        let alone = subset_bounds(case, refuted(), answer, forcing, &own);
        budget.absorb(&own);
        alone
    };
    if is_large {
        let alone = needs(forcing.as_ref().map(|it| &it.agents));
        let core = forcing.map(|forcing| {
            let mut inquiry = ContrastSearch {
                budget: part_of(budget, GROWING),
                ..contrasted(case, answer, budget)
            };
            let mut core = group_mus_of_agents(&refuted(), forcing, &mut inquiry);
            budget.absorb(&inquiry.budget);
            let mut inquiry = ContrastSearch {
                budget: part_of(budget, GROWING),
                ..contrasted(case, answer, budget)
            };
            mark_causes(&refuted(), &mut core, &mut inquiry);
            find_prices(&refuted(), &mut core, &mut inquiry, |found| {
                case.whole.costs(found.costs, &found.plan)
            });
            budget.absorb(&inquiry.budget);
            core
        });
        return Reason { core, alone };
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
    }
}

/// A smallest set of agents that alone force the answer to a question about a plan.
fn forcing_set(
    case: &FittingQuestion,
    refuted: &Refuted,
    answer: &ExplainAnswer,
    budget: &Rc<Budget>,
) -> Option<ForcingSet> {
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
    let found = smallest_set(refuted, &mut extending, &mut inquiry);
    budget.absorb(&own);
    found
}

/// The reason why there is no plan, where `found` says so.
pub(super) fn reason_of_no_plan<'a, 'h>(
    refuted: &Refuted,
    found: &Found,
    any_plan: impl Fn(u64) -> AnyPlan<'a, 'h>,
    budget: &Rc<Budget>,
) -> Option<CoreFound> {
    let is_large = refuted.instance.agents().len() > FEW_AGENTS;
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
