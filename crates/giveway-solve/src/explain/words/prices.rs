//! What the whole instance costs without a fact, as a clause.

use giveway_model::words::by;
use giveway_model::{Cost, Costs, Objective, tr};

use crate::explain::{FactGroup, FactGroupKind, FactPrice, Helps};

/// What is left without a fact, beside the costs of the plan that is asked about: the first cost
/// that differs.
///
/// ```
/// use giveway_model::{Costs, Objective};
/// use giveway_solve::explain::{FactPrice, Helps, price_clause};
/// let costs = |makespan| Costs { makespan, ..Costs::default() };
/// let price = FactPrice { fact: 0, costs: costs(15), proved: true };
/// let told = price_clause((&price, Helps::No), &costs(5), &Objective::default());
/// assert_eq!(told, "without it still +10 steps");
/// ```
pub fn price_clause(price: (&FactPrice, Helps), before: &Costs, objective: &Objective) -> String {
    clause(price, true, before, objective)
}

/// The same without the best fact of a group; `None` where that is not known.
pub fn group_price_clause(
    group: &FactGroup,
    before: &Costs,
    objective: &Objective,
) -> Option<String> {
    let is_of_one = match group.kind {
        FactGroupKind::Agent | FactGroupKind::Rule => true,
        FactGroupKind::Agents
        | FactGroupKind::Collisions
        | FactGroupKind::Aisle
        | FactGroupKind::Shelf
        | FactGroupKind::Shelves
        | FactGroupKind::Rules => false,
    };
    let price = group.price.as_ref()?;
    Some(clause((price, group.helps), is_of_one, before, objective))
}

fn clause(
    (price, helps): (&FactPrice, Helps),
    is_of_one: bool,
    before: &Costs,
    objective: &Objective,
) -> String {
    let costs = objective.costs().iter();
    let delta = |&cost: &Cost| i64::from(price.costs.get(cost)) - i64::from(before.get(cost));
    let mut deltas = costs.map(|cost| (*cost, delta(cost)));
    let Some((cost, delta)) = deltas.find(|(_, delta)| *delta != 0) else {
        return if is_of_one {
            tr!("without it the same cost").to_owned()
        } else {
            tr!("without one of these the same cost").to_owned()
        };
    };
    let by = by(cost, delta);
    // Where it helps there was no plan before, or a dearer one.
    let is_still = helps != Helps::Yes && delta > 0 && price.proved;
    let at_most = delta > 0 && !price.proved;
    match (is_still, at_most, is_of_one) {
        (true, _, true) => tr!("without it still {by}", by),
        (true, _, false) => tr!("without one of these still {by}", by),
        (false, true, true) => tr!("without it at most {by}", by),
        (false, true, false) => tr!("without one of these at most {by}", by),
        (false, false, true) => tr!("without it: {by}", by),
        (false, false, false) => tr!("without one of these: {by}", by),
    }
}
