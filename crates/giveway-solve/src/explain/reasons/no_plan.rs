//! Why there is no plan, and what would help.

use std::rc::Rc;

use giveway_model::Instance;

use super::{REPAIRS, Tell, part_of, small};
use crate::{
    budget::Budget,
    explain::{
        ExplainAnswer, Part, Verdict,
        ask::Found,
        causes::Refuted,
        group::Group,
        repairs::{TriedEdits, Unsolved, repairs, suspects},
        unsolvable::{self, AnyPlan},
        whole::WholePlan,
        words,
    },
};

/// Why there is no plan, where `found` says so.
pub(crate) fn of_no_plan(
    instance: &Instance,
    within: Option<u32>,
    found: &Found,
    whole: WholePlan,
    answer: &mut ExplainAnswer,
    budget: &Rc<Budget>,
    tell: Tell,
) {
    answer.verdict = Verdict::Necessary;
    answer.reach = found.reach.into();
    tell_no_plan(answer, whole, Part::Verdict, tell);
    if !answer.pending.contains(&Part::Witness) {
        return;
    }
    let searching = |times| AnyPlan {
        objective: instance.objective(),
        horizon: found.horizon,
        budget: part_of(budget, times),
        whole,
    };
    let mut any_plan = searching(1);
    (answer.witness, _) = unsolvable::witness(instance, within, &mut any_plan);
    budget.absorb(&any_plan.budget);
    tell_no_plan(answer, whole, Part::Witness, tell);

    let core = found.reach.and_then(|reach| {
        let refuted = Refuted {
            instance,
            asked: &[],
            deadline: within,
            reach,
        };
        small::reason_of_no_plan(&refuted, found, searching, budget)
    });
    let deadline = within.map(|time| whole.time(time));
    answer.core = core.as_ref().map(|core| core.core(instance, deadline));
    tell_no_plan(answer, whole, Part::Core, tell);

    let help = answer.pending.contains(&Part::Repairs);
    let is_large = small::is_large(instance, budget);
    let help = help && (core.is_some() || is_large);
    if let Some(reach) = found.reach.filter(|_| help) {
        let mut any_plan = searching(REPAIRS);
        let broken = Unsolved {
            instance,
            is_large,
            within,
            objective: instance.objective(),
            plan: None,
            asked: &[],
            arriving: None,
            charging: None,
            reach,
            cores: match &core {
                Some(core) => core.sets().map(<[Group]>::to_vec).collect(),
                None => Vec::new(),
            },
            suspects: match &core {
                Some(_) => Vec::new(),
                None => suspects(instance, &[], within.is_some(), (answer, &found.clash)),
            },
            whole,
        };
        let found = repairs(&broken, TriedEdits::default(), &mut any_plan);
        budget.absorb(&any_plan.budget);
        answer.exhaustive = found.exhaustive;
        (answer.repairs, answer.further_repairs) = (found.first, found.further);
    }
    tell_no_plan(answer, whole, Part::Repairs, tell);
}

fn tell_no_plan(answer: &mut ExplainAnswer, whole: WholePlan, part: Part, tell: Tell) {
    answer.words = words::unsolvable(
        answer.reach.within().map(|time| whole.time(time)),
        &answer.witness,
        answer.core.as_ref(),
        &whole.repairs(&answer.repairs, &answer.question),
    );
    tell(answer, part);
}
