//! The wait that is asked about, made at each earlier and later place of the way.

use giveway_model::{Cell, Condition, Path, Plan};

use super::{Offer, Variations};
use crate::explain::{
    fitting::FittingQuestion,
    layers::VariationKind,
    waits::{TakenOut, without_waits},
};

/// Offers the plans in which the agent waits as long elsewhere, and all else is as it was; and
/// the plan without the wait.
pub(super) fn slide(found: &mut Variations, condition: &Condition) {
    let case = found.case;
    let Some(taken) = without_waits(case.instance, case.question, case.plan) else {
        return;
    };
    let Some(agent) = case.question.agent() else {
        return;
    };
    // The places that are close to where it waits now come first.
    let length = taken.plan.path(agent).len();
    let here = taken.from as usize;
    let mut places: Vec<usize> = (0..length).collect();
    giveway_model::sorting::sort_by_key(&mut places, |&place| place.abs_diff(here));
    let waited = places
        .into_iter()
        .filter_map(|place| waiting_at(&taken, agent, place));
    let plans = std::iter::once(taken.plan.clone()).chain(waited);
    for plan in plans {
        let offer = Offer {
            kind: VariationKind::Elsewhere,
            agent,
            other: None,
            plan,
        };
        found.offer(condition, offer);
    }
}

/// The plan in which the agent waits at a place of its shorter path, for as long as before.
fn waiting_at(taken: &TakenOut, agent: &str, place: usize) -> Option<Plan> {
    let mut plan = taken.plan.clone();
    let path: &mut Path = plan.paths.get_mut(agent)?;
    let cell = (*path.get(place)?)?;
    let waits = std::iter::repeat_n(Some(cell), taken.steps as usize);
    path.splice(place..place, waits);
    for charge in plan.charges.get_mut(agent).into_iter().flatten() {
        if *charge as usize >= place {
            *charge += taken.steps;
        }
    }
    Some(plan)
}

/// The first wait of an agent in another plan that is not in the plan that is asked about: its
/// cell, and when it begins.
pub(super) fn first_other_wait(
    case: &FittingQuestion,
    agent: &str,
    other: &Plan,
) -> Option<(Cell, u32)> {
    let waits = |path: &[Option<Cell>], time: usize| {
        let pair = path.get(time).zip(path.get(time + 1));
        pair.is_some_and(|(now, next)| now.is_some() && now == next)
    };
    let (before, after) = (case.plan.path(agent), other.path(agent));
    let is_new = |&time: &usize| {
        let same = before.get(time) == after.get(time) && waits(before, time);
        waits(after, time) && !same
    };
    let last = after.len().saturating_sub(1);
    let time = (0..last).find(is_new)?;
    Some(((*after.get(time)?)?, time as u32))
}
