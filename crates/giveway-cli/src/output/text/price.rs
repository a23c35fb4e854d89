//! The answer of `price` as text.

use std::fmt::Write as _;

use giveway_model::words::{capital, values};
use giveway_model::{Constraint, Instance, Question};
use giveway_solve::Status;
use giveway_solve::explain::{Verdict, facts_claim, facts_title};
use giveway_solve::price::{Price, PriceAnswer, RulePrice, words};
use giveway_solve::words::{reach, reason};

use super::{bold, drawings, solve::work, status_word, title};
use crate::output::plain;

/// The status with all rules, the price of each, and which of them exclude each other.
pub(crate) fn price(instance: &Instance, answer: &PriceAnswer, columns: usize) -> String {
    let mut parts = vec![title(instance), known(answer)];
    parts.push(drawings(instance, answer.plan.as_ref(), columns));
    parts.push(prices(instance, answer));
    if let Some(loosened) = &answer.loosened {
        let sentences = words::loosened(&answer.objective, answer.status, loosened);
        let lines = sentences.iter().map(|it| format!("{}\n", plain::text(it)));
        parts.push(lines.collect());
    }
    parts.push(conflict(instance, answer));
    parts.push(work(&answer.stats));
    parts.retain(|part| !part.is_empty());
    parts.join("\n")
}

fn known(answer: &PriceAnswer) -> String {
    let costs = answer.costs.unwrap_or_default();
    let costs = values(answer.objective.costs(), &costs);
    let (word, rest) = match answer.status {
        Status::Optimal => ("Optimal with all rules", format!(": {costs}.")),
        Status::Feasible => ("Best so far with all rules", format!(": {costs}.")),
        Status::Impossible => ("No plan with all rules", ".".to_owned()),
        Status::Unknown => (
            "Time ran out",
            ": no plan with all rules is known.".to_owned(),
        ),
    };
    let mut text = format!("{}{rest}\n", status_word(answer.status, word));
    if let Some(reason) = answer.reason.as_ref() {
        let _ = writeln!(text, "{}", plain::text(&reason_sentence(reason)));
    }
    if let Some(reach) = reach(answer.reach) {
        let _ = writeln!(text, "{reach}");
    }
    text
}

fn reason_sentence(given: &giveway_solve::Reason) -> String {
    giveway_model::words::sentence(&reason(given))
}

/// A line for each rule, and below it the costs without it where they differ.
fn prices(instance: &Instance, answer: &PriceAnswer) -> String {
    if answer.prices.is_empty() {
        return "The scene has no rule of its own in force.\n".to_owned();
    }
    let mut text = format!("{}\n", bold("Rules"));
    for price in &answer.prices {
        let rule = instance.constraints().get(price.index as usize);
        let rule = rule.map_or_else(String::new, in_full);
        let tag = words::tag(&answer.objective, price);
        let _ = writeln!(text, "  {}: {}", plain::text(&rule), bold(&tag));
        if let Some(beside) = beside(answer, price) {
            let _ = writeln!(text, "    {beside}");
        }
    }
    text
}

/// The sentence of a rule, and its name where it has one.
fn in_full(rule: &Constraint) -> String {
    match &rule.name {
        Some(name) => format!("{name}: {}", rule.sentence()),
        None => rule.sentence(),
    }
}

/// Each cost without the rule, where it is another one or there is none with it.
fn beside(answer: &PriceAnswer, price: &RulePrice) -> Option<String> {
    match price.price {
        Price::Costs | Price::Decides => {}
        Price::Free | Price::None | Price::Unknown => return None,
    }
    let costs = answer.objective.costs().iter();
    let without: Vec<String> = costs
        .filter_map(|&cost| {
            let n = *price.without.get(&cost)?;
            Some(giveway_model::words::value(cost, n))
        })
        .collect();
    let proved = if price.exact {
        ""
    } else {
        " (not proved best)"
    };
    Some(format!("without it: {}{proved}", without.join(", ")))
}

/// Why there is no plan with all rules, and what would help.
fn conflict(instance: &Instance, answer: &PriceAnswer) -> String {
    let Some(core) = &answer.conflict else {
        return String::new();
    };
    let title = facts_title(Verdict::Necessary, core, false);
    let mut text = format!("{}\n", bold(&format!("{title}:")));
    for fact in &core.facts {
        let _ = writeln!(text, "  - {}", plain::text(&capital(&fact.text)));
    }
    let claim = facts_claim(&Question::Unsolvable, Verdict::Necessary, core);
    let _ = writeln!(text, "{claim}");
    if let Some(sentence) = words::switch_off(instance, answer) {
        let _ = writeln!(text, "{}", plain::text(&sentence));
    }
    text
}
