//! Proved bounds of costs in words.

use std::collections::BTreeMap;

use giveway_model::words::{name, value};
use giveway_model::{Cost, Costs, Objective, tr};

/// The bound of each cost in turn: `makespan is 18; sum of costs is at least 33, the best plan so far has
/// 35`.
pub fn known(objective: &Objective, bounds: &BTreeMap<Cost, u32>, best: Option<&Costs>) -> String {
    let parts = objective.costs().iter().filter_map(|&cost| {
        let at_least = *bounds.get(&cost)?;
        let name = name(cost);
        let best = best.map(|costs| costs.get(cost));
        // Charges, moves and waits are counted: their number stands before their name.
        if matches!(cost, Cost::Charges | Cost::Moves | Cost::Waits) {
            let least = value(cost, at_least);
            return Some(match best {
                Some(best) if best == at_least => least,
                Some(best) if best > at_least => {
                    tr!(
                        "at least {least}, the best plan so far has {best}",
                        least,
                        best
                    )
                }
                _ => tr!("at least {least}", least),
            });
        }
        Some(match best {
            Some(best) if best == at_least => tr!("{cost} is {best}", cost = name, best),
            Some(best) if best > at_least => {
                tr!(
                    "{cost} is at least {least}, the best plan so far has {best}",
                    cost = name,
                    least = at_least,
                    best
                )
            }
            _ => tr!("{cost} is at least {least}", cost = name, least = at_least),
        })
    });
    parts.collect::<Vec<_>>().join("; ")
}

/// The costs of a plan that is not proved best, each with what is proved:
/// `makespan 20, proved at least 17; 3 charges`.
pub(super) fn with_bounds(
    objective: &Objective,
    costs: &Costs,
    bounds: &BTreeMap<Cost, u32>,
) -> String {
    let parts = objective.costs().iter().map(|&cost| {
        let n = costs.get(cost);
        let said = value(cost, n);
        match bounds.get(&cost) {
            None => said,
            Some(&bound) if bound >= n => tr!("{cost}, proved", cost = said),
            Some(&bound) => tr!("{cost}, proved at least {bound}", cost = said, bound),
        }
    });
    parts.collect::<Vec<_>>().join("; ")
}
