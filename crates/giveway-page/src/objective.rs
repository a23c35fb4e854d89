//! An objective as a person orders it: each step gives another objective.

use giveway_model::{Cost, Objective, tr};

/// The objective with one cost put before the one above it; unchanged for the
/// first, or where the cost is not in it.
///
/// ```
/// use giveway_model::{Cost, Objective};
/// use giveway_page::objective::raised;
/// let objective = raised(&Objective::default(), Cost::SumOfCosts);
/// assert_eq!(objective.to_string(), "sum-of-costs,makespan,charges");
/// ```
pub fn raised(objective: &Objective, cost: Cost) -> Objective {
    swapped(objective, cost, |at| at.checked_sub(1))
}

/// The objective with one cost put behind the one below it.
pub fn lowered(objective: &Objective, cost: Cost) -> Objective {
    swapped(objective, cost, |at| at.checked_add(1))
}

/// The objective with a cost at its end.
pub fn with(objective: &Objective, cost: Cost) -> Objective {
    let mut costs = objective.costs().to_vec();
    costs.push(cost);
    or_as_it_is(objective, costs)
}

/// The objective without a cost; the last one stays.
pub fn without(objective: &Objective, cost: Cost) -> Objective {
    let costs = objective.costs().iter().copied();
    or_as_it_is(objective, costs.filter(|&other| other != cost).collect())
}

/// The costs that are not in it.
pub fn others(objective: &Objective) -> Vec<Cost> {
    let is_in = |cost: &Cost| objective.costs().contains(cost);
    Cost::USUAL
        .into_iter()
        .filter(|cost| !is_in(cost))
        .collect()
}

fn swapped(objective: &Objective, cost: Cost, to: impl Fn(usize) -> Option<usize>) -> Objective {
    let mut costs = objective.costs().to_vec();
    let from = costs.iter().position(|&other| other == cost);
    if let Some(from) = from
        && let Some(to) = to(from).filter(|&to| to < costs.len())
    {
        costs.swap(from, to);
    }
    or_as_it_is(objective, costs)
}

/// A list that is no objective, being empty or with a cost twice, changes
/// nothing.
fn or_as_it_is(objective: &Objective, costs: Vec<Cost>) -> Objective {
    Objective::new(costs).unwrap_or_else(|_| objective.clone())
}

/// What to know of an objective before it is used; `None` where there is nothing.
///
/// ```
/// use giveway_model::{Cost, Objective};
/// use giveway_page::objective::caution;
/// let of = |costs: &[Cost]| caution(&Objective::new(costs.to_vec()).unwrap()).is_some();
/// assert!(of(&[Cost::Makespan, Cost::Waits]));
/// assert!(!of(&[Cost::Moves, Cost::Waits]) && !of(&[Cost::Makespan]));
/// ```
pub fn caution(objective: &Objective) -> Option<&'static str> {
    let place = |cost: Cost| objective.costs().iter().position(|&other| other == cost);
    let waits = place(Cost::Waits)?;
    let is_free = place(Cost::Moves).is_none_or(|moves| moves > waits);
    is_free.then(|| {
        tr!("Few waits reward driving: a robot that goes to and fro does not wait. Put moves before waits.")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(objective: &Objective, expect: &str) {
        assert_eq!(objective.to_string(), expect);
    }

    #[test]
    fn order() {
        let start = Objective::default();
        check(
            &raised(&start, Cost::Makespan),
            "makespan,sum-of-costs,charges",
        );
        check(
            &raised(&start, Cost::Charges),
            "makespan,charges,sum-of-costs",
        );
        check(
            &lowered(&start, Cost::Makespan),
            "sum-of-costs,makespan,charges",
        );
        check(
            &lowered(&start, Cost::Charges),
            "makespan,sum-of-costs,charges",
        );
        check(
            &lowered(&start, Cost::Waits),
            "makespan,sum-of-costs,charges",
        );
    }

    #[test]
    fn what_is_in_it() {
        let start = Objective::default();
        assert_eq!(others(&start), [Cost::Moves, Cost::Waits]);
        check(
            &with(&start, Cost::Waits),
            "makespan,sum-of-costs,charges,waits",
        );
        check(
            &with(&start, Cost::Charges),
            "makespan,sum-of-costs,charges",
        );
        let one = without(&without(&start, Cost::Makespan), Cost::Charges);
        check(&one, "sum-of-costs");
        check(&without(&one, Cost::SumOfCosts), "sum-of-costs");
    }
}
