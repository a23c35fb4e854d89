//! Sentences about costs, answers to questions, orders and methods.

use giveway_model::words::{and, name, value};
use giveway_model::{Cost, tr};
use giveway_solve::change::Method;
use giveway_solve::explain;

use crate::lesson::{Comparison, Value};

pub(super) fn cost(cost: Cost, n: u32, compare: Comparison, wanted: u32, solved: bool) -> String {
    let cost = value(cost, n);
    match compare {
        _ if solved => tr!("the best plan has {cost}.", cost),
        Comparison::Equal => tr!(
            "the best plan has {cost}; exactly {wanted} is asked for.",
            cost,
            wanted
        ),
        Comparison::AtMost => tr!(
            "the best plan has {cost}; at most {wanted} is asked for.",
            cost,
            wanted
        ),
        Comparison::AtLeast => tr!(
            "the best plan has {cost}; at least {wanted} is asked for.",
            cost,
            wanted
        ),
    }
}

pub(super) fn raised(cost: Cost, before: u32, now: u32, by: u32, solved: bool) -> String {
    let cost = name(cost);
    match (solved, before == now) {
        (true, _) => tr!(
            "the best {cost} went from {before} to {now}.",
            cost,
            before,
            now
        ),
        (false, true) => tr!("the best {cost} is still {now}.", cost, now),
        (false, false) => tr!(
            "the best {cost} went from {before} to {now}; {wanted} is asked for.",
            cost,
            before,
            now,
            wanted = before.saturating_add(by)
        ),
    }
}

pub(super) fn price(rule: u32, cost: Cost, with: u32, without: u32) -> String {
    let (rule, cost) = (Value::Rule { rule }, name(cost));
    if with == without {
        tr!(
            "{rule} costs nothing: the best {cost} is {with}, with it and without it.",
            rule,
            cost,
            with
        )
    } else {
        tr!(
            "{rule} costs {n}: the best {cost} is {with} with it, and {without} without it.",
            rule,
            n = with.saturating_sub(without),
            cost,
            with,
            without
        )
    }
}

pub(super) fn answered(
    verdict: explain::Verdict,
    wanted: explain::Verdict,
    solved: bool,
) -> String {
    let word = |verdict| match verdict {
        explain::Verdict::Needless => tr!("it is" => "needless"),
        explain::Verdict::Improvable => tr!("it is" => "a mistake of the plan"),
        explain::Verdict::Costly => tr!("it is" => "costly to do without"),
        explain::Verdict::Necessary => tr!("it is" => "necessary"),
        explain::Verdict::Unknown => tr!("it is" => "not known"),
    };
    let is = word(verdict);
    if solved {
        tr!("now it is {is}.", is)
    } else {
        tr!("it is {is}, not {wanted}.", is, wanted = word(wanted))
    }
}

pub(super) fn order_works(cost: Cost, n: u32, best: Option<u32>) -> String {
    let cost = value(cost, n);
    match best {
        None => tr!("this order gives a plan, {cost}.", cost),
        Some(best) if best == n => tr!("this order gives a plan with the best {cost}.", cost),
        Some(best) => tr!(
            "this order gives a plan with {cost}; the best has {best}.",
            cost,
            best
        ),
    }
}

pub(super) fn went(
    method: Method,
    cost: Option<(Cost, u32, u32)>,
    kept: u32,
    wanted: Option<u32>,
) -> String {
    let mut parts = Vec::new();
    if let Some((cost, n, at_most)) = cost {
        let cost = value(cost, n);
        parts.push(if n > at_most {
            tr!(
                "of a method" => "has {cost} (at most {most} is asked for)",
                cost,
                most = at_most
            )
        } else {
            tr!("of a method" => "has {cost}", cost)
        });
    }
    parts.push(match wanted {
        Some(wanted) if kept < wanted => tr!(
            "of a method" => "keeps {n} robot as planned (at least {wanted} is asked for)"
                | "keeps {n} robots as planned (at least {wanted} is asked for)" % kept,
            wanted
        ),
        _ => {
            tr!("of a method" => "keeps {n} robot as planned" | "keeps {n} robots as planned" % kept)
        }
    });
    tr!(
        "{method} {does}.",
        method = method_name(method),
        does = and(&parts)
    )
}

pub(super) fn method_name(method: Method) -> String {
    match method {
        Method::Revise => tr!("who goes on" => "revising").to_owned(),
        Method::Tunnel(width) => tr!("who goes on" => "a tunnel of width {width}", width),
        Method::Replan => tr!("who goes on" => "replanning").to_owned(),
    }
}
