//! The verdict of an audit in sentences: one text for the page and the command.

use giveway_model::words::{name, sentence, values};
use giveway_model::{Assumption, Cost, Costs, assumption::left_out, tr};

use super::{AuditAnswer, AuditStatus};
use crate::Status;
use crate::words::{Headline, reason};

/// How far a cost is above the best one, in percent with one decimal.
///
/// Where a plan reaches the bound, the bound is the best, and the exact value is rounded to
/// the nearest; it has as many decimals as it takes not to be nothing. Otherwise the best
/// may be above the bound, and the value is a most: it is rounded up. `None` where the
/// bound is 0 and the cost is not.
///
/// ```
/// use giveway_solve::audit::words::percent;
/// assert_eq!(percent(4, 3, true).as_deref(), Some("33.3 %"));
/// assert_eq!(percent(4, 3, false).as_deref(), Some("33.4 %"));
/// assert_eq!(percent(5, 4, false).as_deref(), Some("25.0 %"));
/// assert_eq!(percent(5, 5, false).as_deref(), Some("0.0 %"));
/// assert_eq!(percent(10_001, 10_000, true).as_deref(), Some("0.01 %"));
/// assert_eq!(percent(5, 0, true), None);
/// ```
pub fn percent(cost: u32, bound: u32, is_reached: bool) -> Option<String> {
    let (beyond, bound) = (u64::from(cost.saturating_sub(bound)), u64::from(bound));
    if bound == 0 && beyond > 0 {
        return None;
    }
    let bound = bound.max(1);
    // (Only what is far below the bound takes more digits, so nothing overflows.)
    let (mut digits, mut one) = (1, 10);
    let scaled = loop {
        let scaled = if is_reached {
            (200 * one * beyond + bound) / (2 * bound)
        } else {
            (100 * one * beyond).div_ceil(bound)
        };
        if scaled > 0 || beyond == 0 {
            break scaled;
        }
        (digits, one) = (digits + 1, 10 * one);
    };
    Some(format!(
        "{}{}{:0digits$} %",
        scaled / one,
        tr!("decimal mark" => "."),
        scaled % one
    ))
}

/// The verdict on a plan of a scene that takes something for granted.
pub fn headline_under(answer: &AuditAnswer, assumptions: &[Assumption]) -> Headline {
    let head = headline(answer);
    if answer.status != AuditStatus::Optimal {
        return head;
    }
    let is_chosen = assumptions.contains(&Assumption::GoalsChosen);
    // The judge leaves some rules out, so the plan itself may break them.
    let word = match (left_out(assumptions).is_some(), is_chosen) {
        (true, true) => tr!("an audit" => "No plan costs less for the goals chosen"),
        (true, false) => tr!("an audit" => "No plan costs less"),
        (false, true) => tr!("an audit" => "The best for the goals chosen"),
        (false, false) => return head,
    };
    Headline {
        word: word.to_owned(),
        ..head
    }
}

/// The verdict in one sentence. It begins with words that may be made bold.
pub fn headline(answer: &AuditAnswer) -> Headline {
    let (word, rest) = match answer.status {
        AuditStatus::Illegal => (tr!("an audit" => "Illegal"), illegal(answer)),
        AuditStatus::Optimal => (
            tr!("an audit" => "The best"),
            tr!("an audit" => ": proved{reach}.", reach = reach(answer)),
        ),
        AuditStatus::Unknown => (
            tr!("an audit" => "Legal"),
            tr!(". Nothing is known yet of how good it is.").to_owned(),
        ),
        AuditStatus::Feasible => return feasible(answer),
    };
    Headline {
        word: word.to_owned(),
        rest,
    }
}

fn illegal(answer: &AuditAnswer) -> String {
    tr!(
        "behind: Illegal" => ": {n} violation of the rules." | ": {n} violations of the rules."
            % answer.violations.len()
    )
}

fn feasible(answer: &AuditAnswer) -> Headline {
    let say = |word: String, rest: String| Headline { word, rest };
    let Some((cost, own, bound)) = first(answer) else {
        return say(tr!("an audit" => "Legal").to_owned(), ".".to_owned());
    };
    let (among, called) = (among(answer), name(cost));
    let is_reached = best_known(answer).is_some_and(|best| best.get(cost) == bound);
    let above = match percent(own, bound, is_reached) {
        _ if own == bound => {
            let word = tr!("an audit" => "The best {cost}", cost = called);
            return say(
                word,
                tr!(
                    "an audit" => ": proved{reach}.{later}",
                    reach = reach(answer),
                    later = later(answer)
                ),
            );
        }
        Some(percent) => tr!("{percent} above the best", percent),
        None => tr!("{bound} above the best", bound = own - bound),
    };
    if is_reached {
        let of_those = reach(answer);
        let rest = tr!(
            ": its {cost} is {own}, and the least is {bound}{of_those}.",
            cost = called,
            own,
            bound,
            of_those
        );
        say(above, rest)
    } else {
        let rest = tr!(
            ": its {cost} is {own}, and no plan{among} has less than {bound}.",
            cost = called,
            own,
            among,
            bound
        );
        say(tr!("At most {above}", above), rest)
    }
}

/// Bounds of the costs after the first one, where the first is at its bound.
fn later(answer: &AuditAnswer) -> String {
    let Some(own) = &answer.costs else {
        return String::new();
    };
    for &cost in answer.objective.costs().iter().skip(1) {
        let (n, called) = (own.get(cost), name(cost));
        match answer.bounds.get(&cost) {
            Some(&bound) if bound == n => {}
            Some(&bound) if best_known(answer).is_some_and(|best| best.get(cost) == bound) => {
                return tr!(
                    " Its {cost} is {n}, and the least of those plans {bound}.",
                    cost = called,
                    n,
                    bound
                );
            }
            Some(&bound) => {
                return tr!(
                    " Its {cost} is {n}, and of those plans none has less than {bound}.",
                    cost = called,
                    n,
                    bound
                );
            }
            None => {
                return tr!(
                    " Of its {cost}, {n}, nothing is proved yet.",
                    cost = called,
                    n
                );
            }
        }
    }
    String::new()
}

/// Further remarks, a sentence each.
pub fn notes(answer: &AuditAnswer) -> Vec<String> {
    let mut notes = Vec::new();
    if answer.status == AuditStatus::Illegal
        && let Some((cost, own, bound)) = first(answer)
        && own < bound
    {
        notes.push(tr!("Its {cost} is {own}, and every legal plan{among} has at least {bound}. So it had to break a rule.", cost = name(cost), own, among = among(answer), bound));
    }
    match (&answer.better_costs, answer.legal) {
        (Some(better), legal) => {
            let costs = values(answer.objective.costs(), better);
            let proved = if answer.search == Status::Optimal {
                tr!("; it is the best: proved{reach}", reach = reach(answer))
            } else {
                String::new()
            };
            notes.push(if legal {
                tr!("A better plan was found: {costs}{proved}.", costs, proved)
            } else {
                tr!("A legal plan was found: {costs}{proved}.", costs, proved)
            });
        }
        (None, false) if answer.search == Status::Impossible => {
            notes.push(match answer.reach.within() {
                Some(n) => {
                    tr!("There is no legal plan, within makespan {n}.", n)
                }
                _ => tr!("There is no legal plan, no matter how many steps you allow.").to_owned(),
            });
        }
        _ => {}
    }
    notes.extend(answer.reason.as_ref().map(|given| sentence(&reason(given))));
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
        among => tr!(", among plans{among}", among),
    }
}

/// Among which plans, where not all: ` of makespan at most 40`.
fn among(answer: &AuditAnswer) -> String {
    match answer.reach.within() {
        Some(within) => tr!(" of makespan at most {within}", within),
        _ => String::new(),
    }
}
