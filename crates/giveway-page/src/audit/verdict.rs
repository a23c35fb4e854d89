//! The verdict on a plan of elsewhere: is it legal, and how good is it?

use giveway_model::check::{Rule, Violation};
use giveway_model::words::capital;
use giveway_model::{Cost, Costs};

use super::gap::{Gap, Known, percent};
use super::{Audit, Dropped};
use crate::words::{count, name};

/// What is said of the plan as a whole.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// Its class in the style sheet.
    pub class: String,
    /// Its icon.
    pub icon: String,
    /// The word on it.
    pub word: String,
    /// A few words more; empty where there are none.
    pub detail: String,
    /// The sentence.
    pub sentence: String,
}

fn new(look: [&str; 3], detail: String, sentence: String) -> Verdict {
    let [class, icon, word] = look;
    Verdict {
        class: class.to_owned(),
        icon: icon.to_owned(),
        word: word.to_owned(),
        detail,
        sentence,
    }
}

/// The verdict by what is known of the scene; a search may be running.
pub(super) fn verdict(audit: &Audit, known: &Known, is_running: bool) -> Verdict {
    let plan = &*audit.plan;
    let costs = plan.answer.solved.costs;
    if plan.is_legal() {
        legal(audit, costs, known, is_running)
    } else if let Some(first) = plan.strangers().next() {
        let fit = plan.answer.draft.agents().len() - plan.strangers().count();
        let robots = count(plan.answer.draft.agents().len(), "robot");
        let sentence = format!("{first} starts elsewhere: {fit} of {robots} fit.");
        new(
            ["necessary", "cancel", "Not for this scene"],
            String::new(),
            sentence,
        )
    } else {
        let sentence = illegal(audit, costs, known);
        new(["necessary", "cancel", "Not legal"], broken(plan), sentence)
    }
}

/// `3 collisions`, where that is all that goes wrong; else `5 rules broken`.
fn broken(plan: &Dropped) -> String {
    let is_collision = |violation: &Violation| {
        matches!(violation.rule, Rule::Vertex | Rule::Swap | Rule::SlowSwap)
    };
    let many = plan.violations.len();
    if plan.violations.iter().all(is_collision) {
        count(many, "collision")
    } else {
        format!("{} broken", count(many, "rule"))
    }
}

/// `costs 79`, `has makespan 14`.
fn has(cost: Cost, n: impl std::fmt::Display) -> String {
    match cost {
        Cost::SumOfCosts => format!("costs {n}"),
        _ => format!("has {} {n}", name(cost)),
    }
}

/// Why an illegal plan tells nothing of what a legal one costs.
fn illegal(audit: &Audit, costs: Option<Costs>, known: &Known) -> String {
    if known.is_impossible {
        return "No legal plan exists for this scene.".to_owned();
    }
    let first = audit.objective().costs().first().copied();
    let (Some(costs), Some(cost)) = (costs, first) else {
        return String::new();
    };
    let value = costs.get(cost);
    let this = has(cost, value);
    match known.bounds.get(&cost) {
        Some(&bound) if value < bound => {
            let least = has(cost, format!("at least {bound}"));
            format!("It {this}, and every legal plan {least}. So it had to break a rule.")
        }
        Some(&bound) => {
            let least = has(cost, format!("at least {bound}"));
            format!("It {this} as it stands. Every legal plan {least}.")
        }
        None => format!("It {this} as it stands."),
    }
}

fn legal(audit: &Audit, costs: Option<Costs>, known: &Known, is_running: bool) -> Verdict {
    let legal = ["fine", "check", "Legal"];
    let Some(costs) = costs else {
        return new(legal, String::new(), "It keeps every rule.".to_owned());
    };
    match Gap::of(audit.objective(), &costs, known) {
        Gap::None => {
            let words: Vec<String> = audit
                .objective()
                .costs()
                .iter()
                .take(1)
                .map(|&cost| {
                    capital(&format!(
                        "every plan {}.",
                        has(cost, format!("at least {}", costs.get(cost)))
                    ))
                })
                .collect();
            new(
                ["checked", "proved", "No plan is better"],
                "proved".to_owned(),
                words.join(" "),
            )
        }
        Gap::Above {
            cost,
            value,
            bound,
            is_reached,
        } => {
            let above = percent(value, bound);
            let this = has(cost, value);
            let sentence = if is_reached {
                format!(
                    "{above} % above the best. There is a plan that {}, and this one {this}.",
                    has(cost, bound)
                )
            } else {
                let least = has(cost, format!("at least {bound}"));
                format!(
                    "At most {above} % above the best. Every plan {least}, and this one {this}."
                )
            };
            new(legal, String::new(), sentence)
        }
        Gap::Unknown if is_running => new(
            legal,
            String::new(),
            "It keeps every rule. The search for what the best plan costs has begun.".to_owned(),
        ),
        Gap::Unknown => new(
            legal,
            String::new(),
            "It keeps every rule. Find a better plan to learn how good it is.".to_owned(),
        ),
    }
}
