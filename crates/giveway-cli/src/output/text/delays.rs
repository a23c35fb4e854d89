//! The answer to the question `delays` as text.

use std::fmt::Write as _;

use giveway_model::{Instance, Plan};
use giveway_solve::delays::{AgentDelay, DelaysAnswer, words};
use giveway_solve::words::reach;

use super::{bold, drawings, solve::work, title};
use crate::output::plain;

/// The sum, who loses how much because of whom, who costs others, and where most is lost.
pub(crate) fn delays(
    instance: &Instance,
    plan: Option<&Plan>,
    answer: &DelaysAnswer,
    columns: usize,
) -> String {
    let mut parts = vec![title(instance), known(answer)];
    if answer.since.is_none() && answer.costs.is_some() {
        parts.push(drawings(instance, plan.or(answer.plan.as_ref()), columns));
    }
    parts.push(table(answer));
    parts.push(costs_others(answer));
    parts.push(places(answer));
    parts.push(work(&answer.stats));
    parts.retain(|part| !part.is_empty());
    parts.join("\n")
}

/// The sum of all delays, and what is proved of it.
fn known(answer: &DelaysAnswer) -> String {
    let mut text = format!("{}\n", bold("Who costs whom?"));
    if answer.costs.is_none() || answer.reason.is_some() {
        let _ = writeln!(text, "{}", plain::text(&answer.words));
        return text;
    }
    if let Some(since) = answer.since {
        let _ = writeln!(text, "This is about the plan from time {since} on.");
    }
    let _ = writeln!(text, "{}", words::total(answer));
    if let Some(proof) = words::proof(answer) {
        let _ = writeln!(text, "{proof}");
    }
    let of_proof = answer.proof.as_ref().filter(|proof| proof.at_least > 0);
    if let Some(reach) = of_proof.and_then(|proof| reach(proof.reach)) {
        let _ = writeln!(text, "{reach}");
    }
    text
}

/// A line for each robot that loses steps; the others are counted.
fn table(answer: &DelaysAnswer) -> String {
    let losers: Vec<&AgentDelay> = answer.agents.iter().filter(|row| row.delay > 0).collect();
    if losers.is_empty() {
        return String::new();
    }
    let width = losers
        .iter()
        .map(|row| plain::text(&row.agent).chars().count());
    let width = width.max().unwrap_or(0);
    let mut text = format!(
        "{}\n",
        bold("Who loses steps, because of whom on its best way alone")
    );
    for row in losers {
        let each = match row.because.as_slice() {
            [first, _, ..] => format!(", {} each", first.steps),
            _ => String::new(),
        };
        let _ = writeln!(
            text,
            "  {:width$} {:>5}  {}{each} (arrives at {}, alone at {})",
            plain::text(&row.agent),
            row.delay,
            plain::text(&words::causes(&row.because)),
            row.arrival,
            row.alone,
        );
    }
    if let Some(sentence) = words::unharmed(answer) {
        let _ = writeln!(text, "  {sentence}");
    }
    text
}

/// Who costs all others how much.
fn costs_others(answer: &DelaysAnswer) -> String {
    if answer.because.is_empty() {
        return String::new();
    }
    let totals: Vec<String> = answer.because.iter().map(words::cost).collect();
    let totals = plain::text(&totals.join(", "));
    format!("{}\n  {totals}\n", bold("Who costs others"))
}

/// Where most is lost.
fn places(answer: &DelaysAnswer) -> String {
    if answer.places.is_empty() {
        return String::new();
    }
    let mut text = format!("{}\n", bold("Where most is lost"));
    for (place, number) in answer.places.iter().zip(0..) {
        let sentence = words::place(place, number == 0);
        let _ = writeln!(text, "  {}", plain::text(&sentence));
    }
    text
}
