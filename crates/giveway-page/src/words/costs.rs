//! Costs and numbers of things in words.

use giveway_model::words::{self, name};
use giveway_model::{Cost, Costs, Objective, tr};

/// The name of a cost by itself.
pub fn title(cost: Cost) -> &'static str {
    match cost {
        Cost::Makespan => tr!("Makespan"),
        Cost::SumOfCosts => tr!("Sum of costs"),
        Cost::Charges => tr!("Charges"),
        Cost::Moves => tr!("Moves"),
        Cost::Waits => tr!("Waits"),
        Cost::Penalty => tr!("Penalty"),
    }
}

/// The costs of an objective with their values, for a sentence.
pub fn values(objective: &Objective, costs: &Costs) -> String {
    words::values(objective.costs(), costs)
}

/// An objective as its costs stand on its button, the words `then` between them
/// left out.
///
/// ```
/// use giveway_model::Objective;
/// use giveway_page::words::objective;
/// assert_eq!(objective(&Objective::default()), ["Makespan", "sum of costs", "charges"]);
/// ```
pub fn objective(objective: &Objective) -> Vec<&'static str> {
    let costs = objective.costs().iter().enumerate();
    costs
        .map(|(i, &cost)| if i == 0 { title(cost) } else { name(cost) })
        .collect()
}
