//! The order of a plan as text.

use std::fmt::Write as _;

use giveway_model::{Cell, Instance, Plan};
use giveway_order::{Link, Order, Outcome, words};
use giveway_solve::order::OrderAnswer;

use super::{bold, drawings, solve::work, title};
use crate::output::plain;

/// What is said of the order, who passes each cell in turn, and what follows from lateness.
pub(crate) fn order(
    instance: &Instance,
    plan: Option<&Plan>,
    answer: &OrderAnswer,
    columns: usize,
) -> String {
    let mut parts = vec![title(instance), known(answer)];
    if answer.costs.is_some() && answer.order.is_some() {
        parts.push(drawings(instance, plan.or(answer.plan.as_ref()), columns));
    }
    parts.extend(answer.order.as_ref().map(cells));
    parts.extend(answer.late.as_ref().map(late));
    parts.push(work(&answer.stats));
    parts.retain(|part| !part.is_empty());
    parts.join("\n")
}

/// The order in sentences.
fn known(answer: &OrderAnswer) -> String {
    let mut text = format!("{}\n", bold("In which order?"));
    match &answer.order {
        None => {
            let _ = writeln!(text, "{}", plain::text(&answer.words));
        }
        Some(order) => {
            let losses = words::losses(&answer.losses);
            for sentence in words::all(order).into_iter().chain(losses) {
                let _ = writeln!(text, "{}", plain::text(&sentence));
            }
        }
    }
    text
}

/// A line for each cell that several robots pass: who comes after whom, with the slack.
fn cells(order: &Order) -> String {
    if order.links.is_empty() {
        return String::new();
    }
    let mut lines: Vec<(Cell, String)> = Vec::new();
    let mut last: Option<&Link> = None;
    for link in &order.links {
        let slack = link.slack;
        let second = format!("{} ({slack})", link.second.agent);
        let follows = last.is_some_and(|it| it.cell == link.cell);
        match lines.last_mut().filter(|_| follows) {
            Some((_, line)) => {
                // A robot that came again by itself in between is named once more.
                let is_next = last.is_some_and(|it| it.second.agent == link.first.agent);
                if !is_next {
                    let _ = write!(line, ", {}", link.first.agent);
                }
                let _ = write!(line, ", {second}");
            }
            None => lines.push((link.cell, format!("{}, {second}", link.first.agent))),
        }
        last = Some(link);
    }
    let width = lines.iter().map(|(cell, _)| cell.to_string().len());
    let width = width.max().unwrap_or(0);
    let mut text = format!("{}\n", bold("Who passes each cell, with the slack before"));
    for (cell, line) in lines {
        let _ = writeln!(
            text,
            "  {:<width$}  {}",
            cell.to_string(),
            plain::text(&line)
        );
    }
    text
}

/// What follows from lateness, and when each robot arrives.
fn late(outcome: &Outcome) -> String {
    let mut text = format!("{}\n", bold("What if a robot is late?"));
    for sentence in words::outcome(outcome) {
        let _ = writeln!(text, "{}", plain::text(&sentence));
    }
    let names = outcome
        .arrivals
        .iter()
        .map(|it| plain::text(&it.agent).chars().count());
    let width = names.max().unwrap_or(0).max("arrives".len());
    let _ = writeln!(text, "  {:width$} {:>8} {:>5}", "arrives", "planned", "now");
    for it in &outcome.arrivals {
        let now = it.now.map_or("-".to_owned(), |now| now.to_string());
        let later = it.now.map_or(0, |now| now.saturating_sub(it.planned));
        let later = if later > 0 {
            format!("  +{later}")
        } else {
            String::new()
        };
        let name = plain::text(&it.agent);
        let _ = writeln!(text, "  {name:width$} {:>8} {now:>5}{later}", it.planned);
    }
    text
}
