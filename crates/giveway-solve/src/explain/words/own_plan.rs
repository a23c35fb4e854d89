//! The findings about a person's own plan, in words.

use giveway_model::words::and;
use giveway_model::{Cost, Costs, Objective, tr};

use super::costs::instead;
use crate::explain::{answer::Excess, own_plan::OwnPlanReport};

/// The most violations and agents that are told one by one.
const MOST: usize = 3;

/// A judgement in words.
///
/// The costs of the plan and of the better one are those of the whole; `within` is the
/// makespan up to which no plan is better, `None` for any.
pub(crate) fn own_plan(
    judged: &OwnPlanReport,
    objective: &Objective,
    costs: &Costs,
    least: Option<&Costs>,
    within: Option<u32>,
) -> String {
    if let Some(broken) = broken(judged) {
        return broken;
    }
    match (least, judged.optimal, within) {
        (Some(least), ..) => better(judged, objective, least, costs),
        (None, Some(true), None) => {
            tr!("The plan keeps all rules, and no plan is better.").to_owned()
        }
        (None, Some(true), Some(n)) => tr!(
            "The plan keeps all rules, and no plan of makespan at most {n} is better.",
            n
        ),
        (None, ..) => tr!(
            "The plan keeps all rules. The search ended before it was known whether \
                      there is a better one."
        )
        .to_owned(),
    }
}

fn broken(judged: &OwnPlanReport) -> Option<String> {
    let first = judged.violations.first()?;
    let rest = judged.violations.len() - 1;
    let more = match rest {
        0 => String::new(),
        more => tr!(" There is one more violation." | " There are {n} more violations." % more),
    };
    Some(tr!(
        "The plan breaks a rule: {message}{more}",
        message = first.message,
        more
    ))
}

fn better(judged: &OwnPlanReport, objective: &Objective, least: &Costs, costs: &Costs) -> String {
    let instead = instead(objective, least, costs);
    let mut text = tr!(
        "The plan keeps all rules, but there is a better one: {instead}.",
        instead
    );
    let mut phrases: Vec<String> = judged.excess.iter().map(phrase).collect();
    if phrases.len() > MOST {
        let more = phrases.len() - MOST;
        phrases.truncate(MOST);
        phrases.push(tr!(
            "there is one more saving" | "there are {n} more savings" % more
        ));
    }
    if !phrases.is_empty() {
        text = tr!("{text} In it {savings}.", text, savings = and(&phrases));
    }
    text
}

fn phrase(excess: &Excess) -> String {
    let (agent, by) = (&excess.agent, excess.by);
    match excess.cost {
        Cost::Charges => tr!(
            "{agent} makes {n} fewer charge" | "{agent} makes {n} fewer charges" % by,
            agent
        ),
        Cost::Moves => tr!(
            "{agent} makes {n} fewer move" | "{agent} makes {n} fewer moves" % by,
            agent
        ),
        Cost::Penalty => tr!("{agent} has a penalty that is {by} less", agent, by),
        Cost::Waits => tr!(
            "{agent} waits {n} step less" | "{agent} waits {n} steps less" % by,
            agent
        ),
        Cost::Makespan | Cost::SumOfCosts => {
            tr!(
                "{agent} arrives {n} step sooner" | "{agent} arrives {n} steps sooner" % by,
                agent
            )
        }
    }
}
