//! The answer of a planner in sentences: one text for the page and the command.

mod order;
mod tree;

use giveway_model::words::Later;
use giveway_model::words::{and, name, sentence, values};
use giveway_model::{Constraint, tr, tr_later};

use super::{Lack, PlanAnswer, PlanEnd, StuckAgent};
use crate::Reason;
use crate::words::{Headline, called, reason as told};

pub use order::{around, why_stuck};
pub use tree::{branch, conflict, conflict_lines, constraint, moment, parties, subject};

/// How it ended, in a sentence. It begins with words that may be made bold.
pub fn headline(answer: &PlanAnswer) -> Headline {
    let say = |word: &str, rest: String| Headline {
        word: word.to_owned(),
        rest,
    };
    let costs = answer.costs.unwrap_or_default();
    let costs = || values(answer.objective.costs(), &costs);
    match &answer.ended {
        PlanEnd::Best { .. } => say(tr!("an answer" => "Best plan"), format!(": {}.", costs())),
        PlanEnd::Found => say(tr!("an answer" => "Plan found"), format!(": {}.", costs())),
        PlanEnd::NoOrderWorks {
            tried: 1,
            within,
            stuck,
        } => say(
            tr!("This order does not work"),
            tr!(
                "behind: This order does not work" => " within makespan {within}: {stuck}.",
                within,
                stuck = is_stuck(stuck)
            ),
        ),
        PlanEnd::NoOrderWorks {
            tried,
            within,
            stuck,
        } => {
            let last = is_stuck(stuck);
            say(
                tr!("an answer" => "No plan found"),
                tr!(
                    ": none of {tried} orders works within makespan {within}. In the last, {last}.",
                    tried,
                    within,
                    last
                ),
            )
        }
        PlanEnd::Stopped { reason } if answer.plan.is_some() => {
            let rest = format!(": {}. {}", costs(), sentence(&told(reason)));
            say(tr!("an answer" => "Best so far"), rest)
        }
        PlanEnd::Stopped { reason } => say(&sentence(&told(reason)), NONE_YET.text().to_owned()),
        PlanEnd::Horizon { within } => say(
            tr!("an answer" => "No plan found"),
            tr!(
                ": there is none of makespan at most {within}. There may be a longer one.",
                within
            ),
        ),
        PlanEnd::Refused { lack } => {
            let title = answer.planner.title();
            say(
                tr!("Not for this planner"),
                format!(": {title} {}.", cannot(lack)),
            )
        }
        PlanEnd::Alone { agent, rules } if rules.is_empty() => say(
            tr!("an answer" => "No plan exists"),
            tr!(
                "behind: No plan exists" => ", no matter how many steps you allow: {agent} cannot do its task, even alone.",
                agent
            ),
        ),
        PlanEnd::Alone { agent, rules } => say(
            tr!("an answer" => "No plan exists"),
            tr!(
                "behind: No plan exists" => ", no matter how many steps you allow: {agent} cannot do its task, even alone, because of {rules}.",
                agent,
                rules = called(rules)
            ),
        ),
    }
}

const NONE_YET: Later =
    tr_later!("behind a sentence" => " There may be a plan; none was found yet.");

/// Further remarks, a sentence each: how far a claim reaches, what is proved, what may help.
pub fn notes(answer: &PlanAnswer) -> Vec<String> {
    let first = answer.objective.costs().first();
    let mut notes = Vec::new();
    match (&answer.ended, first) {
        (PlanEnd::Best { reach }, Some(&cost)) => {
            notes.push(match reach.within() {
                None => tr!(
                    "No plan has a smaller {cost}, no matter how many steps you allow.",
                    cost = name(cost)
                ),
                Some(within) => told(&Reason::LeastWithin { cost, within }),
            });
        }
        (PlanEnd::Found, _) => notes.push(tr!("There may be better plans.").to_owned()),
        (PlanEnd::NoOrderWorks { .. }, _) => {
            notes.push(tr!("Another order or another planner may find a plan.").to_owned());
        }
        _ => {}
    }
    let is_best = matches!(answer.ended, PlanEnd::Best { .. });
    for (&cost, &bound) in answer.bounds.iter().filter(|_| !is_best) {
        notes.push(tr!(
            "Proved so far: {cost} is at least {bound}.",
            cost = name(cost),
            bound
        ));
    }
    notes
}

/// `A1 cannot get past A2 and A3`.
fn is_stuck(stuck: &StuckAgent) -> String {
    let StuckAgent { agent, around } = stuck;
    let around: Vec<&str> = around.iter().map(String::as_str).collect();
    match around.as_slice() {
        [] => tr!("{agent} has no way that is left free", agent),
        around => tr!(
            "{agent} cannot get past {others}",
            agent,
            others = and(around)
        ),
    }
}

/// The text after the name of the planner.
fn cannot(lack: &Lack) -> String {
    match lack {
        Lack::NoGoal { agent } => tr!("needs a goal for each robot, and {agent} has none", agent),
        Lack::Batteries { agent } => tr!("cannot plan for batteries, and {agent} has one", agent),
        Lack::Waypoints { agent } => tr!("cannot plan for waypoints, and {agent} has some", agent),
        Lack::ManyWaypoints { agent } => {
            tr!("cannot plan for as many waypoints as {agent} has", agent)
        }
        Lack::SlowZones => tr!("cannot plan for slow zones").to_owned(),
        Lack::SharedGoals { agents: [a, b] } => {
            tr!(
                "needs a goal of its own for each robot, and {a} and {b} share one",
                a,
                b
            )
        }
        Lack::Rules { rules } => {
            let rules: Vec<String> = rules.iter().map(Constraint::called).collect();
            tr!("does not keep {rules}", rules = and(&rules))
        }
        Lack::Questions => tr!("cannot plan for what a question asks").to_owned(),
        Lack::Cost { cost } => tr!(
            "makes makespan or sum of costs least, and the objective begins with {cost}",
            cost = name(*cost)
        ),
    }
}
