//! What there is to say of a person's own plan.

use giveway_model::words::{and, count};
use giveway_model::{Cost, Costs, Objective};

use super::costs::instead;
use crate::explain::{answer::Excess, own_plan::Judged};

/// The most violations and agents that are told one by one.
const MOST: usize = 3;

/// A judgement in words.
///
/// The costs of the plan and of the better one are those of the whole.
pub(crate) fn own_plan(
    judged: &Judged,
    objective: &Objective,
    costs: &Costs,
    least: Option<&Costs>,
) -> String {
    if let Some(broken) = broken(judged) {
        return broken;
    }
    match (least, judged.optimal) {
        (Some(least), _) => better(judged, objective, least, costs),
        (None, Some(true)) => "The plan keeps all rules, and no plan is better.".to_owned(),
        (None, _) => "The plan keeps all rules. The search ended before it was known whether \
                      there is a better one."
            .to_owned(),
    }
}

fn broken(judged: &Judged) -> Option<String> {
    let first = judged.violations.first()?;
    let rest = judged.violations.len() - 1;
    let more = match rest {
        0 => String::new(),
        1 => " There is one more violation.".to_owned(),
        more => format!(" There are {more} more violations."),
    };
    Some(format!("The plan breaks a rule: {}{more}", first.message))
}

fn better(judged: &Judged, objective: &Objective, least: &Costs, costs: &Costs) -> String {
    let instead = instead(objective, least, costs);
    let mut text = format!("The plan keeps all rules, but there is a better one: {instead}.");
    let mut phrases: Vec<String> = judged.excess.iter().map(phrase).collect();
    if phrases.len() > MOST {
        let more = phrases.len() - MOST;
        phrases.truncate(MOST);
        phrases.push(match more {
            1 => "there is one more saving".to_owned(),
            more => format!("there are {more} more savings"),
        });
    }
    if !phrases.is_empty() {
        text = format!("{text} In it {}.", and(&phrases));
    }
    text
}

fn phrase(excess: &Excess) -> String {
    let (agent, by) = (&excess.agent, excess.by);
    match excess.cost {
        Cost::Charges => format!("{agent} makes {}", count(by, "fewer charge")),
        Cost::Moves => format!("{agent} makes {}", count(by, "fewer move")),
        Cost::Waits => format!("{agent} waits {} less", count(by, "step")),
        Cost::Makespan | Cost::SumOfCosts => {
            format!("{agent} arrives {} sooner", count(by, "step"))
        }
    }
}
