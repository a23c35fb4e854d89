//! From what the judge and the search say to what is claimed of a plan.

use std::collections::BTreeMap;

use giveway_model::{Cost, Costs, Objective, Version, check::Report};

use super::{AuditAnswer, AuditStatus, gap};
use crate::{Ended, SolveAnswer, Stats, Status, budget::Stop};

/// The claim about an audited plan. The search is not trusted: where it contradicts the judge, nothing is
/// claimed at all.
pub(super) fn conclude(objective: Objective, report: Report, search: SolveAnswer) -> AuditAnswer {
    let legal = report.is_valid();
    let own = report.costs.filter(|_| legal);
    let is_broken = search.ended == Some(Ended::Fault);
    let contradicts = is_broken || legal && !agrees(&objective, own.as_ref(), &search);
    let search = if contradicts {
        nothing(search.stats)
    } else {
        search
    };
    let found = search.plan.zip(search.costs);
    let vector = |costs: &Costs| costs.vector(&objective);
    let better = found.filter(|(_, found)| own.is_none_or(|own| vector(found) < vector(&own)));
    let is_best = search.status == Status::Optimal && better.is_none();
    let gap = own.and_then(|own| gap(&objective, &own, &search.bounds));
    let status = match (legal, is_best) {
        (false, _) => AuditStatus::Illegal,
        (true, true) => AuditStatus::Optimal,
        (true, false) if search.bounds.is_empty() && better.is_none() => AuditStatus::Unknown,
        (true, false) => AuditStatus::Feasible,
    };
    let (better, better_costs) = better.unzip();
    AuditAnswer {
        giveway: Version,
        legal,
        violations: report.violations,
        objective,
        costs: report.costs,
        bounds: search.bounds,
        reach: search.reach,
        status,
        gap,
        better,
        better_costs,
        search: search.status,
        reason: search.reason,
        stats: search.stats,
    }
}

/// Whether a search can be right, seen that a legal plan has these costs.
fn agrees(objective: &Objective, own: Option<&Costs>, search: &SolveAnswer) -> bool {
    let Some(own) = own else {
        return false;
    };
    let is_best = search.status == Status::Optimal;
    let found = search.costs.map(|costs| costs.vector(objective));
    let beaten = is_best && found.is_none_or(|found| own.vector(objective) < found);
    search.status != Status::Impossible && !beaten && keeps(objective, own, &search.bounds)
}

/// Whether costs are no less than the bounds, each among plans that are best in the
/// costs before it.
fn keeps(objective: &Objective, own: &Costs, bounds: &BTreeMap<Cost, u32>) -> bool {
    for &cost in objective.costs() {
        match bounds.get(&cost) {
            Some(&bound) if own.get(cost) < bound => return false,
            Some(&bound) if own.get(cost) == bound => {}
            _ => return true,
        }
    }
    true
}

/// A search of which nothing is believed.
fn nothing(stats: Stats) -> SolveAnswer {
    let reason = (Ended::Fault, Stop::Contradiction.into());
    SolveAnswer::without_plan(Status::Unknown, None, reason, stats)
}
