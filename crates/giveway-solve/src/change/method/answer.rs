//! Makes the answer of a method.

use std::collections::BTreeMap;

use giveway_model::{Cost, Costs, Version, sorting};

use super::{
    MethodFound, blocked,
    judged::{disturb_few, judged},
};
use crate::{
    Ended, Reach, Reason, SolveAnswer, Status,
    budget::Stop,
    change::{
        Cause, Method, MethodAnswer,
        compare::{AgentsCompared, compare},
        method_case::{MethodCase, Trouble},
    },
    judged::Judged,
    search::{Aim, Proved},
    walk::Walk,
};

/// The answer where there is nothing to search in.
pub(super) fn without_search(case: &MethodCase<'_, '_>, trouble: Trouble) -> MethodAnswer {
    let (status, reach, ended, reason, cause) = match trouble {
        Trouble::Alone(agent, fault, reason) => {
            // However it is bound, it cannot.
            let cause = Cause {
                agent: case.name(agent).to_owned(),
                kind: fault.kind,
                cell: fault.cell,
                agents: Vec::new(),
                within: None,
                method: Method::Replan,
                held: Vec::new(),
                has_batteries: false,
                rule: fault.rule.and_then(|rule| case.told_rule(rule)),
            };
            let reach = Proved::no_plan(reason);
            (
                Status::Impossible,
                Some(reach),
                Ended::Proof,
                Reason::Cause(Box::new(cause.clone())),
                Some(cause),
            )
        }
        // (Whoever cannot be held to the method is freed before.)
        Trouble::Held(..) => {
            let reason = Stop::Contradiction.into();
            (Status::Unknown, None, Ended::Fault, reason, None)
        }
        Trouble::TooManyWaypoints(agent) => {
            let agent = case.name(agent).to_owned();
            let reason = Reason::ManyWaypoints { agent };
            (Status::Unknown, None, Ended::Size, reason, None)
        }
        Trouble::Stopped(stop) => (Status::Unknown, None, stop.into(), stop.into(), None),
    };
    MethodAnswer {
        result: SolveAnswer::without_plan(status, reach, (ended, reason), case.budget.stats()),
        kept: Vec::new(),
        retimed: Vec::new(),
        rerouted: Vec::new(),
        added: Vec::new(),
        freed: Vec::new(),
        fewest: false,
        fewest_within: None,
        cause,
        closest: false,
    }
}

/// A verdict as an answer: the plan with the fewest agents disturbed, put behind
/// the past and judged.
pub(super) fn answer(case: &MethodCase<'_, '_>, found: &MethodFound) -> MethodAnswer {
    let names = |agents: &mut dyn Iterator<Item = usize>| -> Vec<String> {
        agents.map(|agent| case.name(agent).to_owned()).collect()
    };
    let stop = found.verdict.stop;
    let mut closest = false;
    let best = found.verdict.best.as_ref();
    let claim = (found.verdict.reach, stop);
    let judged = Judged::new(best, &Aim::Best, claim, |(walks, costs)| {
        let near = stop.is_none().then(|| disturb_few(case, found, *costs));
        let near = near.flatten();
        closest = near.as_ref().is_some_and(|near| near.2);
        let near = near
            .as_ref()
            .map(|(walks, same, _)| (walks.as_slice(), same.as_slice()));
        let judge =
            |walks: &[Walk], same: &[bool]| judged(case, &found.problem, &found.freed, walks, same);
        let judged = near.and_then(|(walks, same)| judge(walks, same));
        closest &= judged.is_some();
        judged.or_else(|| judge(walks, &[]))
    });
    let Judged {
        plan, status, stop, ..
    } = judged;
    let reach = Reach::from(judged.reach).later(case.snapshot.at);
    let clash = &found.verdict.clash;
    let cause = match status {
        Status::Impossible => Some(blocked(case, clash, &found.freed, reach.within())),
        _ => found.cause.clone(),
    };
    let reason = match (stop, &cause) {
        (Some(stop), _) => Some(stop.into()),
        (None, Some(cause)) if status == Status::Impossible => {
            Some(Reason::Cause(Box::new(cause.clone())))
        }
        _ => None,
    };
    let comparison = plan.as_ref().map(|(plan, _)| compare(case.snapshot, plan));
    let AgentsCompared {
        kept,
        retimed,
        rerouted,
        added,
    } = comparison.unwrap_or_default();
    let bounds = bounds(case, found, plan.as_ref().map(|(_, costs)| costs));
    let (plan, costs) = plan.unzip();
    MethodAnswer {
        result: SolveAnswer {
            giveway: Version,
            status,
            costs,
            bounds,
            reach,
            ended: Some(Ended::by(stop)),
            reason,
            plan,
            stats: case.budget.stats(),
            trace: None,
        },
        kept,
        retimed,
        rerouted,
        added,
        freed: names(&mut found.freed.iter().copied()),
        fewest: found.fewest,
        fewest_within: found.fewest_within,
        cause,
        closest,
    }
}

/// The proved bounds as costs from time 0: what is past, and that times count
/// from the change, is the same in every plan.
fn bounds(
    case: &MethodCase<'_, '_>,
    found: &MethodFound,
    costs: Option<&Costs>,
) -> BTreeMap<Cost, u32> {
    let at = case.snapshot.at;
    let own = found.verdict.best.as_ref().map(|(_, costs)| costs);
    let bounds = found.verdict.bounds.iter();
    let bounds = bounds.filter_map(|(&cost, &bound)| {
        if cost == Cost::Makespan && bound > 0 {
            return Some((cost, bound + at));
        }
        let (own, costs) = (own?, costs?);
        let past = costs.get(cost).checked_sub(own.get(cost))?;
        Some((cost, past + bound))
    });
    sorting::map(bounds)
}
