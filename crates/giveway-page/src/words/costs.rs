//! Costs and numbers of things in words.

use giveway_model::{Cost, Costs, Objective};

/// The name of a cost within a sentence.
pub const fn name(cost: Cost) -> &'static str {
    match cost {
        Cost::SumOfCosts => "sum of costs",
        other => other.name(),
    }
}

/// The name of a cost by itself.
pub const fn title(cost: Cost) -> &'static str {
    match cost {
        Cost::Makespan => "Makespan",
        Cost::SumOfCosts => "Sum of costs",
        Cost::Charges => "Charges",
        Cost::Moves => "Moves",
        Cost::Waits => "Waits",
    }
}

/// A number of things.
///
/// ```
/// use giveway_page::words::count;
/// assert_eq!(count(1, "agent"), "1 agent");
/// assert_eq!(count(0, "agent"), "0 agents");
/// ```
pub fn count(n: usize, thing: &str) -> String {
    format!("{n} {thing}{}", if n == 1 { "" } else { "s" })
}

/// A number with thin spaces where it is long.
pub fn grouped(n: u64) -> String {
    let digits = n.to_string();
    if digits.len() <= 4 {
        return digits;
    }
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// A cost and its value: `makespan 18`, `1 charge`.
pub fn value(cost: Cost, n: u32) -> String {
    match cost {
        Cost::Makespan | Cost::SumOfCosts => format!("{} {n}", name(cost)),
        Cost::Charges => count(n as usize, "charge"),
        Cost::Moves => count(n as usize, "move"),
        Cost::Waits => count(n as usize, "wait"),
    }
}

/// The costs of an objective with their values, for a sentence.
pub fn values(objective: &Objective, costs: &Costs) -> String {
    let value = |&cost: &Cost| value(cost, costs.get(cost));
    let parts: Vec<String> = objective.costs().iter().map(value).collect();
    parts.join(", ")
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_costs() {
        assert_eq!(value(Cost::Makespan, 18), "makespan 18");
        assert_eq!(value(Cost::SumOfCosts, 35), "sum of costs 35");
        assert_eq!(value(Cost::Charges, 1), "1 charge");
        assert_eq!(value(Cost::Moves, 2), "2 moves");
        assert_eq!(value(Cost::Waits, 0), "0 waits");
    }
}
