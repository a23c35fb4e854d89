//! The findings about a person's own plan.

use std::rc::Rc;

use giveway_model::{Cost, Costs, Instance, Plan, sorting};

use crate::{
    Status,
    budget::Budget,
    explain::{
        ExplainAnswer, Verdict,
        own_plan::{OwnPlanReport, judge},
        whole::WholePlan,
        words,
    },
    search::Proved,
};

/// The findings about a person's own plan.
pub(crate) fn of_own_plan(
    instance: &Instance,
    plan: &Plan,
    within: Option<u32>,
    whole: WholePlan,
    answer: &mut ExplainAnswer,
    budget: &Rc<Budget>,
) {
    let objective = instance.objective();
    let judged: OwnPlanReport = judge(instance, plan, objective, within, whole, budget);
    let costs_of = |plan: &Plan| whole.costs_of(instance, plan).unwrap_or_default();
    let better = judged.better.as_ref().map(|(better, _)| costs_of(better));
    let reach = judged.found.as_ref().and_then(|found| found.reach);
    let latest = reach.and_then(Proved::within).map(|time| whole.time(time));
    let costs = costs_of(plan);
    answer.words = words::own_plan(&judged, objective, &costs, better.as_ref(), latest);
    answer.valid = Some(judged.violations.is_empty());
    answer.optimal = judged.optimal;
    answer.violations = Some(judged.violations);
    answer.verdict = match judged.optimal {
        Some(true) => Verdict::Needless,
        Some(false) => Verdict::Improvable,
        None => Verdict::Unknown,
    };
    answer.excess = judged.excess;
    if let Some(found) = &judged.found {
        let proved = found.status == Status::Optimal;
        answer.reach = found.reach.filter(|_| proved).into();
    }
    let own = judged.costs.filter(|_| answer.valid == Some(true));
    let least: Option<Costs> = judged.better.as_ref().map(|(_, costs)| *costs).or(own);
    if let (Some(least), Some(own)) = (least, own) {
        let more = |cost: Cost| i64::from(least.get(cost)) - i64::from(own.get(cost));
        let costs = objective.costs().iter();
        answer.deltas = sorting::map(costs.map(|&cost| (cost, more(cost))));
    }
    answer.costs = least.or(judged.costs);
    answer.alternative = judged.better.map(|(plan, _)| plan);
}
