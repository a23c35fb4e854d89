//! How another plan does without what was asked about, and who pays for it: told by comparing
//! it with the plan that was asked about.

use std::cmp::Reverse;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cell, Cost, Instance, Plan, Question, check::own_costs, sorting::sort_by_key};
use serde::{Deserialize, Serialize};

use super::whole::WholePlan;

/// How a plan of the same costs does without what was asked about.
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    BorshSerialize,
    BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum How {
    /// Another agent goes another way, waits more or arrives later.
    Others,
    /// The agent drives more, or other cells.
    OtherWay,
    /// The agent waits at another cell or at another time.
    Elsewhere,
    /// None of these: it was for nothing.
    Free,
}

/// An agent that another plan moves differently.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct AgentDifference {
    /// The agent.
    pub agent: String,
    /// Its arrival in the plan that is asked about.
    pub arrival: u32,
    /// Its arrival in the other plan.
    pub other: u32,
    /// Its wait steps in the other plan less those in the plan that is asked about.
    pub more_waits: i64,
    /// Whether it drives more, or other cells.
    pub other_way: bool,
}

/// What the other plan does instead of what was asked about: all that is so, in the order of
/// [`How`].
pub(crate) fn how(
    question: &Question,
    instance: &Instance,
    (plan, other): (&Plan, &Plan),
    differences: &[AgentDifference],
) -> Vec<How> {
    let asked = question.agent();
    let pays = |it: &AgentDifference| it.other_way || it.more_waits > 0 || it.other > it.arrival;
    let is_asked = |it: &&AgentDifference| Some(it.agent.as_str()) == asked;
    let mut how = Vec::new();
    if differences.iter().any(|it| !is_asked(&it) && pays(it)) {
        how.push(How::Others);
    }
    if let Some(own) = differences.iter().find(is_asked) {
        let gone = i64::from(waits_asked_about(question, instance, plan));
        how.extend(own.other_way.then_some(How::OtherWay));
        // Without those that are asked about it would wait as much less.
        how.extend((own.more_waits + gone > 0).then_some(How::Elsewhere));
    }
    if how.is_empty() && plan.paths != other.paths {
        how.push(How::Free);
    }
    how
}

/// The agents that differ: who arrives later by most is the first, others in the order of the
/// instance. Times are those of the whole plan.
pub(crate) fn differences(
    instance: &Instance,
    (plan, other): (&Plan, &Plan),
    whole: WholePlan,
) -> Vec<AgentDifference> {
    let mut found = Vec::new();
    for agent in instance.agents() {
        let name = &agent.name;
        let own = |plan: &Plan| own_costs(instance, name, plan);
        let (Some(before), Some(after)) = (own(plan), own(other)) else {
            continue;
        };
        if trimmed(plan, name) == trimmed(other, name) && plan.charges(name) == other.charges(name)
        {
            continue;
        }
        let rested = instance.start_state(name).rested;
        let arrival = |sum: u32| whole.time(sum).saturating_sub(rested);
        let waits = |costs: &giveway_model::Costs| i64::from(costs.get(Cost::Waits));
        found.push(AgentDifference {
            agent: name.clone(),
            arrival: arrival(before.sum_of_costs),
            other: arrival(after.sum_of_costs),
            more_waits: waits(&after) - waits(&before),
            other_way: after.moves > before.moves || way(plan, name) != way(other, name),
        });
    }
    let later = |it: &AgentDifference| i64::from(it.other) - i64::from(it.arrival);
    sort_by_key(&mut found, |it| Reverse(later(it)));
    found
}

/// The entries of a path up to the last change of cell.
fn trimmed<'a>(plan: &'a Plan, name: &str) -> &'a [Option<Cell>] {
    let mut path = plan.path(name);
    while let [rest @ .., before, last] = path
        && before == last
    {
        path = plan.path(name).get(..=rest.len()).unwrap_or(path);
    }
    path
}

/// The cells of a path, each once for each stay.
pub(crate) fn way(plan: &Plan, name: &str) -> Vec<Cell> {
    let mut cells: Vec<Cell> = plan.path(name).iter().copied().flatten().collect();
    cells.dedup();
    cells
}

/// The wait steps that a question about waits wants to be gone; of a long wait those that make
/// it long.
fn waits_asked_about(question: &Question, instance: &Instance, plan: &Plan) -> u32 {
    let Question::Wait {
        agent,
        at,
        from,
        to,
        at_least,
    } = question
    else {
        return 0;
    };
    let path = trimmed(plan, agent);
    let here = |cell: Option<Cell>| cell.is_some() && at.is_none_or(|at| cell == Some(at));
    let first = from.unwrap_or(0);
    let last = to.unwrap_or(u32::MAX);
    let is_asked = |now: u32, pair: &[Option<Cell>]| {
        let in_time = first <= now && now.saturating_add(1) <= last;
        in_time && pair.first() == pair.last() && here(pair.first().copied().flatten())
    };
    // (What lies before the instance belongs to a long wait, too.)
    let (mut gone, mut run) = (0, instance.start_state(agent).waits_begun);
    let short = at_least.map_or(0, |n| n.saturating_sub(1));
    for (now, pair) in (0..).zip(path.windows(2)) {
        if is_asked(now, pair) {
            run += 1;
            gone += u32::from(run > short);
        } else {
            run = 0;
        }
    }
    gone
}
