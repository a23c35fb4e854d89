//! The price of a rule by the answers with it and without it, and what is known of a price that is
//! not settled.

use giveway_model::{Cost, Costs, Objective};

use super::{Price, RulePrice};
use crate::{SolveAnswer, Status};

pub(super) fn difference(with: Costs, without: Costs, cost: Cost) -> i64 {
    i64::from(with.get(cost)) - i64::from(without.get(cost))
}

/// The price of a rule by the answers with it and without it, and whether it is exact.
pub(super) fn compared(
    objective: &Objective,
    with: &SolveAnswer,
    without: &SolveAnswer,
) -> (Price, bool) {
    let vector = |answer: &SolveAnswer| answer.costs.map(|costs| costs.vector(objective));
    match (with.status, without.status) {
        (Status::Optimal, Status::Optimal) => {
            let (with, without) = (vector(with), vector(without));
            match with.cmp(&without) {
                std::cmp::Ordering::Equal => (Price::Free, true),
                std::cmp::Ordering::Greater => (Price::Costs, true),
                // No plan without a rule costs more than one with it.
                std::cmp::Ordering::Less => (Price::Unknown, false),
            }
        }
        (Status::Impossible, Status::Optimal | Status::Feasible) => {
            let makespan = without.costs.map_or(0, |costs| costs.makespan);
            // It is open whether there is a plan with the rule that takes as long.
            let is_covered = with.reach.within().is_none_or(|within| makespan <= within);
            if is_covered {
                (Price::Decides, without.status == Status::Optimal)
            } else {
                (Price::Unknown, false)
            }
        }
        (Status::Impossible, Status::Impossible) => (Price::None, true),
        (
            Status::Optimal | Status::Feasible | Status::Impossible | Status::Unknown,
            Status::Optimal | Status::Feasible | Status::Impossible | Status::Unknown,
        ) => (Price::Unknown, false),
    }
}

/// Keeps what was proved of a price before, as long as it is not known.
pub(super) fn narrow(price: &mut RulePrice, before: &RulePrice) {
    if price.price != Price::Unknown {
        return;
    }
    if price.range_of == before.range_of {
        price.at_least = price.at_least.max(before.at_least);
        let most = [price.at_most, before.at_most];
        price.at_most = most.into_iter().flatten().min();
    } else if price.range_of.is_none() {
        price.range_of = before.range_of;
        (price.at_least, price.at_most) = (before.at_least, before.at_most);
    }
    price.plan = price.plan.take().or_else(|| before.plan.clone());
}

/// The least and the most that a rule can cost: in the first cost of the objective in which the
/// two sides are not proved equal, which is named where it is not the first of all.
pub(super) fn known_so_far(
    objective: &Objective,
    with: &SolveAnswer,
    without: &SolveAnswer,
) -> (Option<Cost>, Option<i64>, Option<i64>) {
    let has_plan = |answer: &SolveAnswer| answer.costs.is_some();
    if !has_plan(with) && with.status == Status::Impossible {
        return (None, None, None);
    }
    let most = |answer: &SolveAnswer, of: Cost| answer.costs.map(|costs| i64::from(costs.get(of)));
    let least = |answer: &SolveAnswer, of: Cost| {
        let bound = answer.bounds.get(&of).copied();
        let optimum = answer.costs.filter(|_| answer.status == Status::Optimal);
        bound.or(optimum.map(|costs| costs.get(of))).map(i64::from)
    };
    // A bound of a later cost is one of the plans with the optimum of those before.
    let is_equal = |of: Cost| {
        let known = most(with, of);
        known.is_some()
            && [least(with, of), most(without, of), least(without, of)] == [known, known, known]
    };
    let costs = objective.costs();
    let equal = costs.iter().take_while(|&&cost| is_equal(cost)).count();
    let Some(&cost) = costs.get(equal).or(costs.last()) else {
        return (None, None, None);
    };
    let at_least = least(with, cost).zip(most(without, cost));
    let at_most = most(with, cost).zip(least(without, cost));
    (
        (costs.first() != Some(&cost)).then_some(cost),
        at_least.map(|(a, b)| (a - b).max(0)),
        at_most.map(|(a, b)| a - b),
    )
}
