//! Sentences about costs, answers to questions, orders and methods.

use giveway_model::Cost;
use giveway_model::words::{and, count, name, value};
use giveway_solve::change::Method;
use giveway_solve::explain;

use crate::lesson::Comparison;

pub(super) fn cost(cost: Cost, n: u32, compare: Comparison, wanted: u32, solved: bool) -> String {
    let found = value(cost, n);
    if solved {
        return format!("the best plan has {found}.");
    }
    let asked = match compare {
        Comparison::Equal => format!("exactly {wanted}"),
        Comparison::AtMost => format!("at most {wanted}"),
        Comparison::AtLeast => format!("at least {wanted}"),
    };
    format!("the best plan has {found}; {asked} is asked for.")
}

pub(super) fn raised(cost: Cost, before: u32, now: u32, by: u32, solved: bool) -> String {
    let what = name(cost);
    match (solved, before == now) {
        (true, _) => format!("the best {what} went from {before} to {now}."),
        (false, true) => format!("the best {what} is still {now}."),
        (false, false) => {
            let wanted = before.saturating_add(by);
            format!("the best {what} went from {before} to {now}; {wanted} is asked for.")
        }
    }
}

pub(super) fn answered(
    verdict: explain::Verdict,
    wanted: explain::Verdict,
    solved: bool,
) -> String {
    let word = |verdict| match verdict {
        explain::Verdict::Needless => "needless",
        explain::Verdict::Improvable => "a mistake of the plan",
        explain::Verdict::Costly => "costly to do without",
        explain::Verdict::Necessary => "necessary",
        explain::Verdict::Unknown => "not known",
    };
    if solved {
        format!("now it is {}.", word(verdict))
    } else {
        format!("it is {}, not {}.", word(verdict), word(wanted))
    }
}

pub(super) fn order_works(cost: Cost, n: u32, best: Option<u32>) -> String {
    let found = value(cost, n);
    match best {
        None => format!("this order gives a plan, {found}."),
        Some(best) if best == n => format!("this order gives a plan with the best {found}."),
        Some(best) => format!("this order gives a plan with {found}; the best has {best}."),
    }
}

pub(super) fn went(
    method: Method,
    cost: Option<(Cost, u32, u32)>,
    kept: u32,
    wanted: Option<u32>,
) -> String {
    let who = method_name(method);
    let mut parts = Vec::new();
    if let Some((cost, n, at_most)) = cost {
        let asked = if n > at_most {
            format!(" (at most {at_most} is asked for)")
        } else {
            String::new()
        };
        parts.push(format!("has {}{asked}", value(cost, n)));
    }
    let asked = match wanted {
        Some(wanted) if kept < wanted => format!(" (at least {wanted} is asked for)"),
        _ => String::new(),
    };
    parts.push(format!("keeps {} as planned{asked}", count(kept, "robot")));
    format!("{who} {}.", and(&parts))
}

pub(super) fn method_name(method: Method) -> String {
    match method {
        Method::Revise => "revising".to_owned(),
        Method::Tunnel(width) => format!("a tunnel of width {width}"),
        Method::Replan => "replanning".to_owned(),
    }
}
