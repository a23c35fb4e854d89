//! The claims of cores: limits that robots cannot all keep, and what they need together.

use giveway_model::words::{and, name, value};
use giveway_model::{Cost, tr};

use super::names::{MOST_NAMES, who};
use crate::trace::{AgentLeast, AgentLimit, Core};

/// The claim of a core, without the plans that it speaks of: see [`super::scope`].
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

/// Whether a core has limits of too many robots to say each.
fn is_long(core: &Core) -> bool {
    let more = core.limits.iter().map(|limit| limit.at_most - limit.least);
    let is_uneven = more.clone().min() != more.max();
    is_uneven && core.limits.len() > MOST_NAMES
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
