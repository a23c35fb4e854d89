//! The verdict on a plan of elsewhere: is it legal, and how good is it?

use giveway_model::check::{Rule, Violation};
use giveway_model::{Assumption, Cost, Costs, tr};
use giveway_solve::audit::words::percent;

use super::gap::{Gap, Known};
use super::{Audit, Dropped};
use crate::words::name;

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
        let robots = plan.answer.draft.agents().len();
        let sentence = tr!(
            "{first} starts elsewhere: {fit} of {n} robot fit."
                | "{first} starts elsewhere: {fit} of {n} robots fit." % robots,
            first,
            fit
        );
        new(
            ["broken", "cancel", tr!("Not for this scene")],
            String::new(),
            sentence,
        )
    } else {
        let sentence = illegal(audit, costs, known);
        new(
            ["broken", "cancel", tr!("Not legal")],
            broken(plan),
            sentence,
        )
    }
}

/// `3 collisions`, where that is all that goes wrong; else `5 rules broken`.
fn broken(plan: &Dropped) -> String {
    let is_collision = |violation: &Violation| {
        matches!(violation.rule, Rule::Vertex | Rule::Swap | Rule::SlowSwap)
    };
    let many = plan.violations.len();
    if plan.violations.iter().all(is_collision) {
        tr!("{n} collision" | "{n} collisions" % many)
    } else {
        tr!("{n} rule broken" | "{n} rules broken" % many)
    }
}

/// `costs 79`, `has makespan 14`.
fn has(cost: Cost, n: impl std::fmt::Display) -> String {
    match cost {
        Cost::SumOfCosts => tr!("a plan" => "costs {n}", n),
        _ => tr!("a plan and its cost" => "has {cost} {n}", cost = name(cost), n),
    }
}

/// Why an illegal plan tells nothing of what a legal one costs.
fn illegal(audit: &Audit, costs: Option<Costs>, known: &Known) -> String {
    if known.is_impossible {
        return tr!("No legal plan exists for this scene.").to_owned();
    }
    let first = audit.objective().costs().first().copied();
    let (Some(costs), Some(cost)) = (costs, first) else {
        return String::new();
    };
    let value = costs.get(cost);
    let this = has(cost, value);
    match known.bounds.get(&cost) {
        Some(&bound) if value < bound => {
            let least = has(cost, tr!("at least {bound}", bound));
            tr!(
                "It {this}, and every legal plan {least}. So it had to break a rule.",
                this,
                least
            )
        }
        Some(&bound) => {
            let least = has(cost, tr!("at least {bound}", bound));
            tr!(
                "It {this} as it stands. Every legal plan {least}.",
                this,
                least
            )
        }
        None => tr!("It {this} as it stands.", this),
    }
}

fn legal(audit: &Audit, costs: Option<Costs>, known: &Known, is_running: bool) -> Verdict {
    let legal = ["fine", "check", tr!("Legal")];
    let Some(costs) = costs else {
        return new(legal, String::new(), tr!("It keeps every rule.").to_owned());
    };
    match Gap::of(audit.objective(), &costs, known) {
        Gap::None => {
            let words: Vec<String> = audit
                .objective()
                .costs()
                .iter()
                .take(1)
                .map(|&cost| {
                    let bound = costs.get(cost);
                    let least = has(cost, tr!("at least {bound}", bound));
                    tr!("costs at least so much" => "Every plan {least}.", least)
                })
                .collect();
            let scene = audit.plan.answer.draft.scene();
            let detail = if scene.assumptions.contains(&Assumption::GoalsChosen) {
                tr!("proved for the goals chosen")
            } else {
                tr!("proved")
            };
            new(
                ["checked", "proved", tr!("No plan is better")],
                detail.to_owned(),
                words.join(" "),
            )
        }
        Gap::Above {
            cost,
            value,
            bound,
            is_reached,
        } => {
            let above = percent(value, bound, is_reached)
                .unwrap_or_else(|| value.saturating_sub(bound).to_string());
            let this = has(cost, value);
            let sentence = if is_reached {
                tr!(
                    "{above} above the best. There is a plan that {best}, and this one {this}.",
                    above,
                    best = has(cost, bound),
                    this
                )
            } else {
                let least = has(cost, tr!("at least {bound}", bound));
                tr!(
                    "At most {above} above the best. Every plan {least}, and this one {this}.",
                    above,
                    least,
                    this
                )
            };
            new(legal, String::new(), sentence)
        }
        Gap::Unknown if is_running => new(
            legal,
            String::new(),
            tr!("It keeps every rule. The search for what the best plan costs has begun.")
                .to_owned(),
        ),
        Gap::Unknown => new(
            legal,
            String::new(),
            tr!("It keeps every rule. Find a better plan to learn how good it is.").to_owned(),
        ),
    }
}
