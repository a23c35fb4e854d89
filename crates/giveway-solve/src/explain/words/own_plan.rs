//! What there is to say of a person's own plan.

use giveway_model::{Cost, Costs, Objective};

use super::{
    costs::instead,
    list::{and, count},
};
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
        (None, _) => "The plan keeps all rules; whether there is a better one was not found \
                      out in time."
            .to_owned(),
    }
}

fn broken(judged: &Judged) -> Option<String> {
    let first = judged.violations.first()?;
    let rest = judged.violations.len() - 1;
    let more = match rest {
        0 => String::new(),
        1 => " It breaks another rule, too.".to_owned(),
        more => format!(" It breaks {more} rules more."),
    };
    Some(format!(
        "The plan is not all right: {}{more}",
        first.message
    ))
}

fn better(judged: &Judged, objective: &Objective, least: &Costs, costs: &Costs) -> String {
    let instead = instead(objective, least, costs);
    let mut text = format!("The plan keeps all rules, but there is a better one: {instead}.");
    let mut phrases: Vec<String> = judged.excess.iter().map(phrase).collect();
    if phrases.len() > MOST {
        let more = count((phrases.len() - MOST) as u32, "thing", "things");
        phrases.truncate(MOST);
        phrases.push(format!("there are {more} more that need not be"));
    }
    if !phrases.is_empty() {
        text = format!("{text} In it {}.", and(&phrases));
    }
    text
}

fn phrase(excess: &Excess) -> String {
    let (agent, by) = (&excess.agent, excess.by);
    match excess.cost {
        Cost::Charges => format!("{agent} charges {} less", count(by, "time", "times")),
        Cost::Moves => format!("{agent} makes {} less", count(by, "move", "moves")),
        Cost::Waits => format!("{agent} waits {} less", count(by, "step", "steps")),
        Cost::Makespan | Cost::SumOfCosts => {
            format!("{agent} arrives {} sooner", count(by, "step", "steps"))
        }
    }
}
