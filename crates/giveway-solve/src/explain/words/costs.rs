//! Costs, and how two plans differ in them.

use giveway_model::words::{and, noun};
use giveway_model::{Cost, Costs, Objective, tr};

/// `a makespan of 6 instead of 4 and a sum of costs of 9 instead of 7`: where
/// costs differ, in the order of the objective.
pub(crate) fn instead(objective: &Objective, now: &Costs, before: &Costs) -> String {
    let phrase = |&cost: &Cost| {
        let (now, before) = (now.get(cost), before.get(cost));
        (now != before).then(|| {
            tr!(
                "a {cost} of {now} instead of {before}",
                cost = noun(cost),
                now,
                before
            )
        })
    };
    let phrases: Vec<String> = objective.costs().iter().filter_map(phrase).collect();
    and(&phrases)
}
