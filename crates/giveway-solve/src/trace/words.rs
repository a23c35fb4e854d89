//! The events of a search in sentences. Each is true by itself: it says of which plans
//! it speaks, and needs no event before it.

use std::collections::BTreeMap;

use giveway_model::words::{and, capital, lower, name, sentence as full, value, values};
use giveway_model::{Cell, Constraint, Cost, Objective, tr};

use super::{
    AgentLeast, AgentLimit, Bottleneck, Cannot, Core, Entrant, FoundBy, Restart, Scope,
    SearchEvent, Stopped,
};
use crate::words::{called, clash, known, reason};

/// More robots are counted instead of named.
const MOST_NAMES: usize = 4;

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

/// What counting shows.
fn counted((cost, at_least): (Cost, u32), agents: &[String], at: &Bottleneck) -> String {
    let robots = if agents.len() > MOST_NAMES {
        tr!("{n} robot" | "{n} robots" % agents.len())
    } else {
        and(agents)
    };
    let cost = value(cost, at_least);
    match at {
        Bottleneck::Passage(cells) => {
            let (first, last) = (cells.first(), cells.last());
            let at = |cell: Option<&Cell>| cell.map_or_else(String::new, Cell::to_string);
            if first == last {
                tr!(
                    "{robots} have to pass {cell}, one after the other: no plan has less than {cost}.",
                    robots,
                    cell = at(first),
                    cost
                )
            } else {
                tr!(
                    "{robots} have to pass from {first} to {last}, one after the other: no plan has less than {cost}.",
                    robots,
                    first = at(first),
                    last = at(last),
                    cost
                )
            }
        }
        Bottleneck::Zone { rule, most } => tr!(
            "{robots} have to pass the zone of rule {number}, at most {most} at a time: no plan has less than {cost}.",
            robots,
            number = rule + 1,
            most,
            cost
        ),
    }
}

/// The rules of the scene's own that an event rests on, as a sentence.
pub fn rests_on(rules: &[Constraint]) -> Option<String> {
    (!rules.is_empty()).then(|| tr!("This rests on {rules}.", rules = called(rules)))
}

/// The claim of a core, without the plans that it speaks of: see [`scope`].
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

/// Whether a core has limits of too many robots to say each.
fn is_long(core: &Core) -> bool {
    let more = core.limits.iter().map(|limit| limit.at_most - limit.least);
    let is_uneven = more.clone().min() != more.max();
    is_uneven && core.limits.len() > MOST_NAMES
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

/// `A3 cannot be on time: other robots are in its way.`
fn cannot_alone(core: &Core, limit: &AgentLimit) -> String {
    let AgentLimit {
        agent,
        least,
        at_most,
    } = limit;
    let late = at_most.saturating_sub(*least);
    let cannot = match (core.cost, late) {
        (Cost::Makespan, _) => tr!(
            "{agent} cannot arrive by time {time}",
            agent,
            time = at_most
        ),
        (Cost::SumOfCosts, 0) => tr!("{agent} cannot be on time", agent),
        (Cost::SumOfCosts, late) => {
            tr!(
                "{agent} is at least {n} step late"
                    | "{agent} is at least {n} steps late" % late + 1,
                agent
            )
        }
        (Cost::Waits, 0) => tr!("{agent} cannot do without waiting", agent),
        (cost, _) => tr!(
            "{agent} needs more than {cost}",
            agent,
            cost = value(cost, *at_most)
        ),
    };
    // Alone it could, among all plans; among others that may be the reason.
    let plans = &core.scope;
    let are_all = plans.given.is_empty() && plans.at_most.is_none() && plans.within.is_none();
    if are_all && at_most >= least {
        tr!("{cannot}: other robots are in its way.", cannot)
    } else {
        format!("{cannot}.")
    }
}

/// `A3 and A7 cannot both be on time.`
fn cannot_keep(cost: Cost, limits: &[AgentLimit]) -> String {
    let names: Vec<&str> = limits.iter().map(|limit| limit.agent.as_str()).collect();
    let all = match limits.len() {
        2 => tr!("two robots cannot" => "both "),
        _ => tr!("robots cannot" => "all "),
    };
    let first = limits.first();
    let same = |of: fn(&AgentLimit) -> u32| {
        let first = first.map(of);
        first.filter(|&first| limits.iter().all(|limit| of(limit) == first))
    };
    let who = who(&names);
    if cost == Cost::Makespan {
        return match same(|limit| limit.at_most) {
            Some(by) => tr!("{who} cannot {all}arrive by time {by}.", who, all, by),
            None => one_by_one(cost, limits),
        };
    }
    match (same(|limit| limit.at_most - limit.least), cost) {
        (Some(0), Cost::SumOfCosts) => tr!("{who} cannot {all}be on time.", who, all),
        (Some(0), Cost::Waits) => tr!("{who} cannot {all}do without waiting.", who, all),
        (Some(0), _) => tr!(
            "{who} cannot {all}have as few {cost} as alone.",
            who,
            all,
            cost = name(cost)
        ),
        (Some(more), Cost::SumOfCosts) => {
            tr!(
                "{who} cannot {all}be at most {n} step late."
                    | "{who} cannot {all}be at most {n} steps late." % more,
                who,
                all
            )
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
                (Cost::Makespan, _) => tr!(
                    "{agent} arrives by time {time}",
                    agent,
                    time = limit.at_most
                ),
                (Cost::SumOfCosts, 0) => tr!("{agent} is on time", agent),
                (Cost::SumOfCosts, more) => {
                    tr!(
                        "{agent} is at most {n} step late"
                            | "{agent} is at most {n} steps late" % more,
                        agent
                    )
                }
                _ => tr!(
                    "{agent} has at most {cost}",
                    agent,
                    cost = value(cost, limit.at_most)
                ),
            }
        })
        .collect();
    tr!(
        "This is not possible together: {limits}.",
        limits = and(&parts)
    )
}

/// `Six robots need 6 late steps together; 5 are not enough.` `A1 and A2 need at least 1
/// late step together.`
fn need(cost: Cost, agents: &[AgentLeast], more: u32) -> String {
    let names: Vec<&str> = agents.iter().map(|agent| agent.agent.as_str()).collect();

    let what = match cost {
        Cost::Makespan | Cost::SumOfCosts => tr!("{n} late step" | "{n} late steps" % more),
        cost => tr!("{cost} more than alone", cost = value(cost, more)),
    };
    let who = who(&names);
    let is_one = names.len() == 1;
    match more {
        0 | 1 if is_one => tr!("{who} needs at least {what}.", who, what),
        0 | 1 => tr!("{who} need at least {what} together.", who, what),
        more if is_one => tr!(
            "{who} needs {what}; {n} is not enough."
                | "{who} needs {what}; {n} are not enough." % more - 1,
            who,
            what
        ),
        more => tr!(
            "{who} need {what} together; {n} is not enough."
                | "{who} need {what} together; {n} are not enough." % more - 1,
            who,
            what
        ),
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
        5 => tr!("five robots"),
        6 => tr!("six robots"),
        7 => tr!("seven robots"),
        8 => tr!("eight robots"),
        9 => tr!("nine robots"),
        10 => tr!("ten robots"),
        11 => tr!("eleven robots"),
        12 => tr!("twelve robots"),
        n => return tr!("{n} robot" | "{n} robots" % n),
    };
    number.to_owned()
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
