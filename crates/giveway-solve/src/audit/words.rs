//! What is known of a plan, in sentences: one text for the page and the command.

use giveway_model::words::{count, name, sentence, values};
use giveway_model::{Cost, Costs};

use super::{AuditAnswer, AuditStatus};
use crate::Status;
use crate::words::{FOR_EVER, Headline};

/// How far a cost is above a bound, in percent with one decimal, rounded up;
/// `None` where the bound is 0 and the cost is not.
///
/// ```
/// use giveway_solve::audit::words::percent;
/// assert_eq!(percent(1001, 1000).as_deref(), Some("0.1 %"));
/// assert_eq!(percent(1002, 990).as_deref(), Some("1.3 %"));
/// assert_eq!(percent(5, 5).as_deref(), Some("0.0 %"));
/// assert_eq!(percent(5, 0), None);
/// ```
pub fn percent(cost: u32, bound: u32) -> Option<String> {
    let beyond = u64::from(cost.saturating_sub(bound));
    let tenths = match (beyond, bound) {
        (0, _) => 0,
        (_, 0) => return None,
        _ => (beyond * 1000).div_ceil(u64::from(bound)),
    };
    Some(format!("{}.{} %", tenths / 10, tenths % 10))
}

/// The verdict in one sentence. It begins with words that may be made bold.
pub fn headline(answer: &AuditAnswer) -> Headline {
    let (word, rest) = match answer.status {
        AuditStatus::Illegal => ("Illegal", illegal(answer)),
        AuditStatus::Optimal => ("The best", format!(": proved{}.", reach(answer))),
        AuditStatus::Unknown => (
            "Legal",
            ". Nothing is known yet of how good it is.".to_owned(),
        ),
        AuditStatus::Feasible => return feasible(answer),
    };
    Headline {
        word: word.to_owned(),
        rest,
    }
}

fn illegal(answer: &AuditAnswer) -> String {
    let violations = count(answer.violations.len(), "violation");
    format!(": {violations} of the rules.")
}

fn feasible(answer: &AuditAnswer) -> Headline {
    let say = |word: String, rest: String| Headline { word, rest };
    let Some((cost, own, bound)) = first(answer) else {
        return say("Legal".to_owned(), ".".to_owned());
    };
    let (among, called) = (among(answer), name(cost));
    let is_reached = best_known(answer).is_some_and(|best| best.get(cost) == bound);
    let above = match percent(own, bound) {
        _ if own == bound => {
            let word = format!("The best {called}");
            return say(word, format!(": proved{}.{}", reach(answer), later(answer)));
        }
        Some(percent) => format!("{percent} above the best"),
        None => format!("{} above the best", own - bound),
    };
    if is_reached {
        let of_those = reach(answer);
        let rest = format!(": its {called} is {own}, and the least is {bound}{of_those}.");
        say(above, rest)
    } else {
        let rest = format!(": its {called} is {own}, and no plan{among} has less than {bound}.");
        say(format!("At most {above}"), rest)
    }
}

/// What is known of the costs after the first one, where that is at its bound.
fn later(answer: &AuditAnswer) -> String {
    let Some(own) = &answer.costs else {
        return String::new();
    };
    for &cost in answer.objective.costs().iter().skip(1) {
        let (n, called) = (own.get(cost), name(cost));
        match answer.bounds.get(&cost) {
            Some(&bound) if bound == n => {}
            Some(&bound) if best_known(answer).is_some_and(|best| best.get(cost) == bound) => {
                return format!(" Its {called} is {n}, and the least of those plans {bound}.");
            }
            Some(&bound) => {
                return format!(
                    " Its {called} is {n}, and of those plans none has less than {bound}."
                );
            }
            None => return format!(" Of its {called}, {n}, nothing is proved yet."),
        }
    }
    String::new()
}

/// What else is to be said, a sentence each.
pub fn notes(answer: &AuditAnswer) -> Vec<String> {
    let mut notes = Vec::new();
    if answer.status == AuditStatus::Illegal
        && let Some((cost, own, bound)) = first(answer)
        && own < bound
    {
        notes.push(format!(
            "Its {} is {own}, and every legal plan{} has at least {bound}. So it had to break a rule.",
            name(cost),
            among(answer)
        ));
    }
    match (&answer.better_costs, answer.legal) {
        (Some(better), legal) => {
            let kind = if legal { "better" } else { "legal" };
            let costs = values(answer.objective.costs(), better);
            let proved = if answer.search == Status::Optimal {
                format!("; it is the best: proved{}", reach(answer))
            } else {
                String::new()
            };
            notes.push(format!("A {kind} plan was found: {costs}{proved}."));
        }
        (None, false) if answer.search == Status::Impossible => {
            let reach = match answer.within {
                Some(n) if !answer.complete => format!("within makespan {n}"),
                _ => FOR_EVER.to_owned(),
            };
            notes.push(format!("There is no legal plan, {reach}."));
        }
        _ => {}
    }
    notes.extend(answer.reason.as_deref().map(sentence));
    notes
}

/// The first cost of the objective: what the plan has of it, and the bound.
fn first(answer: &AuditAnswer) -> Option<(Cost, u32, u32)> {
    let cost = answer.first_cost()?;
    let own = answer.costs.as_ref()?.get(cost);
    Some((cost, own, *answer.bounds.get(&cost)?))
}

/// The costs of the best plan that is known.
const fn best_known(answer: &AuditAnswer) -> Option<&Costs> {
    match &answer.better_costs {
        None if answer.legal => answer.costs.as_ref(),
        better => better.as_ref(),
    }
}

/// Up to where something is proved: `, among plans of makespan at most 40`.
fn reach(answer: &AuditAnswer) -> String {
    match among(answer).as_str() {
        "" => String::new(),
        among => format!(", among plans{among}"),
    }
}

/// Among which plans, where not all: ` of makespan at most 40`.
fn among(answer: &AuditAnswer) -> String {
    match answer.within {
        Some(within) if !answer.complete => format!(" of makespan at most {within}"),
        _ => String::new(),
    }
}
