//! Costs and claims in words.

use std::collections::BTreeMap;

use giveway_model::{Cost, Costs, Objective};

/// The name of a cost in a sentence.
pub(crate) const fn name(cost: Cost) -> &'static str {
    match cost {
        Cost::SumOfCosts => "sum of costs",
        other => other.name(),
    }
}

/// A cost and its value: `makespan 18`, `1 charge`.
pub(crate) fn value(cost: Cost, n: u32) -> String {
    match cost {
        Cost::Makespan | Cost::SumOfCosts => format!("{} {n}", name(cost)),
        Cost::Charges => count(u64::from(n), "charge"),
        Cost::Moves => count(u64::from(n), "move"),
        Cost::Waits => count(u64::from(n), "wait"),
    }
}

/// A number of things: `1 agent`, `2 agents`.
pub(crate) fn count(n: u64, thing: &str) -> String {
    format!("{n} {thing}{}", if n == 1 { "" } else { "s" })
}

/// The costs, in a list for a sentence.
pub(crate) fn list<'a>(costs: impl IntoIterator<Item = &'a Cost>, values: &Costs) -> String {
    let parts: Vec<String> = costs
        .into_iter()
        .map(|&cost| value(cost, values.get(cost)))
        .collect();
    parts.join(", ")
}

/// The costs of a plan that is not proved best, each with what is proved:
/// `makespan 23, proved at least 22 (gap 4 %); 3 charges`.
pub(crate) fn with_bounds(
    objective: &Objective,
    values: &Costs,
    bounds: &BTreeMap<Cost, u32>,
) -> String {
    let parts: Vec<String> = objective
        .costs()
        .iter()
        .map(|&cost| {
            let n = values.get(cost);
            let said = value(cost, n);
            match bounds.get(&cost) {
                None => said,
                Some(&bound) if bound >= n => format!("{said}, proved"),
                Some(&bound) => format!("{said}, proved at least {bound} (gap {})", gap(bound, n)),
            }
        })
        .collect();
    parts.join("; ")
}

/// What is proved without a plan: `makespan at least 22, charges at least 1`.
pub(crate) fn bounds(objective: &Objective, bounds: &BTreeMap<Cost, u32>) -> String {
    let parts: Vec<String> = objective
        .costs()
        .iter()
        .filter_map(|cost| Some(format!("{} at least {}", name(*cost), bounds.get(cost)?)))
        .collect();
    parts.join(", ")
}

/// How far a bound is below a value, in percent of the value. It never rounds
/// to nothing.
pub(crate) fn gap(bound: u32, value: u32) -> String {
    let percent = 100.0 * f64::from(value.saturating_sub(bound)) / f64::from(value.max(1));
    if percent == 0.0 || percent >= 0.95 {
        format!("{percent:.0} %")
    } else if percent >= 0.1 {
        format!("{percent:.1} %")
    } else {
        "below 0.1 %".to_owned()
    }
}

/// The sentence with one full stop at its end.
pub(crate) fn sentence(text: &str) -> String {
    let text = super::plain::text(text.trim());
    if text.is_empty() || text.ends_with(['.', '!', '?']) {
        text
    } else {
        text + "."
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_things() {
        assert_eq!(value(Cost::SumOfCosts, 35), "sum of costs 35");
        assert_eq!(value(Cost::Charges, 1), "1 charge");
        assert_eq!(value(Cost::Waits, 0), "0 waits");
    }

    #[test]
    fn gaps() {
        let check = |bound, value, expect: &str| assert_eq!(gap(bound, value), expect);
        check(22, 23, "4 %");
        check(23, 23, "0 %");
        check(0, 0, "0 %");
        check(995, 1000, "0.5 %");
        check(9999, 10000, "below 0.1 %");
    }

    #[test]
    fn bounds_of_a_feasible_plan() {
        let values = Costs {
            makespan: 23,
            sum_of_costs: 120,
            charges: 3,
            ..Costs::default()
        };
        let proved = BTreeMap::from([(Cost::Makespan, 23), (Cost::SumOfCosts, 100)]);
        let objective = Objective::default();
        assert_eq!(
            with_bounds(&objective, &values, &proved),
            "makespan 23, proved; sum of costs 120, proved at least 100 (gap 17 %); 3 charges"
        );
        assert_eq!(
            bounds(&objective, &proved),
            "makespan at least 23, sum of costs at least 100"
        );
    }
}
