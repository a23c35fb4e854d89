//! Judges how a plan goes on after a change, by the change engine.

use giveway_solve::Response;
use giveway_solve::change::Method;

use super::proved::{self, Proved};
use super::{Judging, Situation, Verdict, Why, ask};
use crate::lesson::task::Change;

pub(super) fn begin(task: &Change, situation: Situation<'_>, method: Method) -> Judging {
    match &situation.step.plan {
        Some(plan) if task.methods.contains(&method) => {
            let changes = &task.changes;
            Judging::Ask(vec![ask::change(situation.scene, plan, changes, method)])
        }
        _ => Verdict::not_yet(Why::Untouched).into(),
    }
}

pub(super) fn conclude(
    task: &Change,
    _: Situation<'_>,
    method: Method,
    responses: &[Response],
) -> Verdict {
    let Some(Response::Changed(answer)) = responses.first() else {
        return Verdict::not_yet(proved::unexpected(responses.first()));
    };
    let Some(found) = answer.methods.get(method) else {
        return Verdict::not_yet(Why::NoWayOn(method));
    };
    // Any plan that reaches the aim will do, whether or not it is proved best.
    let (Some(costs), Some(plan)) = (found.result.costs, &found.result.plan) else {
        let why = match proved::answer(&found.result) {
            Err(why) => why,
            Ok(Proved::Best(..) | Proved::NoPlan) => Why::NoWayOn(method),
        };
        return Verdict::not_yet(why);
    };
    let kept = found.kept.len() as u32;
    let cost = task
        .cost
        .map(|limit| (limit.cost, costs.get(limit.cost), limit.at_most));
    let is_cheap = cost.is_none_or(|(_, value, at_most)| value <= at_most);
    let is_calm = task.kept.is_none_or(|wanted| kept >= wanted);
    let why = Why::Went {
        method,
        cost,
        kept,
        wanted: task.kept,
    };
    let evidence = crate::port::Evidence {
        plan: Some(plan.clone()),
        changes: Some(task.changes.clone()),
        ..Default::default()
    };
    Verdict::if_holds(is_cheap && is_calm, why).with(evidence)
}
