//! Prices in words.

use giveway_model::words::{and, or, value};
use giveway_model::{Cost, Instance, Objective, tr};

use super::{Loosened, LooserRule, Price, PriceAnswer, RulePrice};
use crate::{Status, explain};

/// The price of a rule in a few words: `costs nothing`, `costs 2 steps of the makespan`,
/// `no plan with it`. Of the costs that grow it names the first of the objective, and the charges.
///
/// ```
/// use giveway_model::{Cost, Objective};
/// use giveway_solve::price::{Price, RulePrice, words::tag};
/// let price = RulePrice {
///     index: 0, kind: "gap".into(), name: None, price: Price::Costs, exact: true,
///     without: [(Cost::Makespan, 18)].into(), difference: [(Cost::Makespan, 2)].into(),
///     range_of: None, at_least: None, at_most: None, plan: None,
/// };
/// assert_eq!(tag(&Objective::default(), &price), "costs 2 steps of the makespan");
/// ```
pub fn tag(objective: &Objective, price: &RulePrice) -> String {
    match price.price {
        Price::Free => tr!("a price" => "costs nothing").to_owned(),
        Price::Costs => tr!("a price" => "costs {amount}", amount = grown(objective, price)),
        Price::Decides => tr!("a price" => "no plan with it").to_owned(),
        Price::None => tr!("a price" => "no plan without it, either").to_owned(),
        Price::Unknown => {
            let least = price.at_least.filter(|&least| least > 0);
            let first = objective.costs().first().copied();
            match (price.range_of.or(first), least, price.at_most) {
                (None, _, _) | (_, None, None) => tr!("a price" => "not known").to_owned(),
                (Some(_), None, Some(0)) => {
                    tr!("a price" => "costs nothing, as far as is known").to_owned()
                }
                (Some(cost), Some(least), Some(most)) if least < most && cost != Cost::Penalty => {
                    tr!(
                        "a price" => "costs {least} to {amount}",
                        least,
                        amount = amount(cost, most)
                    )
                }
                (Some(cost), Some(least), _) => tr!(
                    "a price" => "costs at least {amount}",
                    amount = amount(cost, least)
                ),
                (Some(cost), None, Some(most)) => tr!(
                    "a price" => "costs at most {amount}",
                    amount = amount(cost, most)
                ),
            }
        }
    }
}

/// By how much a rule makes the costs grow: `2 steps of the makespan and 1 charge`.
pub fn grown(objective: &Objective, price: &RulePrice) -> String {
    let grows = |cost: &Cost| price.difference.get(cost).copied().filter(|&by| by > 0);
    let mut grown = objective.costs().iter();
    let Some((first, by)) = grown.find_map(|cost| Some((*cost, grows(cost)?))) else {
        return String::new();
    };
    let first_amount = amount(first, by);
    match grows(&Cost::Charges).filter(|_| first != Cost::Charges) {
        Some(charges) => and(&[first_amount, amount(Cost::Charges, charges)]),
        None => first_amount,
    }
}

/// How much of a cost something costs, with its unit: `2 steps in all`, `1 charge`.
pub fn amount(cost: Cost, by: i64) -> String {
    let n = u32::try_from(by).unwrap_or(u32::MAX);
    match cost {
        Cost::Makespan => {
            tr!("a price" => "{n} step of the makespan" | "{n} steps of the makespan" % n)
        }
        Cost::SumOfCosts => {
            tr!("a price" => "{n} step in all" | "{n} steps in all" % n)
        }
        Cost::Charges | Cost::Moves | Cost::Waits => value(cost, n),
        Cost::Penalty => tr!("a price" => "a penalty of {n}", n),
    }
}

/// A rule with its price, as a sentence.
pub fn sentence(instance: &Instance, objective: &Objective, price: &RulePrice) -> String {
    let rule = instance.constraints().get(price.index as usize);
    let rule = rule.map_or_else(String::new, |rule| match &rule.name {
        Some(name) => tr!("{name} ({rule})", name, rule = rule.sentence()),
        None => rule.sentence(),
    });
    tr!("{rule}: {price}.", rule, price = tag(objective, price))
}

/// Which rules to switch off, as a sentence; nothing where none would help, or none is known.
pub fn switch_off(instance: &Instance, answer: &PriceAnswer) -> Option<String> {
    let name = |&rule: &u32| {
        let rule = instance.constraints().get(rule as usize);
        rule.map_or_else(String::new, giveway_model::Constraint::called)
    };
    let sets = answer.switch_off.switch_off.iter();
    let sets: Vec<String> = sets
        .map(|set| and(&set.iter().map(name).collect::<Vec<_>>()))
        .collect();
    if sets.is_empty() {
        let is_proved = answer.switch_off.switch_off_settled && !answer.prices.is_empty();
        return is_proved
            .then(|| tr!("Even without any of these rules there is no plan.").to_owned());
    }
    Some(if answer.switch_off.switch_off_settled {
        tr!("There is a plan without {rules}.", rules = or(&sets))
    } else {
        tr!(
            "There is a plan without {rules}. Perhaps fewer would do.",
            rules = or(&sets)
        )
    })
}

/// The costs of the best plan under a looser rule: `makespan 8, sum of costs 21`.
pub fn looser_costs(objective: &Objective, looser: &LooserRule) -> String {
    let costs = objective.costs().iter();
    let costs: Vec<String> = costs
        .filter_map(|cost| Some(giveway_model::words::value(*cost, *looser.costs.get(cost)?)))
        .collect();
    costs.join(", ")
}

/// How a rule can be loosened, in sentences.
pub fn loosened(objective: &Objective, status: Status, loosened: &Loosened) -> Vec<String> {
    let looser = loosened.looser.iter().map(|looser| {
        let costs = looser_costs(objective, looser);
        let rule = looser.rule.sentence();
        if looser.least {
            tr!(
                "Loosened by the least that helps: {rule}. Then {costs}.",
                rule,
                costs
            )
        } else {
            tr!(
                "Loosened: {rule}. Then {costs}. Perhaps less would do.",
                rule,
                costs
            )
        }
    });
    let mut sentences: Vec<String> = looser.collect();
    sentences.extend(nothing_looser(status, loosened).map(str::to_owned));
    sentences
}

/// Why there is no looser rule to take; nothing where there is one.
pub fn nothing_looser(status: Status, loosened: &Loosened) -> Option<&'static str> {
    if !loosened.looser.is_empty() {
        return None;
    }
    Some(match (loosened.can_loosen, loosened.settled, status) {
        (false, _, _) => tr!("This rule has no number and no times to loosen."),
        (true, true, Status::Impossible) => {
            tr!("No looser form of this rule leaves a plan.")
        }
        (true, true, Status::Optimal | Status::Feasible | Status::Unknown) => {
            tr!("No looser form of this rule changes the costs.")
        }
        (true, false, Status::Impossible) => {
            tr!("Time ran out before a looser form of this rule was found that leaves a plan.")
        }
        (true, false, Status::Optimal | Status::Feasible | Status::Unknown) => {
            tr!("Time ran out before a looser form of this rule was found that changes the costs.")
        }
    })
}

/// All prices, and which rules exclude each other.
pub(super) fn all(answer: &PriceAnswer, instance: &Instance) -> String {
    if answer.prices.is_empty() {
        return tr!("The scene has no rule of its own in force.").to_owned();
    }
    let mut sentences = Vec::new();
    if answer.status == Status::Impossible {
        sentences.push(tr!("There is no plan with these rules.").to_owned());
    }
    let prices = answer.prices.iter();
    sentences.extend(prices.map(|price| sentence(instance, &answer.objective, price)));
    if let Some(told) = &answer.loosened {
        sentences.extend(loosened(&answer.objective, answer.status, told));
    }
    sentences.extend(explain::words::because(
        answer.conflict.as_ref(),
        explain::Verdict::Necessary,
    ));
    if answer.conflict.is_some() {
        sentences.extend(switch_off(instance, answer));
    }
    sentences.join(" ")
}
