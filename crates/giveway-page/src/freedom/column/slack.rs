//! Who may be late.

use giveway_model::{Cost, sorting, tr};
use giveway_solve::freedom::{FreedomAnswer, Hold, Slack};

use super::{Freedom, MOST, Row};

/// Who may be late.
#[derive(Clone, Debug, PartialEq)]
pub struct Late {
    /// A line each, whoever may be latest first.
    pub rows: Vec<Row>,
    /// In the place of lines where nobody may.
    pub nobody: Option<String>,
}

pub(super) fn late(freedom: &Freedom, told: &FreedomAnswer) -> Option<Late> {
    let slacks = told.slack.as_ref()?;
    let mut all: Vec<(u32, Row)> = Vec::new();
    for (agent, name) in freedom.names() {
        let Some(slack) = slacks.get(name) else {
            continue;
        };
        let Some(hold) = slack.late() else { continue };
        let row = Row {
            agent,
            title: sentence(told, freedom, (agent, name), hold),
            detail: detail(told, freedom, agent, slack),
            value: String::new(),
            is_fixed: hold == Hold::Steps(0),
        };
        let rank = match hold {
            Hold::Steps(steps) => steps,
            Hold::Unlimited | Hold::InTransit => u32::MAX,
        };
        all.push((u32::MAX - rank, row));
    }
    let first = told.objective.costs().first().copied();
    let is_nobody = all
        .iter()
        .all(|(_, row)| row.is_fixed && row.detail.is_empty());
    if is_nobody && first != Some(Cost::Makespan) {
        let why = match first {
            Some(Cost::SumOfCosts) => tr!(" Each step late adds to the sum of costs."),
            Some(Cost::Waits) => tr!(" Each step late is a wait more."),
            _ => "",
        };
        return Some(Late {
            rows: Vec::new(),
            nobody: Some(tr!("No robot has slack.{why}", why)),
        });
    }
    // Equal ones stay in the order of the scene.
    sorting::sort_by_key(&mut all, |(rank, row)| (*rank, row.agent));
    Some(Late {
        rows: all.into_iter().map(|(_, row)| row).take(MOST).collect(),
        nobody: None,
    })
}

/// Whether a robot arrives last where the makespan comes first.
fn decides(told: &FreedomAnswer, freedom: &Freedom, agent: usize) -> bool {
    let arrival = freedom.about.arrivals.get(agent).copied().flatten();
    let is_first = told.objective.costs().first() == Some(&Cost::Makespan);
    is_first && arrival.is_some() && arrival == told.costs.map(|costs| costs.makespan)
}

/// `A1 could be 3 steps late without harm`.
pub(in crate::freedom) fn sentence(
    told: &FreedomAnswer,
    freedom: &Freedom,
    (agent, name): (usize, &str),
    hold: Hold,
) -> String {
    match hold {
        Hold::Steps(0) if decides(told, freedom, agent) => tr!("{name} decides the makespan", name),
        Hold::Steps(0) => tr!("{name} could not be late without harm", name),
        Hold::Steps(steps) => {
            tr!(
                "{name} could be {n} step late without harm"
                    | "{name} could be {n} steps late without harm" % steps,
                name
            )
        }
        Hold::Unlimited | Hold::InTransit => {
            tr!("{name} could be late by any number of steps", name)
        }
    }
}

/// `one step late makes it 9`, or how late it is in another best plan.
pub(in crate::freedom) fn detail(
    told: &FreedomAnswer,
    freedom: &Freedom,
    agent: usize,
    slack: &Slack,
) -> String {
    let later = slack.arrival.number();
    if later > 0 {
        return tr!("in another best plan it arrives {n} step later"
            | "in another best plan it arrives {n} steps later" % later);
    }
    let makespan = told.costs.map(|costs| costs.makespan);
    match makespan.filter(|_| decides(told, freedom, agent)) {
        Some(makespan) => tr!("one step late makes it {makespan}", makespan = makespan + 1),
        None => String::new(),
    }
}
