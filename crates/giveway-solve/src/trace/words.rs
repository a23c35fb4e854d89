//! The events of a search in sentences. Each is true by itself: it says of which plans
//! it speaks, and needs no event before it.

use std::collections::BTreeMap;

use giveway_model::words::{and, capital, count, lower, name, sentence as full, value, values};
use giveway_model::{Cost, Objective};

use super::{
    AgentLeast, AgentLimit, Cannot, Condition, Core, Entrant, FoundBy, Restart, SearchEvent,
    Stopped,
};
use crate::{solve::clash_sentence, words::known};

/// More robots are counted instead of named.
const MOST_NAMES: usize = 4;

/// What an event says.
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
                FoundBy::Given => format!("The search begins with a plan: {costs}."),
                by => format!("A plan is found {}: {costs}.", found(*by)),
            }
        }
        SearchEvent::Phase { cost, given } => {
            let given = given.iter().map(|(&cost, &n)| value(cost, n));
            let given: Vec<String> = given.collect();
            let least = match cost {
                Cost::Makespan | Cost::SumOfCosts => "least",
                _ => "fewest",
            };
            format!("Next: the {least} {} with {}.", name(*cost), and(&given))
        }
        SearchEvent::Round { cost } => format!(
            "Next round: {} allowed so far are limited together.",
            extra(*cost)
        ),
        SearchEvent::Entered { agents } => entered(agents),
        SearchEvent::Core(core) => under(&core.condition, core.cost, &claim(core)),
        SearchEvent::Closed {
            cost,
            condition,
            to,
            ..
        } => {
            let claim = format!("No plan has less than {}.", value(*cost, *to));
            under(condition, *cost, &claim)
        }
        SearchEvent::Exhausted { bounds } => format!(
            "All positions that the robots can be in together were gone through. The least: {}.",
            told(bounds)
        ),
        SearchEvent::Restarted { why } => match why {
            Restart::MoreTime => "The proof starts over: the first try was a short one.".to_owned(),
            Restart::Horizon => {
                "The proof starts over: plans with the least first cost take too many steps."
                    .to_owned()
            }
        },
        SearchEvent::Met { costs, within } => met(objective, costs, *within),
        SearchEvent::Impossible(cannot) => impossible(cannot),
        SearchEvent::Stopped(stopped) => ended(objective, stopped),
    }
}

/// The claim of a core, without the plans that it speaks of: see [`condition`].
pub fn claim(core: &Core) -> String {
    let is_core = core.sums.is_empty();
    match &core.together {
        Some(together) if !is_core || is_long(core) => {
            need(core.cost, &together.agents, together.more)
        }
        _ => match core.limits.as_slice() {
            [limit] => cannot_alone(core, limit),
            limits => cannot_keep(core.cost, limits),
        },
    }
}

/// Of which plans a claim is made, to stand before it: `With makespan 14`. Nothing where
/// it is made of all plans.
pub fn condition(condition: &Condition, cost: Cost) -> Option<String> {
    let mut parts = Vec::new();
    for (&given, &n) in &condition.given {
        parts.push(value(given, n));
    }
    if let Some(n) = condition.at_most {
        parts.push(at_most(cost, n));
    }
    if let Some(n) = condition.within
        && !condition.given.contains_key(&Cost::Makespan)
    {
        parts.push(at_most(Cost::Makespan, n));
    }
    (!parts.is_empty()).then(|| format!("With {}", and(&parts)))
}

/// A claim with the plans that it speaks of.
fn under(plans: &Condition, cost: Cost, claim: &str) -> String {
    match condition(plans, cost) {
        None => claim.to_owned(),
        Some(plans) => format!("{plans}: {claim}"),
    }
}

/// Whether a core has limits of too many robots to say each.
fn is_long(core: &Core) -> bool {
    let more = core.limits.iter().map(|limit| limit.at_most - limit.least);
    let is_uneven = more.clone().min() != more.max();
    is_uneven && core.limits.len() > MOST_NAMES
}

fn alone(cost: Cost, agents: &[AgentLeast], at_least: u32) -> String {
    let bound = match cost {
        Cost::Makespan | Cost::SumOfCosts => format!("{} at least {at_least}", name(cost)),
        cost => format!("at least {}", value(cost, at_least)),
    };
    match cost {
        Cost::Makespan => {
            let last = agents.iter().find(|agent| agent.least == at_least);
            let who = last.map_or("A robot", |agent| agent.agent.as_str());
            let steps = count(at_least, "step");
            format!("{who} alone needs {steps}: {bound}.")
        }
        Cost::SumOfCosts => format!("Each robot alone, by its fastest way: {bound}."),
        cost => format!(
            "Each robot alone, with as few {} as it can: {bound}.",
            cost.name()
        ),
    }
}

const fn found(by: FoundBy) -> &'static str {
    match by {
        FoundBy::Given => "before",
        FoundBy::Alone => "at once, as the best ways of the robots meet nowhere",
        FoundBy::Prioritised => "by planning one robot after the other",
        FoundBy::Lacam => "by LaCAM",
        FoundBy::Repair => "by repairing collisions, a few robots at a time",
        FoundBy::Lns => "by planning a few robots anew (neighbourhood search)",
        FoundBy::Solver => "by the solver",
        FoundBy::PartlySolver => "by the solver in part, the other robots planned around",
        FoundBy::Exhaustion => "by going through all positions",
    }
}

fn entered(agents: &[Entrant]) -> String {
    let names: Vec<&str> = agents.iter().map(|agent| agent.agent.as_str()).collect();
    match agents {
        [one] if one.with.is_empty() => format!(
            "{} joins the proof: its way around the others costs more than alone.",
            one.agent
        ),
        [one] => format!(
            "{} joins the proof: it gets in the way of {}.",
            one.agent,
            in_a_row(&one.with)
        ),
        _ => {
            let with = agents.iter().flat_map(|agent| &agent.with);
            let is_among = |name: &String| names.contains(&name.as_str());
            let whose = if with.into_iter().all(is_among) {
                "each other's"
            } else {
                "others'"
            };
            format!("{} join the proof: they get in {whose} way.", who(&names))
        }
    }
}

/// `A3 cannot be on time: other robots are in its way.`
fn cannot_alone(core: &Core, limit: &AgentLimit) -> String {
    let AgentLimit {
        agent,
        least,
        at_most,
    } = limit;
    let late = at_most.saturating_sub(*least);
    let cannot = match (core.cost, late) {
        (Cost::Makespan, _) => format!("{agent} cannot arrive by time {at_most}"),
        (Cost::SumOfCosts, 0) => format!("{agent} cannot be on time"),
        (Cost::SumOfCosts, late) => {
            format!("{agent} is at least {} late", count(late + 1, "step"))
        }
        (Cost::Waits, 0) => format!("{agent} cannot do without waiting"),
        (cost, _) => format!("{agent} needs more than {}", value(cost, *at_most)),
    };
    // Alone it could, among all plans; among others that may be the reason.
    let plans = &core.condition;
    let are_all = plans.given.is_empty() && plans.at_most.is_none() && plans.within.is_none();
    if are_all && at_most >= least {
        format!("{cannot}: other robots are in its way.")
    } else {
        format!("{cannot}.")
    }
}

/// `A3 and A7 cannot both be on time.`
fn cannot_keep(cost: Cost, limits: &[AgentLimit]) -> String {
    let names: Vec<&str> = limits.iter().map(|limit| limit.agent.as_str()).collect();
    let all = match limits.len() {
        2 => "both ",
        _ => "all ",
    };
    let first = limits.first();
    let same = |of: fn(&AgentLimit) -> u32| {
        let first = first.map(of);
        first.filter(|&first| limits.iter().all(|limit| of(limit) == first))
    };
    let who = who(&names);
    if cost == Cost::Makespan {
        return match same(|limit| limit.at_most) {
            Some(by) => format!("{who} cannot {all}arrive by time {by}."),
            None => one_by_one(cost, limits),
        };
    }
    match (same(|limit| limit.at_most - limit.least), cost) {
        (Some(0), Cost::SumOfCosts) => format!("{who} cannot {all}be on time."),
        (Some(0), Cost::Waits) => format!("{who} cannot {all}do without waiting."),
        (Some(0), _) => format!("{who} cannot {all}have as few {} as alone.", cost.name()),
        (Some(more), Cost::SumOfCosts) => {
            let steps = count(more, "step");
            format!("{who} cannot {all}be at most {steps} late.")
        }
        _ => one_by_one(cost, limits),
    }
}

/// `This is not possible together: A1 on time, A2 at most 1 step late.`
fn one_by_one(cost: Cost, limits: &[AgentLimit]) -> String {
    let parts: Vec<String> = limits
        .iter()
        .map(|limit| {
            let agent = &limit.agent;
            match (cost, limit.at_most - limit.least) {
                (Cost::Makespan, _) => format!("{agent} arrives by time {}", limit.at_most),
                (Cost::SumOfCosts, 0) => format!("{agent} is on time"),
                (Cost::SumOfCosts, more) => {
                    format!("{agent} is at most {} late", count(more, "step"))
                }
                _ => format!("{agent} has at most {}", value(cost, limit.at_most)),
            }
        })
        .collect();
    format!("This is not possible together: {}.", and(&parts))
}

/// `Six robots need 6 late steps together; 5 are not enough.` `A1 and A2 need at least 1
/// late step together.`
fn need(cost: Cost, agents: &[AgentLeast], more: u32) -> String {
    let names: Vec<&str> = agents.iter().map(|agent| agent.agent.as_str()).collect();
    let (needs, together) = match names.as_slice() {
        [_] => ("needs", ""),
        _ => ("need", " together"),
    };
    let what = match cost {
        Cost::Makespan | Cost::SumOfCosts => count(more, "late step"),
        cost => format!("{} more than alone", value(cost, more)),
    };
    let who = who(&names);
    let less = match more {
        0 | 1 => return format!("{who} {needs} at least {what}{together}."),
        more => more - 1,
    };
    let are = if less == 1 { "is" } else { "are" };
    format!("{who} {needs} {what}{together}; {less} {are} not enough.")
}

fn told(costs: &BTreeMap<Cost, u32>) -> String {
    let parts = costs.iter().map(|(&cost, &n)| value(cost, n));
    parts.collect::<Vec<String>>().join(", ")
}

fn met(objective: &Objective, costs: &BTreeMap<Cost, u32>, within: Option<u32>) -> String {
    let known = objective.costs().iter();
    let parts = known.filter_map(|&cost| Some(value(cost, *costs.get(&cost)?)));
    let parts: Vec<String> = parts.collect();
    let meet = format!("Plan and bound meet: {}.", parts.join(", "));
    if costs.len() < objective.costs().len() {
        return meet; // (how far that reaches is said in the end)
    }
    match within {
        None => format!("{meet} No plan is better."),
        Some(n) => format!("{meet} No plan of makespan at most {n} is better."),
    }
}

fn impossible(cannot: &Cannot) -> String {
    let names: Vec<&str> = cannot.agents.iter().map(String::as_str).collect();
    let clash = clash_sentence(&names);
    match cannot.within {
        None => format!("No plan exists: {}", in_the_middle(&clash)),
        Some(n) => format!(
            "No plan of makespan at most {n} exists: {}",
            in_the_middle(&clash)
        ),
    }
}

/// `The robots cannot ...` behind a colon; a name stands as it is.
fn in_the_middle(sentence: &str) -> String {
    if sentence.starts_with("The robots ") {
        lower(sentence)
    } else {
        sentence.to_owned()
    }
}

fn ended(objective: &Objective, stopped: &Stopped) -> String {
    let reason = full(&stopped.reason);
    match known(objective, &stopped.bounds, stopped.costs.as_ref()).as_str() {
        "" => reason,
        known => format!("{reason} Proved so far: {known}."),
    }
}

/// Names, or how many there are, at the beginning of a sentence.
fn who<S: AsRef<str>>(names: &[S]) -> String {
    if names.len() <= MOST_NAMES {
        and(names)
    } else {
        capital(&in_a_row(names))
    }
}

/// The same in the middle of a sentence.
fn in_a_row<S: AsRef<str>>(names: &[S]) -> String {
    if names.len() <= MOST_NAMES {
        return and(names);
    }
    let number = match names.len() {
        5 => "five",
        6 => "six",
        7 => "seven",
        8 => "eight",
        9 => "nine",
        10 => "ten",
        11 => "eleven",
        12 => "twelve",
        n => return format!("{n} robots"),
    };
    format!("{number} robots")
}

fn at_most(cost: Cost, n: u32) -> String {
    match cost {
        Cost::Makespan | Cost::SumOfCosts => format!("a {} of at most {n}", name(cost)),
        cost => format!("at most {}", value(cost, n)),
    }
}

const fn extra(cost: Cost) -> &'static str {
    match cost {
        Cost::Makespan | Cost::SumOfCosts => "late steps",
        Cost::Charges => "extra charges",
        Cost::Moves => "extra moves",
        Cost::Waits => "waits",
    }
}
