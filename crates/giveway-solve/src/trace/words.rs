//! The events of a search in sentences. Each is true by itself: it says of which plans
//! it speaks, and needs no event before it.

mod counted;
mod limits;
mod names;

use std::collections::BTreeMap;

use giveway_model::words::{and, lower, name, sentence as full, value, values};
use giveway_model::{Constraint, Cost, Objective, tr};

use super::{AgentLeast, Cannot, Entrant, FoundBy, Restart, Scope, SearchEvent, Stopped};
use crate::words::{called, clash, known, reason};
use counted::counted;
use names::{in_a_row, who};

pub use limits::claim;

/// An event as a sentence.
pub fn sentence(objective: &Objective, event: &SearchEvent) -> String {
    match event {
        SearchEvent::Alone {
            cost,
            agents,
            at_least,
        } => alone(*cost, agents, *at_least),
        SearchEvent::Plan { costs, by } => {
            let costs = values(objective.costs(), costs);
            match by {
                FoundBy::Given => tr!("The search begins with a plan: {costs}.", costs),
                by => tr!("A plan is found {how}: {costs}.", how = found(*by), costs),
            }
        }
        SearchEvent::Phase { cost, given } => {
            let given = given.iter().map(|(&cost, &n)| value(cost, n));
            let given: Vec<String> = given.collect();
            let given = and(&given);
            match cost {
                Cost::Makespan | Cost::SumOfCosts => {
                    tr!(
                        "Next: the least {cost} with {given}.",
                        cost = name(*cost),
                        given
                    )
                }
                _ => tr!(
                    "Next: the fewest {cost} with {given}.",
                    cost = name(*cost),
                    given
                ),
            }
        }
        SearchEvent::Round { cost } => tr!(
            "Next round: {extras} allowed so far are limited together.",
            extras = extra(*cost)
        ),
        SearchEvent::Entered { agents } => entered(agents),
        SearchEvent::Core(core) => under(&core.scope, core.cost, &claim(core)),
        SearchEvent::Closed {
            cost, scope, to, ..
        } => {
            let claim = tr!("No plan has less than {cost}.", cost = value(*cost, *to));
            under(scope, *cost, &claim)
        }
        SearchEvent::Counted {
            cost,
            agents,
            at,
            at_least,
        } => counted((*cost, *at_least), agents, at),
        SearchEvent::Exhausted { bounds } if bounds.is_empty() => {
            tr!("All positions that the robots can be in together were gone through.").to_owned()
        }
        SearchEvent::Exhausted { bounds } => tr!(
            "All positions that the robots can be in together were gone through. The least: {costs}.",
            costs = told(bounds)
        ),
        SearchEvent::Restarted { why } => match why {
            Restart::MoreTime => {
                tr!("The proof starts over: the first try was a short one.").to_owned()
            }
            Restart::Horizon => {
                tr!("The proof starts over: plans with the least first cost take too many steps.")
                    .to_owned()
            }
        },
        SearchEvent::Met { costs, within } => met(objective, costs, *within),
        SearchEvent::Impossible(cannot) => impossible(cannot),
        SearchEvent::Stopped(stopped) => ended(objective, stopped),
    }
}

/// The rules of the scene's own that an event rests on, as a sentence.
pub fn rests_on(rules: &[Constraint]) -> Option<String> {
    (!rules.is_empty()).then(|| tr!("This rests on {rules}.", rules = called(rules)))
}

/// Of which plans a claim is made, to stand before it: `With makespan 14`. Nothing where
/// it is made of all plans.
pub fn scope(scope: &Scope, cost: Cost) -> Option<String> {
    let mut parts = Vec::new();
    for (&given, &n) in &scope.given {
        parts.push(value(given, n));
    }
    if let Some(n) = scope.at_most {
        parts.push(at_most(cost, n));
    }
    if let Some(n) = scope.within
        && !scope.given.contains_key(&Cost::Makespan)
    {
        parts.push(at_most(Cost::Makespan, n));
    }
    (!parts.is_empty()).then(|| tr!("a limit" => "With {limits}", limits = and(&parts)))
}

/// A claim with the plans that it speaks of.
fn under(plans: &Scope, cost: Cost, claim: &str) -> String {
    match scope(plans, cost) {
        None => claim.to_owned(),
        Some(plans) => format!("{plans}: {claim}"),
    }
}

fn alone(cost: Cost, agents: &[AgentLeast], at_least: u32) -> String {
    let bound = match cost {
        Cost::Makespan | Cost::SumOfCosts => {
            tr!(
                "{cost} at least {least}",
                cost = name(cost),
                least = at_least
            )
        }
        cost => tr!("at least {cost}", cost = value(cost, at_least)),
    };
    match cost {
        Cost::Makespan => {
            let last = agents.iter().find(|agent| agent.least == at_least);
            let who = last.map_or(tr!("A robot"), |agent| agent.agent.as_str());
            tr!(
                "{who} alone needs {n} step: {bound}."
                    | "{who} alone needs {n} steps: {bound}." % at_least,
                who,
                bound
            )
        }
        Cost::SumOfCosts => tr!("Each robot alone, by its fastest way: {bound}.", bound),
        cost => tr!(
            "Each robot alone, with as few {cost} as it can: {bound}.",
            cost = name(cost),
            bound
        ),
    }
}

fn found(by: FoundBy) -> &'static str {
    match by {
        FoundBy::Given => tr!("a plan is found" => "before"),
        FoundBy::Alone => tr!("at once, as the best ways of the robots meet nowhere"),
        FoundBy::Prioritised => tr!("by planning one robot after the other"),
        FoundBy::Lacam => tr!("by LaCAM"),
        FoundBy::Repair => tr!("by repairing collisions, a few robots at a time"),
        FoundBy::Lns => tr!("by planning a few robots anew (neighbourhood search)"),
        FoundBy::Solver => tr!("by the solver"),
        FoundBy::PartlySolver => tr!("by the solver in part, the other robots planned around"),
        FoundBy::Exhaustion => tr!("by going through all positions"),
    }
}

fn entered(agents: &[Entrant]) -> String {
    let names: Vec<&str> = agents.iter().map(|agent| agent.agent.as_str()).collect();
    match agents {
        [one] if one.with.is_empty() => tr!(
            "{agent} joins the proof: its way around the others costs more than alone.",
            agent = one.agent
        ),
        [one] => tr!(
            "{agent} joins the proof: it gets in the way of {others}.",
            agent = one.agent,
            others = in_a_row(&one.with)
        ),
        _ => {
            let with = agents.iter().flat_map(|agent| &agent.with);
            let is_among = |name: &String| names.contains(&name.as_str());
            let who = who(&names);
            if with.into_iter().all(is_among) {
                tr!("{who} join the proof: they get in each other's way.", who)
            } else {
                tr!("{who} join the proof: they get in others' way.", who)
            }
        }
    }
}

fn told(costs: &BTreeMap<Cost, u32>) -> String {
    let parts = costs.iter().map(|(&cost, &n)| value(cost, n));
    parts.collect::<Vec<String>>().join(", ")
}

fn met(objective: &Objective, costs: &BTreeMap<Cost, u32>, within: Option<u32>) -> String {
    let known = objective.costs().iter();
    let parts = known.filter_map(|&cost| Some(value(cost, *costs.get(&cost)?)));
    let parts: Vec<String> = parts.collect();
    let meet = tr!("Plan and bound meet: {costs}.", costs = parts.join(", "));
    if costs.len() < objective.costs().len() {
        return meet; // (how far that reaches is said in the end)
    }
    match within {
        None => tr!("{meet} No plan is better.", meet),
        Some(n) => tr!("{meet} No plan of makespan at most {n} is better.", meet, n),
    }
}

fn impossible(cannot: &Cannot) -> String {
    let names: Vec<&str> = cannot.agents.iter().map(String::as_str).collect();
    let clash = clash(&names);
    match cannot.within {
        None => tr!("No plan exists: {why}", why = in_the_middle(&clash)),
        Some(n) => tr!(
            "No plan of makespan at most {n} exists: {why}",
            n,
            why = in_the_middle(&clash)
        ),
    }
}

/// `The robots cannot ...` behind a colon; a name stands as it is.
fn in_the_middle(sentence: &str) -> String {
    if sentence == clash::<&str>(&[]) {
        lower(sentence)
    } else {
        sentence.to_owned()
    }
}

fn ended(objective: &Objective, stopped: &Stopped) -> String {
    let reason = stopped.reason.as_ref().map(reason);
    let reason = full(&reason.unwrap_or_default());
    match known(objective, &stopped.bounds, stopped.costs.as_ref()).as_str() {
        "" => reason,
        known => tr!("{reason} Proved so far: {known}.", reason, known),
    }
}

fn at_most(cost: Cost, n: u32) -> String {
    match cost {
        Cost::Makespan | Cost::SumOfCosts => {
            tr!("a limit" => "a {cost} of at most {n}", cost = name(cost), n)
        }
        cost => tr!("a limit" => "at most {cost}", cost = value(cost, n)),
    }
}

fn extra(cost: Cost) -> &'static str {
    match cost {
        Cost::Makespan | Cost::SumOfCosts => tr!("late steps"),
        Cost::Charges => tr!("extra charges"),
        Cost::Moves => tr!("extra moves"),
        Cost::Waits => tr!("waits"),
        Cost::Penalty => tr!("penalty beyond that"),
    }
}
